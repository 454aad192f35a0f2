#pragma once

// Part of PlanarMesher.cxx.
#include "MesherTriangulation.h"
#include "SizeField.h"

#include <CGAL/Delaunay_mesh_criteria_2.h>

#include <algorithm>
#include <cmath>

namespace crossfield::mesher
{
/// Criteria for Delaunay_mesher_2. A triangle is bad if it has an angle below 27° (20.7° if it is
/// much smaller than the target size), or a longest edge well above the target size at its centre.
class GradedCriteria : public CGAL::Delaunay_mesh_criteria_2<Triangulation>
{
public:
  using Base = CGAL::Delaunay_mesh_criteria_2<Triangulation>;

  /// Quality of a triangle, ordered by urgency of refinement: oversized triangles first, then by
  /// angle.
  struct Quality
  {
    double sineSquared = 1.0; ///< sin² of the smallest angle.
    double bound = 0.0;       ///< Lower bound of sineSquared.
    double oversize = 0.0;    ///< (longest edge / longest allowed edge)².
    bool TooLarge() const { return this->oversize > 1.0; }
    bool operator<(const Quality& other) const
    {
      if (this->TooLarge() || other.TooLarge())
      {
        return this->oversize > other.oversize;
      }
      return this->sineSquared < other.sineSquared;
    }
  };

  class Is_bad
  {
  public:
    explicit Is_bad(const SizeField& size)
      : Size(size)
    {
    }
    CGAL::Mesh_2::Face_badness operator()(const Quality& quality) const
    {
      if (quality.TooLarge())
      {
        return CGAL::Mesh_2::IMPERATIVELY_BAD;
      }
      return quality.sineSquared < quality.bound ? CGAL::Mesh_2::BAD : CGAL::Mesh_2::NOT_BAD;
    }
    CGAL::Mesh_2::Face_badness operator()(
      const Triangulation::Face_handle& face, Quality& quality) const
    {
      const Point p[3] = { FromCgal(face->vertex(0)->point()), FromCgal(face->vertex(1)->point()),
        FromCgal(face->vertex(2)->point()) };
      double lengths[3];
      for (int i = 0; i < 3; ++i)
      {
        lengths[i] = (p[(i + 1) % 3] - p[i]).squaredNorm();
      }
      std::sort(lengths, lengths + 3);
      const double twiceArea = Cross(p[1] - p[0], p[2] - p[0]);
      const double target = this->Size((p[0] + p[1] + p[2]) / 3.0);
      // Between the lattice and the boundary, triangles are up to half as long again as the target
      // size.
      constexpr double Slack = 1.5;
      quality.oversize = lengths[2] / (Slack * Slack * target * target);
      // sin² 20.7° = 1/8: with this bound refinement provably terminates (CGAL manual, Mesh_2). The
      // bound of 27° applies only to triangles above a fifth of the target size; their number is
      // limited, so refinement still terminates.
      const double sine = std::sin(27.0 / 180.0 * Pi);
      quality.bound = lengths[2] > 0.04 * target * target ? sine * sine : 0.125;
      quality.sineSquared = twiceArea * twiceArea / (lengths[1] * lengths[2]);
      return (*this)(quality);
    }

  private:
    const SizeField& Size;
  };

  explicit GradedCriteria(const SizeField& size)
    : Size(size)
  {
  }
  Is_bad is_bad_object() const { return Is_bad(this->Size); }

private:
  const SizeField& Size;
};
}
