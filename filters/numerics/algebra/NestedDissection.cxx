#include "NestedDissection.h"

#include "BothHalves.h"

#include <Eigen/Geometry>

#include <algorithm>

namespace crossfield
{
namespace
{
/// Number of unknowns below which a part is not split further: CHOLMOD treats its block as dense
/// anyway.
constexpr std::ptrdiff_t SmallestPart = 16;

class Dissector
{
public:
  Dissector(const Eigen::SparseMatrix<double>& matrix, const std::vector<Point>& places,
    const std::vector<int>& partners)
    : Matrix(matrix)
    , Places(places)
    , Partners(partners)
    , PartOf(places.size(), 0)
  {
  }

  /// Excludes an unknown, which is numbered elsewhere.
  void Exclude(int unknown) { this->PartOf[static_cast<std::size_t>(unknown)] = Excluded; }
  bool IsExcluded(int unknown) const
  {
    return this->PartOf[static_cast<std::size_t>(unknown)] == Excluded;
  }

  /// Measures how many unknowns a cut meets per length in either direction: the rows of a lattice
  /// are closer to each other than the points within a row.
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

  /// Rearranges [begin, end) into left half, right half and separator, split along the axis with
  /// the smaller separator. `part` is a number not yet used for any part adjacent to this one.
  Halves Split(int* begin, int* end, int part)
  {
    const Point sizes = this->Box(begin, end).sizes();
    const int axis = this->Density[0] * sizes.y() <= this->Density[1] * sizes.x() ? 0 : 1;
    return this->Split(begin, end, axis, part);
  }

  /// Puts the unknowns in [begin, end) into elimination order. Numbers its parts from `part` in
  /// steps of two, so that two threads that order disjoint halves use different numbers.
  /// `twoSheets`: unknowns and their partners may both be in the range.
  void Order(int* begin, int* end, int& part, bool twoSheets)
  {
    if (twoSheets)
    {
      this->OrderComponents(begin, end, part);
    }
    else if (end - begin > SmallestPart)
    {
      this->OrderHalves(begin, end, part, false);
    }
  }

private:
  static constexpr int Excluded = -1;

  void OrderHalves(int* begin, int* end, int& part, bool twoSheets)
  {
    const Halves halves = this->Split(begin, end, part += 2);
    this->Order(begin, halves.leftEnd, part, twoSheets);
    this->Order(halves.leftEnd, halves.rightEnd, part, twoSheets);
  }

  /// Orders one connected component after the other.
  void OrderComponents(int* begin, int* end, int& part)
  {
    const int mine = part += 2;
    for (const int* unknown = begin; unknown != end; ++unknown)
    {
      this->PartOf[static_cast<std::size_t>(*unknown)] = mine;
    }
    std::vector<int> ordered;
    ordered.reserve(static_cast<std::size_t>(end - begin));
    struct Component
    {
      std::size_t size;
      bool twoSheets;
    };
    std::vector<Component> components;
    for (const int* first = begin; first != end; ++first)
    {
      if (this->PartOf[static_cast<std::size_t>(*first)] != mine)
      {
        continue;
      }
      const std::size_t start = ordered.size();
      const int component = part += 2;
      this->PartOf[static_cast<std::size_t>(*first)] = component;
      ordered.push_back(*first);
      for (std::size_t next = start; next < ordered.size(); ++next)
      {
        for (Eigen::SparseMatrix<double>::InnerIterator entry(this->Matrix, ordered[next]); entry;
             ++entry)
        {
          const auto other = static_cast<std::size_t>(entry.row());
          if (this->PartOf[other] == mine)
          {
            this->PartOf[other] = component;
            ordered.push_back(static_cast<int>(other));
          }
        }
      }
      const bool twoSheets =
        std::any_of(ordered.begin() + static_cast<std::ptrdiff_t>(start), ordered.end(),
          [&](int unknown)
          {
            const int partner = this->Partners[static_cast<std::size_t>(unknown)];
            return partner >= 0 && this->PartOf[static_cast<std::size_t>(partner)] == component;
          });
      components.push_back({ ordered.size() - start, twoSheets });
    }
    std::copy(ordered.begin(), ordered.end(), begin);
    for (const Component& component : components)
    {
      int* const componentEnd = begin + component.size;
      if (componentEnd - begin > SmallestPart)
      {
        this->OrderHalves(begin, componentEnd, part, component.twoSheets);
      }
      begin = componentEnd;
    }
  }

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
  const std::vector<int>& Partners;
  Point Density = Point::Ones();
  /// For each unknown, the number of the last right half that contained it.
  std::vector<int> PartOf;
};
}

Dissection Dissect(const Eigen::SparseMatrix<double>& matrix, const std::vector<Point>& places,
  const std::vector<int>& trailing, const std::vector<int>& leftOut,
  const std::vector<int>& partners)
{
  Dissector dissector(matrix, places, partners);
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
  // Each thread reads only the parts of its own half and of the separator, which do not change.
  ForBothHalves(true,
    [&](std::size_t half)
    {
      // Numbers 2, 4, … on the left and 3, 5, … on the right; 1 was the right half.
      auto part = static_cast<int>(half);
      dissector.Order(half == 0 ? begin : halves.leftEnd,
        half == 0 ? halves.leftEnd : halves.rightEnd, part, !partners.empty());
    });
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
