#pragma once

// Shared by the tests of drawings.

#include "Drawing.h"
#include "DrawingOutline.h"

#include <string>
#include <vector>

namespace crossfield::test
{
/// Returns the text of a .dxf file with the given entities, each of which is written as
/// "TYPE code value code value ...", separated by blanks.
std::string DxfText(const std::vector<std::string>& entities,
  const std::vector<std::string>& blocks = {}, const std::string& header = "");

/// Returns the groups of entities, which are written as for DxfText.
std::string DxfGroups(const std::vector<std::string>& entities);

/// Returns the loops of an outline.
std::vector<Loop> LoopsOf(const DrawingOutline& outline);

/// Returns the area of the outer loop without the other loops.
double AreaOf(const DrawingOutline& outline);

/// Returns the outline with default options.
DrawingOutline Trace(const Drawing& drawing);

/// Returns the points of a piece at equal steps of its parameter.
std::vector<Point> PointsOf(const DrawingPiece& piece, int count = 17);

class Random;
/// Returns an arc of a circle, of an ellipse, a line, or a NURBS curve, as the kind is 0 to 3.
DrawingPiece RandomPiece(Random& random, int kind);
}
