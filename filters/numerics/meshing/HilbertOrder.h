#pragma once

// Part of PlanarMesher.cxx: an order of places in the plane.
#include "Parts.h"

#include <CGAL/hilbert_sort.h> // with the random numbers of Boost that it uses

#include <algorithm>
#include <array>
#include <cstddef>

namespace crossfield::mesher
{
/// Sorts places in parallel exactly as CGAL::hilbert_sort does: along a Hilbert curve through
/// squares that are divided at medians. Halving the squares instead would not terminate if two
/// places round to one point.
///
/// CGAL's own parallel version does not know ThreadLimit.
template <class Traits>
class HilbertOrder
{
public:
  explicit HilbertOrder(const Traits& traits)
    : Comparisons(traits)
    , Sequential(traits)
  {
  }

  template <class Iterator>
  void Sort(Iterator begin, Iterator end) const
  {
    // As in hilbert_sort: the order of equal coordinates depends on it.
    boost::rand48 engine;
    boost::random_number_generator<boost::rand48, std::ptrdiff_t> random(engine);
    CGAL::cpp98::random_shuffle(begin, end, random);
    WithAllThreads([&] { this->SortSquare<0, false, false>(begin, end); });
  }

private:
  /// The curve enters a square at the lower or upper side in direction `axis`, by `isUpper`, and in
  /// the other direction, by `isOtherUpper`.
  template <int axis, bool isUpper, bool isOtherUpper, class Iterator>
  void SortSquare(Iterator begin, Iterator end) const
  {
    if (end - begin < 4 * MinimumPartSize)
    {
      this->Sequential.template recursive_sort<axis, isUpper, isOtherUpper>(begin, end);
      return;
    }
    constexpr int Other = 1 - axis;
    std::array<Iterator, 5> bounds{ begin, begin, begin, begin, end };
    bounds[2] = this->template Split<axis, isUpper>(begin, end);
    ForParts(2,
      [&](std::size_t half)
      {
        if (half == 0)
        {
          bounds[1] = this->template Split<Other, isOtherUpper>(bounds[0], bounds[2]);
        }
        else
        {
          bounds[3] = this->template Split<Other, !isOtherUpper>(bounds[2], bounds[4]);
        }
      });
    ForParts(4,
      [&](std::size_t quarter)
      {
        const Iterator from = bounds[quarter];
        const Iterator to = bounds[quarter + 1];
        if (quarter == 0)
        {
          this->template SortSquare<Other, isOtherUpper, isUpper>(from, to);
        }
        else if (quarter == 3)
        {
          this->template SortSquare<Other, !isOtherUpper, !isUpper>(from, to);
        }
        else
        {
          this->template SortSquare<axis, isUpper, isOtherUpper>(from, to);
        }
      });
  }

  /// Moves the smaller half of the coordinates to the front, or the larger half, and returns where
  /// the other half begins.
  template <int axis, bool isUpper, class Iterator>
  Iterator Split(Iterator begin, Iterator end) const
  {
    const auto isLess = [this](const auto& a, const auto& b)
    {
      if constexpr (axis == 0)
      {
        return this->Comparisons.less_x_2_object()(a, b);
      }
      else
      {
        return this->Comparisons.less_y_2_object()(a, b);
      }
    };
    const Iterator middle = begin + (end - begin) / 2;
    std::nth_element(begin, middle, end,
      [&isLess](const auto& a, const auto& b) { return isUpper ? isLess(b, a) : isLess(a, b); });
    return middle;
  }

  Traits Comparisons;
  CGAL::Hilbert_sort_median_2<Traits, CGAL::Sequential_tag> Sequential;
};
}
