#include "NestedDissection.h"

#include <Eigen/Geometry>

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

  /// Puts the unknowns in [begin, end) into elimination order.
  void Order(int* begin, int* end)
  {
    if (end - begin <= SmallestPart)
    {
      return;
    }
    Eigen::AlignedBox2d box;
    for (const int* unknown = begin; unknown != end; ++unknown)
    {
      box.extend(this->Place(*unknown));
    }
    const int axis = box.sizes().x() >= box.sizes().y() ? 0 : 1;
    int* const middle = begin + (end - begin) / 2;
    // Ties are broken by number, so that the order does not depend on the library's nth_element.
    std::nth_element(begin, middle, end,
      [this, axis](int a, int b)
      {
        const double x = this->Place(a)[axis];
        const double y = this->Place(b)[axis];
        return x < y || (x == y && a < b);
      });
    const int right = ++this->Parts;
    for (const int* unknown = middle; unknown != end; ++unknown)
    {
      this->PartOf[static_cast<std::size_t>(*unknown)] = right;
    }
    int* const separator = std::partition(
      begin, middle, [this, right](int unknown) { return !this->Touches(unknown, right); });
    const std::ptrdiff_t separatorSize = middle - separator;
    std::rotate(separator, middle, end);
    int* const rightEnd = end - separatorSize;
    this->Order(begin, separator);
    this->Order(separator, rightEnd);
  }

private:
  static constexpr int Excluded = -1;

  const Point& Place(int unknown) const { return this->Places[static_cast<std::size_t>(unknown)]; }

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
  std::vector<int> PartOf; ///< Number of the last right half that an unknown was in.
  int Parts = 0;
};
}

std::vector<int> NestedDissection(const Eigen::SparseMatrix<double>& matrix,
  const std::vector<Point>& places, const std::vector<int>& last)
{
  Dissector dissector(matrix, places);
  for (int unknown : last)
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
  dissector.Order(order.data(), order.data() + order.size());
  order.insert(order.end(), last.begin(), last.end());
  return order;
}
}
