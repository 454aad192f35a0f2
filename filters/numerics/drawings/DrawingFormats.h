#pragma once

#include "Drawing.h"

#include <string>
#include <string_view>

namespace crossfield
{
/// Formats of drawings that the numerics read.
enum class DrawingFormat
{
  None,
  Aerofoil, ///< .dat
  Dxf,      ///< .dxf
  GeoJson,  ///< .geojson, or .json
  Msh,      ///< .msh
  Off,      ///< .off
  Poly,     ///< .poly of Triangle
  Svg       ///< .svg
};

/// Returns the format of an ending in lower case with its dot.
DrawingFormat FormatOfEnding(const std::string& ending);

/// Reads a drawing. `file` is its name in messages. Names and messages are UTF-8 (TextEncoding.h). Throws Error if the text is not of the format.
Drawing ReadDrawing(DrawingFormat format, std::string_view text, const std::string& file);
}
