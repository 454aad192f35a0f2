#include "PolygonTriangulation.h"

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
      this->Flat = std::max(this->Flat, Rounding * (polygon[i] - polygon.front()).squaredNorm());
      this->Before[i] = (i + count - 1) % count;
      this->After[i] = (i + 1) % count;
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
      const int before = this->Before[ear];
      const int after = this->After[ear];
      if (std::abs(this->Turn(ear)) > this->Flat)
      {
        this->Triangles.push_back({ before, ear, after });
      }
      this->After[before] = after;
      this->Before[after] = before;
      start = after;
      this->UpdateCost(before);
      this->UpdateCost(after);
      for (int i = this->After[after]; i != before; i = this->After[i])
      {
        if (this->Blocker[i] == ear)
        {
          this->UpdateCost(i);
        }
      }
    }
    return std::move(this->Triangles);
  }

private:
  const Point& At(int i) const { return this->Points[i]; }

  /// Returns twice the signed area of the triangle that a vertex forms with its neighbours.
  double Turn(int i) const
  {
    const Point& here = this->At(i);
    return Cross(here - this->At(this->Before[i]), this->At(this->After[i]) - here);
  }

  /// Sets the cost of a vertex: the square of its diagonal if it is an ear.
  void UpdateCost(int i)
  {
    const int before = this->Before[i];
    const int after = this->After[i];
    this->Blocker[i] = -1;
    this->Cost[i] = NoEar;
    if (!(this->Turn(i) > this->Flat))
    {
      return;
    }
    const Point& a = this->At(before);
    const Point& b = this->At(i);
    const Point& c = this->At(after);
    for (int j = this->After[after]; j != before; j = this->After[j])
    {
      const Point& p = this->At(j);
      if (p != a && p != b && p != c && Cross(b - a, p - a) >= 0.0 && Cross(c - b, p - b) >= 0.0 &&
        Cross(a - c, p - c) >= 0.0)
      {
        this->Blocker[i] = j;
        return;
      }
    }
    this->Cost[i] = (c - a).squaredNorm();
  }

  int BestEar(int start) const
  {
    int best = start;
    int widest = start;
    for (int i = this->After[start]; i != start; i = this->After[i])
    {
      best = this->Cost[i] < this->Cost[best] ? i : best;
      widest = this->Turn(i) > this->Turn(widest) ? i : widest;
    }
    return this->Cost[best] < NoEar ? best : widest;
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
