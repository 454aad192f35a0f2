#pragma once

#include "Plane.h"

#include <Eigen/Geometry>

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
  /// `box` is where the field is asked for. Throws Error unless maximum and gradation are positive.
  SizeField(const std::vector<SizeSource>& sources, double maximum, double gradation,
    const Eigen::AlignedBox2d& box);

  /// Target edge length at a point; meaningless outside the box.
  double operator()(const Point& point) const;

  double GetMaximum() const { return this->Maximum; }
  const Eigen::AlignedBox2d& GetBox() const { return this->Box; }

  /// A part of the box, half-open towards the upper right, in which few sources matter.
  class Leaf
  {
  public:
    Eigen::AlignedBox2d box;
    double SizeAt(const Point& point) const { return this->Field.Evaluate(point, this->Range); }
    /// Not above the size anywhere in the leaf.
    double LowerBound() const;

  private:
    friend class SizeField;
    Leaf(const SizeField& field, const Eigen::AlignedBox2d& where, std::array<int, 2> range)
      : box(where)
      , Field(field)
      , Range(range)
    {
    }
    const SizeField& Field;
    std::array<int, 2> Range;
  };

  /// The leaves that tile the box, in a fixed order.
  std::vector<Leaf> Leaves() const;

private:
  struct Cell
  {
    int firstChild = -1;                 ///< −1: a leaf; the other three children follow it.
    std::array<int, 2> range = { 0, 0 }; ///< Of a leaf: where its sources are in Candidates.
  };
  struct Square
  {
    Point centre;
    double halfWidth;
    Square Child(int number) const;
  };

  double Evaluate(const Point& point, const std::array<int, 2>& range) const;
  void Split(int cell, const Square& square, const std::vector<int>& candidates, int depth);
  void Collect(int cell, const Square& square, std::vector<Leaf>& leaves) const;

  std::vector<SizeSource> Sources;
  double Maximum;
  double Gradation;
  Eigen::AlignedBox2d Box;
  Square Root;
  std::vector<Cell> Cells;
  std::vector<int> Candidates;
};
}
