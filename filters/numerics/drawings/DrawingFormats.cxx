#include "DrawingFormats.h"

#include "Error.h"
#include "ReadAerofoil.h"
#include "ReadDxf.h"
#include "ReadGeoJson.h"
#include "ReadMsh.h"
#include "ReadOff.h"
#include "ReadPoly.h"
#include "ReadSvg.h"
#include "TextEncoding.h"

namespace crossfield
{
namespace
{
Drawing ReadText(DrawingFormat format, std::string_view text, const std::string& file)
{
  constexpr std::string_view ByteOrderMark = "\xEF\xBB\xBF"; // Windows programs write it
  if (text.substr(0, ByteOrderMark.size()) == ByteOrderMark)
  {
    text.remove_prefix(ByteOrderMark.size());
  }
  switch (format)
  {
  case DrawingFormat::Aerofoil:
    return ReadAerofoil(text, file);
  case DrawingFormat::Dxf:
    return ReadDxf(text, file);
  case DrawingFormat::GeoJson:
    return ReadGeoJson(text, file);
  case DrawingFormat::Msh:
    return ReadMsh(text, file);
  case DrawingFormat::Off:
    return ReadOff(text, file);
  case DrawingFormat::Poly:
    return ReadPoly(text, file);
  case DrawingFormat::Svg:
    return ReadSvg(text, file);
  default:
    throw Error("The drawing '" + file +
      "' has an unknown ending; give a .dxf, .svg, .geojson, .msh, .poly, .off or .dat file.");
  }
}
}

DrawingFormat FormatOfEnding(const std::string& ending)
{
  if (ending == ".dat")
  {
    return DrawingFormat::Aerofoil;
  }
  if (ending == ".dxf")
  {
    return DrawingFormat::Dxf;
  }
  if (ending == ".geojson" || ending == ".json")
  {
    return DrawingFormat::GeoJson;
  }
  if (ending == ".msh")
  {
    return DrawingFormat::Msh;
  }
  if (ending == ".off")
  {
    return DrawingFormat::Off;
  }
  if (ending == ".poly")
  {
    return DrawingFormat::Poly;
  }
  return ending == ".svg" ? DrawingFormat::Svg : DrawingFormat::None;
}

Drawing ReadDrawing(DrawingFormat format, std::string_view text, const std::string& file)
{
  Drawing drawing;
  try
  {
    drawing = ReadText(format, text, file);
  }
  catch (const Error& error)
  {
    throw Error(ToUtf8(error.what()));
  }
  for (DrawingPiece& piece : drawing.pieces)
  {
    piece.name = ToUtf8(piece.name);
    piece.origin = ToUtf8(piece.origin);
  }
  for (std::string& warning : drawing.warnings)
  {
    warning = ToUtf8(warning);
  }
  return drawing;
}
}
