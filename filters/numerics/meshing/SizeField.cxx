#include "SizeField.h"

#include "Error.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace crossfield
{
SizeField::SizeField(const std::vector<SizeSource>& sources, double maximum, double gradation,
  const Eigen::AlignedBox2d& box)
  : Maximum(maximum)
  , Gradation(gradation)
  , Box(box)
  , Root{ box.center(), 0.5 * box.sizes().maxCoeff() }
{
  if (!(maximum > 0.0) || !(gradation > 0.0))
  {
    throw Error("The mesh size and its gradation must be positive.");
  }
  for (const SizeSource& source : sources)
  {
    if (source.size < maximum)
    {
      this->Sources.push_back(source);
    }
  }
  this->Cells.emplace_back();
  std::vector<int> all(this->Sources.size());
  std::iota(all.begin(), all.end(), 0);
  this->Split(0, this->Root, all, 0);
}

SizeField::Square SizeField::Square::Child(int number) const
{
  const double half = 0.5 * this->halfWidth;
  return { this->centre + Point((number & 1) != 0 ? half : -half, (number & 2) != 0 ? half : -half),
    half };
}

double SizeField::Evaluate(const Point& point, const std::array<int, 2>& range) const
{
  double size = this->Maximum;
  for (int i = range[0]; i < range[1]; ++i)
  {
    const SizeSource& source = this->Sources[this->Candidates[i]];
    size = std::min(size, source.size + this->Gradation * (point - source.position).norm());
  }
  return size;
}

void SizeField::Split(int cell, const Square& square, const std::vector<int>& candidates, int depth)
{
  std::vector<double> values;
  double centreSize = this->Maximum;
  for (int candidate : candidates)
  {
    const SizeSource& source = this->Sources[candidate];
    values.push_back(source.size + this->Gradation * (square.centre - source.position).norm());
    centreSize = std::min(centreSize, values.back());
  }
  // Within the cell the function of a source changes by at most gradation × half-diagonal, so a
  // source above the minimum by more than twice that at the centre never attains it.
  const double reach = this->Gradation * std::sqrt(2.0) * square.halfWidth;
  std::vector<int> kept;
  for (std::size_t i = 0; i < candidates.size(); ++i)
  {
    if (values[i] <= centreSize + 2.0 * reach)
    {
      kept.push_back(candidates[i]);
    }
  }
  constexpr int MaximumDepth = 48; // beyond it, coordinates cannot separate the children
  if (kept.empty() || square.halfWidth <= centreSize || depth == MaximumDepth)
  {
    Cell& leaf = this->Cells[cell];
    leaf.range[0] = static_cast<int>(this->Candidates.size());
    this->Candidates.insert(this->Candidates.end(), kept.begin(), kept.end());
    leaf.range[1] = static_cast<int>(this->Candidates.size());
    return;
  }
  const int firstChild = static_cast<int>(this->Cells.size());
  this->Cells[cell].firstChild = firstChild;
  this->Cells.resize(this->Cells.size() + 4);
  for (int child = 0; child < 4; ++child)
  {
    this->Split(firstChild + child, square.Child(child), kept, depth + 1);
  }
}

double SizeField::operator()(const Point& point) const
{
  const Cell* cell = this->Cells.data();
  Square square = this->Root;
  while (cell->firstChild >= 0)
  {
    const int child =
      (point.x() >= square.centre.x() ? 1 : 0) + (point.y() >= square.centre.y() ? 2 : 0);
    square = square.Child(child);
    cell =
      &this->Cells[static_cast<std::size_t>(cell->firstChild) + static_cast<std::size_t>(child)];
  }
  return this->Evaluate(point, cell->range);
}

void SizeField::Collect(int cell, const Square& square, std::vector<Leaf>& leaves) const
{
  const Cell& here = this->Cells[cell];
  if (here.firstChild < 0)
  {
    const Point half(square.halfWidth, square.halfWidth);
    const Eigen::AlignedBox2d box =
      Eigen::AlignedBox2d(square.centre - half, square.centre + half).intersection(this->Box);
    if (!box.isEmpty())
    {
      leaves.push_back(Leaf(*this, box, here.range));
    }
    return;
  }
  for (int child = 0; child < 4; ++child)
  {
    this->Collect(here.firstChild + child, square.Child(child), leaves);
  }
}

double SizeField::Leaf::LowerBound() const
{
  double smallest = this->Field.Maximum;
  for (int i = this->Range[0]; i < this->Range[1]; ++i)
  {
    const int source = this->Field.Candidates[i];
    smallest = std::min(smallest, this->Field.Sources[source].size);
  }
  const double change = 0.5 * this->Field.Gradation * this->box.diagonal().norm();
  return std::max(smallest, this->SizeAt(this->box.center()) - change);
}

std::vector<SizeField::Leaf> SizeField::Leaves() const
{
  std::vector<Leaf> leaves;
  this->Collect(0, this->Root, leaves);
  return leaves;
}
}
