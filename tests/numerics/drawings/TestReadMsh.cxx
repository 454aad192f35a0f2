#include "ReadMsh.h"

#include "DrawingChecks.h"
#include "Support.h"

#include <cstring>

namespace crossfield::test
{
namespace
{
/// Unit square of two triangles, with two named lines, in each variant of the format.
const std::string Names =
  "$PhysicalNames\n3\n1 7 \"wet wall\"\n1 8 \"inlet\"\n2 9 \"plate\"\n$EndPhysicalNames\n";
const std::string Ascii22 = "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n" + Names +
  "$Nodes\n4\n1 0 0 0\n2 1 0 0\n3 1 1 0\n4 0 1 0\n$EndNodes\n"
  "$Elements\n4\n1 1 2 7 1 1 2\n2 1 2 8 2 2 3\n3 2 2 9 1 1 2 3\n4 2 2 9 1 1 3 4\n$EndElements\n";
const std::string Ascii41 = "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n" + Names +
  "$Entities\n1 2 1 0\n1 0 0 0 0\n1 0 0 0 1 0 0 1 7 2 1 -2\n2 1 0 0 1 1 0 1 -8 0\n1 0 0 0 1 1 0 1 9 0\n"
  "$EndEntities\n$Nodes\n2 4 1 4\n0 1 0 1\n1\n0 0 0\n2 1 1 3\n2\n3\n4\n1 0 0 0 0\n1 1 0 0 0\n0 1 0 0 0\n"
  "$EndNodes\n$Elements\n3 4 1 4\n1 1 1 1\n1 1 2\n1 2 1 1\n2 2 3\n2 1 2 2\n3 1 2 3\n4 1 3 4\n$EndElements\n";

class Bytes
{
public:
  template <class Value>
  Bytes& Add(Value value)
  {
    char bytes[sizeof(Value)];
    std::memcpy(bytes, &value, sizeof(Value));
    this->Text.append(bytes, sizeof(Value));
    return *this;
  }
  Bytes& Add(const char* text)
  {
    this->Text += text;
    return *this;
  }
  template <class Value>
  Bytes& AddAll(const std::vector<Value>& values)
  {
    for (const Value value : values)
    {
      this->Add(value);
    }
    return *this;
  }
  std::string Text;
};

std::string Binary22()
{
  Bytes bytes;
  bytes.Add("$MeshFormat\n2.2 1 8\n").Add(1).Add("\n$EndMeshFormat\n").Add(Names.c_str());
  bytes.Add("$Nodes\n4\n");
  const std::vector<std::vector<double>> places = { { 0, 0, 0 }, { 1, 0, 0 }, { 1, 1, 0 },
    { 0, 1, 0 } };
  for (int i = 0; i < 4; ++i)
  {
    bytes.Add(i + 1).AddAll(places[static_cast<std::size_t>(i)]);
  }
  bytes.Add("\n$EndNodes\n$Elements\n4\n");
  bytes.AddAll<int>({ 1, 2, 2, 1, 7, 1, 1, 2, 2, 8, 2, 2, 3 });
  bytes.AddAll<int>({ 2, 2, 2, 3, 9, 1, 1, 2, 3, 4, 9, 1, 1, 3, 4 });
  return bytes.Add("\n$EndElements\n").Text;
}

std::string Binary41()
{
  using Size = std::uint64_t;
  Bytes bytes;
  bytes.Add("$MeshFormat\n4.1 1 8\n").Add(1).Add("\n$EndMeshFormat\n").Add(Names.c_str());
  bytes.Add("$Entities\n").AddAll<Size>({ 0, 2, 1, 0 });
  bytes.Add(1).AddAll<double>({ 0, 0, 0, 1, 0, 0 }).Add(Size(1)).Add(7).Add(Size(2)).Add(1).Add(-2);
  bytes.Add(2).AddAll<double>({ 1, 0, 0, 1, 1, 0 }).Add(Size(1)).Add(8).Add(Size(0));
  bytes.Add(1).AddAll<double>({ 0, 0, 0, 1, 1, 0 }).Add(Size(1)).Add(9).Add(Size(0));
  bytes.Add("\n$EndEntities\n$Nodes\n").AddAll<Size>({ 1, 4, 1, 4 });
  bytes.AddAll<int>({ 2, 1, 0 }).Add(Size(4)).AddAll<Size>({ 1, 2, 3, 4 });
  bytes.AddAll<double>({ 0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0 });
  bytes.Add("\n$EndNodes\n$Elements\n").AddAll<Size>({ 3, 4, 1, 4 });
  bytes.AddAll<int>({ 1, 1, 1 }).AddAll<Size>({ 1, 1, 1, 2 });
  bytes.AddAll<int>({ 1, 2, 1 }).AddAll<Size>({ 1, 2, 2, 3 });
  bytes.AddAll<int>({ 2, 1, 2 }).AddAll<Size>({ 2, 3, 1, 2, 3, 4, 1, 3, 4 });
  return bytes.Add("\n$EndElements\n").Text;
}

TEST(ReadMsh, EveryVariantIsTheSameSquare)
{
  for (const std::string& text : { Ascii22, Ascii41, Binary22(), Binary41() })
  {
    const Drawing drawing = ReadMsh(text, "part.msh");
    ASSERT_EQ(drawing.pieces.size(), 4U) << text.substr(0, 20);
    std::map<std::string, Point> middle;
    for (const DrawingPiece& piece : drawing.pieces)
    {
      EXPECT_FALSE(piece.isExact);
      middle[piece.name] = 0.5 * (piece.first + piece.last);
    }
    EXPECT_EQ(middle.at("wet wall"), Point(0.5, 0));
    EXPECT_EQ(middle.at("inlet"), Point(1, 0.5));
    const DrawingOutline outline = Trace(drawing);
    EXPECT_EQ(AreaOf(outline), 1.0);
    EXPECT_TRUE(outline.curves.empty());
  }
}

TEST(ReadMsh, ReadsLinesAndEdgesOfHigherOrder)
{
  const std::string nodes =
    "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n9\n1 0 0 0\n2 2 0 0\n3 2 2 0\n4 0 2 0\n"
    "5 1 -0.5 0\n6 2.5 1 0\n7 1 2.5 0\n8 -0.5 1 0\n9 1 1 0\n$EndNodes\n";
  const Drawing lines = ReadMsh(nodes +
      "$Elements\n4\n1 8 2 3 1 1 2 5\n2 8 2 3 1 2 3 6\n3 8 2 3 1 3 4 7\n4 8 2 3 1 4 1 8\n$EndElements\n",
    "part.msh");
  const Drawing quad =
    ReadMsh(nodes + "$Elements\n1\n1 10 2 1 1 1 2 3 4 5 6 7 8 9\n$EndElements\n", "part.msh");
  for (const Drawing& drawing : { lines, quad })
  {
    ASSERT_EQ(drawing.pieces.size(), 8U);
    EXPECT_NEAR(AreaOf(Trace(drawing)), 4.0 + 4 * 0.5, 1e-14);
  }
  EXPECT_EQ(lines.pieces[0].name, "3"); // a group without a name
}

TEST(ReadMsh, LeavesOutLinesInside)
{
  std::string text = Ascii22;
  text.replace(text.find("1 1 2 7 1 1 2"), 13, "1 1 2 7 1 1 3");
  const Drawing drawing = ReadMsh(text, "part.msh");
  EXPECT_EQ(drawing.pieces.size(), 4U);
  ASSERT_EQ(drawing.warnings.size(), 1U);
  EXPECT_NE(drawing.warnings[0].find("1 line of the mesh"), std::string::npos);
}

TEST(ReadMsh, KeepsTheTiltedPlane)
{
  std::string text = Ascii22;
  text.replace(text.find("3 1 1 0\n4 0 1 0"), 15, "3 1 1 1\n4 0 1 1");
  const Drawing drawing = ReadMsh(text, "part.msh");
  for (const DrawingPiece& piece : drawing.pieces)
  {
    const Eigen::Vector3d place = drawing.plane.ToSpace(piece.first);
    EXPECT_NEAR(place.y(), place.z(), 1e-12);
  }
  EXPECT_NEAR(AreaOf(Trace(drawing)), std::sqrt(2.0), 1e-12);
}

TEST(ReadMsh, RefusesOtherFiles)
{
  const auto refuses = [](const std::string& text, const std::string& part)
  { EXPECT_TRUE(Refuses([&] { ReadMsh(text, "part.msh"); }, { part })) << text.substr(0, 60); };
  refuses("", "MeshFormat");
  refuses("$MeshFormat\n4 0 8\n", "format that is not read");
  refuses("$MeshFormat\n2.2 0 4\n", "unknown kind");
  refuses("$MeshFormat\n2.2 1 8\n\x00\x00\x00\x01", "ends too early");
  refuses("$MeshFormat\n2.2 0 8\n$EndMeshFormat\n", "no elements");
  const std::string nodes =
    "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n3\n1 0 0 0\n2 1 0 0\n3 1 1 0\n$EndNodes\n$Elements\n1\n";
  refuses(nodes + "1 4 2 1 1 1 2 3 4\n$EndElements\n", "volumes");
  refuses(nodes + "1 99 2 1 1 1 2 3 4\n$EndElements\n", "type 99");
  refuses(nodes + "1 1 2 1 1 1 9\n$EndElements\n", "node 9");
  refuses(nodes + "1 15 2 1 1 1\n$EndElements\n", "no boundary");
  refuses(nodes + "1 1 2 1", "ends too early");
  refuses(nodes + "1 1 x 1 1 1 2\n", "'x'");
  refuses(nodes + "1 1 " + std::string(1, '\0') + "5 1\n", "' 5' in place of an integer");
  for (const std::string& text : { Binary22(), Binary41(), Ascii41 })
  {
    for (std::size_t size = 0; size + 20 < text.size(); size += 7)
    {
      EXPECT_THROW(ReadMsh(text.substr(0, size), "part.msh"), Error) << size;
    }
  }
}
}
}
