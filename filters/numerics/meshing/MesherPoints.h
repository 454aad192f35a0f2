#pragma once

// Part of PlanarMesher.cxx: the choice of points to insert.
#include "MesherTriangulation.h"
#include "PlanarDomain.h"
#include "SizeField.h"
#include "TriangleMesh.h"

#include <cmath>

namespace crossfield::mesher
{
/// Returns whether a point is far enough, relative to the target size, from the vertices and
/// segments of the face that contains it. In a triangulation of the boundary alone, the face of a
/// point close to a segment or vertex has that segment or vertex.
inline bool IsClear(const Triangulation::Face_handle& face, const Point& point, double size)
{
  // A distance of half an edge from a segment and of two thirds from a vertex leaves angles above
  // 27° in most places; the mesher refines the other triangles.
  constexpr double FromSegment = 0.5;
  constexpr double FromVertex = 0.65;
  for (int i = 0; i < 3; ++i)
  {
    const Point here = FromCgal(face->vertex(i)->point());
    if ((point - here).squaredNorm() < FromVertex * FromVertex * size * size)
    {
      return false;
    }
    if (face->is_constrained(i))
    {
      const Point from = FromCgal(face->vertex(Triangulation::ccw(i))->point());
      const Point along = FromCgal(face->vertex(Triangulation::cw(i))->point()) - from;
      if (Cross(along, point - from) < FromSegment * size * along.norm())
      {
        return false;
      }
    }
  }
  return true;
}

/// Returns the candidates that are inside the domain and far enough from the boundary.
inline std::vector<CgalPoint> SelectClear(
  const Triangulation& triangulation, const std::vector<Point>& candidates, const SizeField& size)
{
  std::vector<CgalPoint> kept;
  Triangulation::Face_handle hint;
  for (const Point& point : candidates)
  {
    hint = triangulation.locate(ToCgal(point), hint);
    if (!triangulation.is_infinite(hint) && hint->is_in_domain() &&
      IsClear(hint, point, size(point)))
    {
      kept.push_back(ToCgal(point));
    }
  }
  return kept;
}

/// Returns two rings of points around each hole and imprinted circle, staggered relative to its
/// vertices. The field is steepest there, and identical triangles on all sides keep its numerical
/// error uniform.
inline std::vector<Point> HoleRings(
  const PlanarDomain& domain, const std::vector<BoundaryEdge>& loopMarks, const SizeField& size)
{
  std::vector<Point> rings;
  for (std::size_t l = 0; l < domain.loops.size(); ++l)
  {
    if (loopMarks[l].kind != BoundaryKind::Hole &&
      loopMarks[l].kind != BoundaryKind::ImprintedCircle)
    {
      continue;
    }
    const Loop& hole = domain.loops[l];
    const auto count = static_cast<double>(hole.size());
    Point centre = Point::Zero();
    for (const Point& point : hole)
    {
      centre += point / count;
    }
    double radius = (hole[0] - centre).norm();
    for (int ring = 1; ring <= 2; ++ring)
    {
      radius += 0.5 * std::sqrt(3.0) * 2.0 * Pi * radius / count;
      if (2.0 * Pi * radius / count > 1.25 * size(centre + Point(radius, 0.0)))
      {
        break; // edges between as many points as the hole has would be too long
      }
      const double start = std::atan2(hole[0].y() - centre.y(), hole[0].x() - centre.x());
      for (double i = 0.5 * ring; i < count + 0.5 * ring - 0.25; i += 1.0)
      {
        const double angle = start + 2.0 * Pi * i / count;
        rings.push_back(centre + radius * Point(std::cos(angle), std::sin(angle)));
      }
    }
  }
  return rings;
}
}
