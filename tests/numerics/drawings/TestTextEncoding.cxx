#include "TextEncoding.h"

#include "DrawingChecks.h"
#include "DrawingFormats.h"
#include "Support.h"

namespace crossfield::test
{
namespace
{
TEST(TextEncoding, KeepsUtf8AndConvertsLatin1)
{
  EXPECT_EQ(ToUtf8("Länge 1 µm €"), "Länge 1 µm €");
  EXPECT_EQ(ToUtf8("L\xE4nge"), "Länge");
  EXPECT_EQ(ToUtf8("\xC0\x80"), "\xC3\x80\xC2\x80"); // an overlong form is not valid
  EXPECT_EQ(ToUtf8("\xED\xA0\x80").size(), 6U);      // nor is a surrogate
  EXPECT_EQ(ToUtf8("\xE2\x82"), "\xC3\xA2\xC2\x82"); // nor a part of a character
  EXPECT_EQ(ToUtf8("two\nlines"), "two lines");
}

TEST(TextEncoding, NamesAndMessagesOfDrawingsAreUtf8)
{
  const Drawing drawing =
    ReadDrawing(DrawingFormat::Dxf, DxfText({ "CIRCLE 8 \xFC 10 0 20 0 40 1" }), "a.dxf");
  EXPECT_EQ(drawing.pieces.at(0).name, "ü");
  EXPECT_TRUE(Refuses([]
    { ReadDrawing(DrawingFormat::Dxf, DxfText({ "INSERT 2 \xFC 10 0 20 0" }), "a.dxf"); },
    { "'ü'" }));
}
}
}
