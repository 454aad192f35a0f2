#include "PolygonTriangulation.h"

#include "Index.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace crossfield
{
namespace
{
constexpr double NoEar = std::numeric_limits<double>::infinity();

class EarClipping
{
public:
  explicit EarClipping(const Loop& polygon)
    : Points(polygon)
    , Before(polygon.size())
    , After(polygon.size())
    , Cost(polygon.size(), NoEar)
    , Blocker(polygon.size(), -1)
  {
    const auto count = static_cast<int>(polygon.size());
    // Points along straight sides are displaced by rounding.
    constexpr double Rounding = 1e-14;
    for (int i = 0; i < count; ++i)
    {
      this->Flat =
        std::max(this->Flat, Rounding * (polygon[Index(i)] - polygon.front()).squaredNorm());
      this->Before[Index(i)] = (i + count - 1) % count;
      this->After[Index(i)] = (i + 1) % count;
    }
  }

  std::vector<std::array<int, 3>> Run()
  {
    auto remaining = static_cast<int>(this->Points.size());
    if (remaining < 3)
    {
      return {};
    }
    for (int i = 0; i < remaining; ++i)
    {
      this->UpdateCost(i);
    }
    for (int start = 0; remaining > 2; --remaining)
    {
      const int ear = this->BestEar(start);
      const int before = this->Before[Index(ear)];
      const int after = this->After[Index(ear)];
      if (std::abs(this->Turn(ear)) > this->Flat)
      {
        this->Triangles.push_back({ before, ear, after });
      }
      this->After[Index(before)] = after;
      this->Before[Index(after)] = before;
      start = after;
      this->UpdateCost(before);
      this->UpdateCost(after);
      for (int i = this->After[Index(after)]; i != before; i = this->After[Index(i)])
      {
        if (this->Blocker[Index(i)] == ear)
        {
          this->UpdateCost(i);
        }
      }
    }
    return std::move(this->Triangles);
  }

private:
  const Point& At(int i) const { return this->Points[Index(i)]; }

  /// Returns twice the signed area of the triangle that a vertex forms with its neighbours.
  double Turn(int i) const
  {
    const Point& here = this->At(i);
    return Cross(here - this->At(this->Before[Index(i)]), this->At(this->After[Index(i)]) - here);
  }

  /// Sets the cost of a vertex: the square of its diagonal if it is an ear.
  void UpdateCost(int i)
  {
    const int before = this->Before[Index(i)];
    const int after = this->After[Index(i)];
    this->Blocker[Index(i)] = -1;
    this->Cost[Index(i)] = NoEar;
    if (!(this->Turn(i) > this->Flat))
    {
      return;
    }
    const Point& a = this->At(before);
    const Point& b = this->At(i);
    const Point& c = this->At(after);
    for (int j = this->After[Index(after)]; j != before; j = this->After[Index(j)])
    {
      const Point& p = this->At(j);
      if (p != a && p != b && p != c && Cross(b - a, p - a) >= 0.0 && Cross(c - b, p - b) >= 0.0 &&
        Cross(a - c, p - c) >= 0.0)
      {
        this->Blocker[Index(i)] = j;
        return;
      }
    }
    this->Cost[Index(i)] = (c - a).squaredNorm();
  }

  int BestEar(int start) const
  {
    int best = start;
    int widest = start;
    for (int i = this->After[Index(start)]; i != start; i = this->After[Index(i)])
    {
      best = this->Cost[Index(i)] < this->Cost[Index(best)] ? i : best;
      widest = this->Turn(i) > this->Turn(widest) ? i : widest;
    }
    return this->Cost[Index(best)] < NoEar ? best : widest;
  }

  const Loop& Points;
  std::vector<int> Before;
  std::vector<int> After;
  std::vector<double> Cost;
  std::vector<int> Blocker; ///< A point inside the triangle at a vertex, which therefore is no ear.
  std::vector<std::array<int, 3>> Triangles;
  double Flat = 0.0; ///< Twice the area up to which a triangle counts as degenerate.
};
}

std::vector<std::array<int, 3>> TriangulatePolygon(const Loop& polygon)
{
  return EarClipping(polygon).Run();
}
}
