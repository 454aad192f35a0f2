#pragma once

#include "Plane.h"

#include <Eigen/Geometry>

#include <array>

namespace crossfield
{
/// Point at which the edge length is `size`; around it the edge length grows by the gradation.
struct SizeSource
{
  Point position;
  double size;
};

/// Graded target edge length: h(x) = min(maximum, min_i (size_i + gradation |x − position_i|)).
///
/// Stored as a quadtree whose leaves are about as large as h in them. A leaf has only the sources
/// that can attain the minimum in it, so the cost of an evaluation is the depth of the tree.
class SizeField
{
public:
  /// Constructs the field on `box`. Throws Error unless maximum and gradation are positive.
  SizeField(const std::vector<SizeSource>& sources, double maximum, double gradation,
    const Eigen::AlignedBox2d& box);

  /// Returns the target edge length at a point; undefined outside the box.
  double operator()(const Point& point) const;

  double GetMaximum() const { return this->Maximum; }
  const Eigen::AlignedBox2d& GetBox() const { return this->Box; }

  /// Part of the box, half-open towards the upper right, in which only a few sources attain the
  /// minimum.
  class Leaf
  {
  public:
    Eigen::AlignedBox2d box;
    double SizeAt(const Point& point) const { return this->Field.Evaluate(point, this->Range); }
    /// Returns a lower bound of the size in the leaf.
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

  /// Returns the leaves, which tile the box, in a fixed order.
  std::vector<Leaf> Leaves() const;

private:
  struct Cell
  {
    int firstChild = -1;                 ///< First of four consecutive children; −1 for a leaf.
    std::array<int, 2> range = { 0, 0 }; ///< Range of the leaf's sources in Candidates.
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
