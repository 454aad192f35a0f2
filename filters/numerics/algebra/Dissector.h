#pragma once

#include "Parts.h"
#include "Plane.h"

#include <Eigen/Geometry>
#include <Eigen/SparseCore>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

namespace crossfield
{
/// Number of unknowns below which a part is not split further: CHOLMOD treats its block as dense
/// anyway.
constexpr std::ptrdiff_t SmallestPart = 16;

/// Unknowns of a part of the tree that is not yet divided.
struct OpenPart
{
  int* begin;
  int* end;
  int number;     ///< Last number that was used for parts around this one.
  bool twoSheets; ///< Whether unknowns and their partners may both be in it.
  int parent;     ///< Number in the list of parts.
};

/// Divides the unknowns of a matrix along separators (NestedDissection.h).
class Dissector
{
public:
  Dissector(const Eigen::SparseMatrix<double>& matrix, const std::vector<SpacePoint>& places,
    const std::vector<int>& partners)
    : Matrix(matrix)
    , Places(places)
    , Partners(partners)
    , PartOf(places.size(), 0)
  {
  }

  /// Excludes an unknown, which is numbered elsewhere.
  void Exclude(int unknown) { this->PartOf[unknown] = Excluded; }
  bool IsExcluded(int unknown) const { return this->PartOf[unknown] == Excluded; }

  /// Measures how many couplings a cut meets per length in each direction, up to a common factor:
  /// the rows of a lattice are closer to each other than the points within a row. A plane across an
  /// axis meets couplings in proportion to their lengths along the axis.
  void MeasureDensity(const int* begin, const int* end)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      this->Density[axis] = SumOfRanges(end - begin,
        [&](int first, int last)
        {
          double sum = 0.0;
          for (const int* unknown = begin + first; unknown != begin + last; ++unknown)
          {
            for (Eigen::SparseMatrix<double>::InnerIterator entry(this->Matrix, *unknown); entry;
                 ++entry)
            {
              if (!this->IsExcluded(static_cast<int>(entry.row())))
              {
                sum += std::abs(
                  this->Place(static_cast<int>(entry.row()))[axis] - this->Place(*unknown)[axis]);
              }
            }
          }
          return sum;
        });
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
    const SpacePoint sizes = this->Box(begin, end).sizes();
    int axis = 0;
    for (int other = 1; other < 3; ++other)
    {
      axis = this->Density[axis] * sizes[other] > this->Density[other] * sizes[axis] ? other : axis;
    }
    return this->Split(begin, end, axis, part);
  }

  /// Puts the unknowns in [begin, end) into elimination order. Numbers its parts after `part`.
  /// Threads that order different leaves read only the numbers of their own leaf and of separators
  /// above it, which do not change. `twoSheets`: unknowns and their partners may both be in the
  /// range.
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

  struct Component
  {
    int* begin;
    int* end;
    bool twoSheets;
  };

  /// Rearranges [begin, end) into its connected components, and numbers them after `part`.
  std::vector<Component> FindComponents(int* begin, int* end, int& part)
  {
    const int mine = ++part;
    for (const int* unknown = begin; unknown != end; ++unknown)
    {
      this->PartOf[*unknown] = mine;
    }
    std::vector<int> ordered;
    ordered.reserve(static_cast<std::size_t>(end - begin));
    std::vector<Component> components;
    for (const int* first = begin; first != end; ++first)
    {
      if (this->PartOf[*first] != mine)
      {
        continue;
      }
      const std::size_t start = ordered.size();
      const int component = ++part;
      this->PartOf[*first] = component;
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
            const int partner = this->Partners[unknown];
            return partner >= 0 && this->PartOf[partner] == component;
          });
      components.push_back({ begin + start, begin + ordered.size(), twoSheets });
    }
    std::copy(ordered.begin(), ordered.end(), begin);
    return components;
  }

  /// Divides a part of the tree. Several connected components are divided into two groups without a
  /// separator, the first of which has at least a half of the unknowns.
  struct Division
  {
    std::array<OpenPart, 2> below;
    int* separator; ///< Its begin; it ends where the part ends.
  };
  Division Divide(const OpenPart& open, int parent)
  {
    int number = open.number;
    bool twoSheets = open.twoSheets;
    if (twoSheets)
    {
      const std::vector<Component> components = this->FindComponents(open.begin, open.end, number);
      if (components.size() > 1)
      {
        std::size_t first = 0;
        while (2 * (components[first].end - open.begin) < open.end - open.begin)
        {
          ++first;
        }
        first = std::min(first, components.size() - 2);
        const auto sheets = [&](std::size_t from, std::size_t to)
        {
          // Several components need the same treatment again.
          return to - from > 1 || components[from].twoSheets;
        };
        int* const middle = components[first].end;
        return { { OpenPart{ open.begin, middle, number, sheets(0, first + 1), parent },
                   OpenPart{
                     middle, open.end, number, sheets(first + 1, components.size()), parent } },
          open.end };
      }
      twoSheets = components.front().twoSheets;
    }
    const Halves halves = this->Split(open.begin, open.end, ++number);
    return { { OpenPart{ open.begin, halves.leftEnd, number, twoSheets, parent },
               OpenPart{ halves.leftEnd, halves.rightEnd, number, twoSheets, parent } },
      halves.rightEnd };
  }

private:
  static constexpr int Excluded = -1;

  void OrderHalves(int* begin, int* end, int& part, bool twoSheets)
  {
    const Halves halves = this->Split(begin, end, ++part);
    this->Order(begin, halves.leftEnd, part, twoSheets);
    this->Order(halves.leftEnd, halves.rightEnd, part, twoSheets);
  }

  /// Orders one connected component after the other.
  void OrderComponents(int* begin, int* end, int& part)
  {
    for (const Component& component : this->FindComponents(begin, end, part))
    {
      if (component.end - component.begin > SmallestPart)
      {
        this->OrderHalves(component.begin, component.end, part, component.twoSheets);
      }
    }
  }

  const SpacePoint& Place(int unknown) const { return this->Places[unknown]; }

  Eigen::AlignedBox3d Box(const int* begin, const int* end) const
  {
    Eigen::AlignedBox3d box;
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
      this->PartOf[*unknown] = part;
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
      if (this->PartOf[entry.row()] == part)
      {
        return true;
      }
    }
    return false;
  }

  const Eigen::SparseMatrix<double>& Matrix;
  const std::vector<SpacePoint>& Places;
  const std::vector<int>& Partners;
  SpacePoint Density = SpacePoint::Ones();
  /// For each unknown, the number of the last right half that contained it.
  std::vector<int> PartOf;
};
}
