#pragma once

#include "Drawing.h"

#include <string>
#include <string_view>

namespace crossfield
{
/// Reads the polygon of a .geojson file with its holes; it may be the geometry of a feature or the
/// only part of a collection or a MultiPolygon. Coordinates are used as they are: lengths and angles
/// are only right if the file has projected coordinates. The unit is "degree" unless the file names
/// another coordinate system.
///
/// Throws Error if the text is not valid JSON, or has no polygon or several.
Drawing ReadGeoJson(std::string_view text, const std::string& file);
}
