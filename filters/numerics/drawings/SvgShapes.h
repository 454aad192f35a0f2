#pragma once

#include "Drawing.h"

#include <map>
#include <string>
#include <vector>

namespace crossfield
{
using SvgAttributes = std::map<std::string, std::string>;

/// Returns whether an element of SVG is a shape that SvgShape reads.
bool IsSvgShape(const std::string& element);

/// Returns the pieces of a shape, path, rect, circle, ellipse, line, polyline or polygon, in its own
/// coordinates. Throws Error if an attribute is not valid.
std::vector<DrawingPiece> SvgShape(const std::string& element, const SvgAttributes& attributes);

/// Returns a length in user units, with the fallback for a missing attribute. A unit such as mm is
/// converted at 96 units per inch. Throws Error for percentages and em.
double SvgLength(const SvgAttributes& attributes, const std::string& name, double fallback = 0.0);

/// Returns the millimetres of an absolute length, such as "12cm"; 0 if it has no absolute unit.
double SvgMillimetres(const std::string& text);

/// Returns the map of a `transform` attribute. Throws Error if it is not valid.
AffineMap SvgTransform(const std::string& text);
}
