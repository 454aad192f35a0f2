#pragma once

#include "Plane.h"

#include <array>

namespace crossfield
{
/// A place that asks for a small edge length around it.
struct SizeSource
{
  Point position;
  double size;
};

/// Graded target edge length: h(x) = min(maximum, min_i (size_i + gradation |x − position_i|)).
///
/// Stored on a quadtree whose leaves are about as large as h in them; within a leaf only the
/// sources that can attain the minimum are kept, so a look-up costs the depth of the tree.
class SizeField
{
public:
  SizeField(const std::vector<SizeSource>& sources, double maximum, double gradation, Point lower,
    Point upper);

  /// Target edge length at a point; outside the box given to the constructor, that of its border.
  double operator()(const Point& point) const;

private:
  struct Cell
  {
    int firstChild = -1; ///< −1: a leaf; the other three children follow it.
    int firstCandidate = 0;
    int candidateCount = 0;
  };
  struct Square
  {
    Point centre;
    double halfWidth;
  };

  double Evaluate(const Point& point, const int* candidates, int count) const;
  void Split(int cell, const Square& square, const std::vector<int>& candidates, int depth);

  std::vector<SizeSource> Sources;
  double Maximum;
  double Gradation;
  Square Root;
  std::vector<Cell> Cells;
  std::vector<int> Candidates;
};
}
