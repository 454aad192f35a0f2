#include "NestedDissection.h"

#include <Eigen/Geometry>

#include <omp.h>

#include <algorithm>

namespace crossfield
{
namespace
{
/// Below this many unknowns a part is numbered as it stands: its block is dense to CHOLMOD anyway.
constexpr std::ptrdiff_t SmallestPart = 16;

class Dissector
{
public:
  Dissector(const Eigen::SparseMatrix<double>& matrix, const std::vector<Point>& places)
    : Matrix(matrix)
    , Places(places)
    , PartOf(places.size(), 0)
  {
  }

  /// Marks an unknown as numbered elsewhere.
  void Exclude(int unknown) { this->PartOf[static_cast<std::size_t>(unknown)] = Excluded; }
  bool IsExcluded(int unknown) const
  {
    return this->PartOf[static_cast<std::size_t>(unknown)] == Excluded;
  }

  /// Measures how many unknowns a cut meets per length, in either direction: the rows of a lattice
  /// are closer to each other than the points in a row.
  void MeasureDensity(int* begin, int* end)
  {
    const Point sizes = this->Box(begin, end).sizes();
    for (int axis = 0; axis < 2; ++axis)
    {
      const Halves halves = this->Split(begin, end, axis, -2 - axis);
      const double length = sizes[1 - axis];
      this->Density[axis] =
        length > 0.0 ? static_cast<double>(end - halves.rightEnd) / length : 1.0;
    }
  }

  struct Halves
  {
    int* leftEnd;
    int* rightEnd;
  };

  /// Rearranges [begin, end) into left half, right half, separator, across the axis with the smaller
  /// separator. `part` is a number that was not used before for any part next to this one.
  Halves Split(int* begin, int* end, int part)
  {
    const Point sizes = this->Box(begin, end).sizes();
    const int axis = this->Density[0] * sizes.y() <= this->Density[1] * sizes.x() ? 0 : 1;
    return this->Split(begin, end, axis, part);
  }

  /// Puts the unknowns in [begin, end) into elimination order. Numbers its parts from `part` in
  /// steps of two, so that two threads that order disjoint halves do not use the same.
  void Order(int* begin, int* end, int& part)
  {
    if (end - begin <= SmallestPart)
    {
      return;
    }
    const Halves halves = this->Split(begin, end, part += 2);
    this->Order(begin, halves.leftEnd, part);
    this->Order(halves.leftEnd, halves.rightEnd, part);
  }

private:
  static constexpr int Excluded = -1;

  const Point& Place(int unknown) const { return this->Places[static_cast<std::size_t>(unknown)]; }

  Eigen::AlignedBox2d Box(const int* begin, const int* end) const
  {
    Eigen::AlignedBox2d box;
    for (const int* unknown = begin; unknown != end; ++unknown)
    {
      box.extend(this->Place(*unknown));
    }
    return box;
  }

  Halves Split(int* begin, int* end, int axis, int part)
  {
    int* const middle = begin + (end - begin) / 2;
    // Ties are broken by number, so that the order does not depend on the library's nth_element.
    std::nth_element(begin, middle, end,
      [this, axis](int a, int b)
      {
        const double x = this->Place(a)[axis];
        const double y = this->Place(b)[axis];
        return x < y || (x == y && a < b);
      });
    for (const int* unknown = middle; unknown != end; ++unknown)
    {
      this->PartOf[static_cast<std::size_t>(*unknown)] = part;
    }
    int* const separator = std::partition(
      begin, middle, [this, part](int unknown) { return !this->Touches(unknown, part); });
    const std::ptrdiff_t separatorSize = middle - separator;
    std::rotate(separator, middle, end);
    return { separator, end - separatorSize };
  }

  bool Touches(int unknown, int part) const
  {
    for (Eigen::SparseMatrix<double>::InnerIterator entry(this->Matrix, unknown); entry; ++entry)
    {
      if (this->PartOf[static_cast<std::size_t>(entry.row())] == part)
      {
        return true;
      }
    }
    return false;
  }

  const Eigen::SparseMatrix<double>& Matrix;
  const std::vector<Point>& Places;
  Point Density = Point::Ones();
  std::vector<int> PartOf; ///< Number of the last right half that an unknown was in.
};
}

Dissection Dissect(const Eigen::SparseMatrix<double>& matrix, const std::vector<Point>& places,
  const std::vector<int>& trailing, const std::vector<int>& leftOut)
{
  Dissector dissector(matrix, places);
  for (int unknown : trailing)
  {
    dissector.Exclude(unknown);
  }
  for (int unknown : leftOut)
  {
    dissector.Exclude(unknown);
  }
  std::vector<int> order;
  order.reserve(places.size());
  for (int unknown = 0; unknown < static_cast<int>(places.size()); ++unknown)
  {
    if (!dissector.IsExcluded(unknown))
    {
      order.push_back(unknown);
    }
  }
  int* const begin = order.data();
  int* const end = begin + order.size();
  dissector.MeasureDensity(begin, end);
  const Dissector::Halves halves = dissector.Split(begin, end, 1);
  // A thread reads the parts of its own half and of the separator only, which stay as they are.
#pragma omp parallel for num_threads(std::min(2, omp_get_max_threads())) schedule(static, 1)
  for (int half = 0; half < 2; ++half)
  {
    int part = half; // numbers 2, 4, … on the left, 3, 5, … on the right; 1 was the right half
    dissector.Order(
      half == 0 ? begin : halves.leftEnd, half == 0 ? halves.leftEnd : halves.rightEnd, part);
  }
  Dissection dissection;
  dissection.left.assign(begin, halves.leftEnd);
  dissection.right.assign(halves.leftEnd, halves.rightEnd);
  dissection.border.assign(halves.rightEnd, end);
  dissection.border.insert(dissection.border.end(), trailing.begin(), trailing.end());
  return dissection;
}

std::vector<int> NestedDissection(const Eigen::SparseMatrix<double>& matrix,
  const std::vector<Point>& places, const std::vector<int>& trailing)
{
  const Dissection dissection = Dissect(matrix, places, trailing);
  std::vector<int> order = dissection.left;
  order.insert(order.end(), dissection.right.begin(), dissection.right.end());
  order.insert(order.end(), dissection.border.begin(), dissection.border.end());
  return order;
}

double DissectionFill(double vertices)
{
  return vertices > 1.0 ? 31.0 / 4.0 * vertices * std::log2(vertices) : vertices;
}
}
