#pragma once

// Part of PlanarMesher.cxx, the one file that includes CGAL: the choice of points to insert.
#include "MesherTriangulation.h"
#include "PlanarDomain.h"
#include "SizeField.h"
#include "TriangleMesh.h"

#include <cmath>

namespace crossfield::mesher
{
/// Whether a point keeps its distance, relative to the wanted size, from the vertices and segments
/// of the face that it lies in; points of a boundary-only triangulation near a segment or vertex
/// lie in a face that has it.
inline bool IsClear(const Triangulation::Face_handle& face, const Point& point, double size)
{
  // Half an edge from a segment and two thirds from a vertex leave triangles with angles above 27°
  // in most places; the mesher mends the others.
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

/// The points among the candidates that lie in the domain and keep their distance.
inline std::vector<CgalPoint> KeepClear(
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

/// Two rings of points around every hole and imprinted circle, staggered against its vertices: the
/// field is steepest there, and the same triangles on all sides keep its numerical error even.
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
        break; // as many points as the hole has would be too few
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
