#include "SizeField.h"

#include "Error.h"

#include <algorithm>
#include <numeric>

namespace crossfield
{
SizeField::SizeField(const std::vector<SizeSource>& sources, double maximum, double gradation,
  Point lower, Point upper)
  : Maximum(maximum)
  , Gradation(gradation)
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
  this->Root = { 0.5 * (lower + upper), 0.5 * (upper - lower).maxCoeff() };
  this->Cells.emplace_back();
  std::vector<int> all(this->Sources.size());
  std::iota(all.begin(), all.end(), 0);
  this->Split(0, this->Root, all, 0);
}

double SizeField::Evaluate(const Point& point, const int* candidates, int count) const
{
  double size = this->Maximum;
  for (int i = 0; i < count; ++i)
  {
    const SizeSource& source = this->Sources[static_cast<std::size_t>(candidates[i])];
    size = std::min(size, source.size + this->Gradation * (point - source.position).norm());
  }
  return size;
}

void SizeField::Split(
  int cell, const Square& square, const std::vector<int>& candidates, int depth)
{
  const double centreSize =
    this->Evaluate(square.centre, candidates.data(), static_cast<int>(candidates.size()));
  // Over the cell every source's function changes by at most gradation × half-diagonal, so a source
  // above the minimum by more than twice that at the centre never attains it.
  const double reach = this->Gradation * std::sqrt(2.0) * square.halfWidth;
  std::vector<int> kept;
  for (int candidate : candidates)
  {
    const SizeSource& source = this->Sources[static_cast<std::size_t>(candidate)];
    const double value = source.size + this->Gradation * (square.centre - source.position).norm();
    if (value <= centreSize + 2.0 * reach)
    {
      kept.push_back(candidate);
    }
  }
  constexpr int MaximumDepth = 48; // beyond it a double cannot tell the children apart
  if (kept.empty() || square.halfWidth <= centreSize || depth == MaximumDepth)
  {
    Cell& leaf = this->Cells[static_cast<std::size_t>(cell)];
    leaf.firstCandidate = static_cast<int>(this->Candidates.size());
    leaf.candidateCount = static_cast<int>(kept.size());
    this->Candidates.insert(this->Candidates.end(), kept.begin(), kept.end());
    return;
  }
  const int firstChild = static_cast<int>(this->Cells.size());
  this->Cells[static_cast<std::size_t>(cell)].firstChild = firstChild;
  this->Cells.resize(this->Cells.size() + 4);
  const double half = 0.5 * square.halfWidth;
  for (int child = 0; child < 4; ++child)
  {
    const Point offset((child & 1) != 0 ? half : -half, (child & 2) != 0 ? half : -half);
    this->Split(firstChild + child, { square.centre + offset, half }, kept, depth + 1);
  }
}

double SizeField::operator()(const Point& point) const
{
  const Cell* cell = this->Cells.data();
  Square square = this->Root;
  while (cell->firstChild >= 0)
  {
    const bool right = point.x() >= square.centre.x();
    const bool upper = point.y() >= square.centre.y();
    square.halfWidth *= 0.5;
    square.centre += Point(right ? square.halfWidth : -square.halfWidth,
      upper ? square.halfWidth : -square.halfWidth);
    cell = &this->Cells[static_cast<std::size_t>(cell->firstChild + (right ? 1 : 0) + (upper ? 2 : 0))];
  }
  return this->Evaluate(
    point, this->Candidates.data() + cell->firstCandidate, cell->candidateCount);
}
}
