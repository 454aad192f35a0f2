// The one file that includes CGAL: its headers take long to compile.
#include "PlanarMesher.h"

#include "Error.h"
#include "PointLattice.h"

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Delaunay_mesh_criteria_2.h>
#include <CGAL/Delaunay_mesh_face_base_2.h>
#include <CGAL/Delaunay_mesh_vertex_base_2.h>
#include <CGAL/Delaunay_mesher_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_face_base_with_info_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

namespace crossfield
{
namespace
{
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
constexpr int None = -1;

/// Of a vertex: its boundary loop, and its number in the mesh that is read out.
struct VertexInfo
{
  int loop = None;
  int number = None;
};
/// Of a face: how many loops enclose it.
struct FaceInfo
{
  int depth = None;
};

using VertexBase = CGAL::Triangulation_vertex_base_with_info_2<VertexInfo, Kernel,
  CGAL::Delaunay_mesh_vertex_base_2<Kernel>>;
using FaceBase = CGAL::Triangulation_face_base_with_info_2<FaceInfo, Kernel,
  CGAL::Delaunay_mesh_face_base_2<Kernel>>;
using Structure = CGAL::Triangulation_data_structure_2<VertexBase, FaceBase>;
using Triangulation = CGAL::Constrained_Delaunay_triangulation_2<Kernel, Structure>;
using CgalPoint = Triangulation::Point;

CgalPoint ToCgal(const Point& point)
{
  return { point.x(), point.y() };
}

Point FromCgal(const CgalPoint& point)
{
  return { point.x(), point.y() };
}

[[noreturn]] void ThrowTouching(const Point& point)
{
  throw Error("The boundary crosses or touches itself near " + Describe(point) +
    "; separate or remove the segments that meet there.");
}

/// Inserts the segments of all loops; refuses loops that cross, overlap or touch.
Triangulation TriangulateLoops(const std::vector<Loop>& loops)
{
  Triangulation triangulation;
  std::size_t pointCount = 0;
  for (std::size_t l = 0; l < loops.size(); ++l)
  {
    std::vector<Triangulation::Vertex_handle> handles;
    Triangulation::Face_handle hint;
    for (const Point& point : loops[l])
    {
      handles.push_back(triangulation.insert(ToCgal(point), hint));
      hint = handles.back()->face();
      handles.back()->info().loop = static_cast<int>(l);
      if (triangulation.number_of_vertices() != ++pointCount)
      {
        ThrowTouching(point);
      }
    }
    for (std::size_t i = 0; i < handles.size(); ++i)
    {
      try
      {
        triangulation.insert_constraint(handles[i], handles[(i + 1) % handles.size()]);
      }
      catch (const Triangulation::Intersection_of_constraints_exception&)
      {
        ThrowTouching(loops[l][i]);
      }
    }
  }
  // A segment through another point is split there without an exception: then a vertex has other
  // than two constrained edges.
  for (auto vertex = triangulation.finite_vertices_begin();
       vertex != triangulation.finite_vertices_end(); ++vertex)
  {
    int constrained = 0;
    auto edge = triangulation.incident_edges(vertex);
    const auto end = edge;
    do
    {
      constrained += triangulation.is_constrained(*edge) ? 1 : 0;
    } while (++edge != end);
    if (constrained != 2)
    {
      ThrowTouching(FromCgal(vertex->point()));
    }
  }
  return triangulation;
}

/// Numbers every face by the count of loops that enclose it, and marks those of depth 1, the
/// domain, for the mesher.
void ComputeDepths(Triangulation& triangulation)
{
  for (auto face = triangulation.all_faces_begin(); face != triangulation.all_faces_end(); ++face)
  {
    face->info().depth = None;
  }
  std::vector<Triangulation::Face_handle> current = { triangulation.infinite_face() };
  current.front()->info().depth = 0;
  for (int depth = 0; !current.empty(); ++depth)
  {
    std::vector<Triangulation::Face_handle> next;
    while (!current.empty())
    {
      const Triangulation::Face_handle face = current.back();
      current.pop_back();
      if (face->info().depth != depth)
      {
        continue; // reached on a shorter way in the meantime
      }
      face->set_in_domain(depth == 1);
      for (int i = 0; i < 3; ++i)
      {
        const Triangulation::Face_handle neighbour = face->neighbor(i);
        if (neighbour->info().depth == None)
        {
          const bool crosses = triangulation.is_constrained({ face, i });
          neighbour->info().depth = depth + (crosses ? 1 : 0);
          (crosses ? next : current).push_back(neighbour);
        }
      }
    }
    current = std::move(next);
  }
}

/// Points on the loops at the spacing that the size field asks for; the given ones are kept.
std::vector<Loop> Subdivide(const std::vector<Loop>& loops, const SizeField& size)
{
  std::vector<Loop> result;
  for (const Loop& loop : loops)
  {
    Loop fine;
    for (std::size_t i = 0; i < loop.size(); ++i)
    {
      const Point& from = loop[i];
      const Point along = loop[(i + 1) % loop.size()] - from;
      const double length = along.norm();
      // March along the segment collecting ∫ ds / h; steps of h/4 resolve a size that varies by
      // at most the gradation.
      std::vector<std::pair<double, double>> marks = { { 0.0, 0.0 } };
      while (marks.back().first < 1.0)
      {
        const double here = size(from + marks.back().first * along);
        const double step = std::min(0.25 * here / length, 1.0 - marks.back().first);
        marks.emplace_back(marks.back().first + step, marks.back().second + step * length / here);
      }
      const auto pieces = std::max(1.0, std::round(marks.back().second));
      fine.push_back(from);
      std::size_t mark = 1;
      for (double piece = 1.0; piece < pieces; piece += 1.0)
      {
        const double wanted = marks.back().second * piece / pieces;
        while (marks[mark].second < wanted)
        {
          ++mark;
        }
        const auto& [t0, s0] = marks[mark - 1];
        const auto& [t1, s1] = marks[mark];
        fine.push_back(from + (t0 + (t1 - t0) * (wanted - s0) / (s1 - s0)) * along);
      }
    }
    result.push_back(std::move(fine));
  }
  return result;
}

/// Criteria of Delaunay_mesher_2: a triangle is bad when it has an angle below 27° (20.7° if it is
/// much smaller than wanted), or a longest edge well above the size wanted at its centre.
class GradedCriteria : public CGAL::Delaunay_mesh_criteria_2<Triangulation>
{
public:
  using Base = CGAL::Delaunay_mesh_criteria_2<Triangulation>;

  /// Ordered by how urgent the refinement is: oversized triangles first, then by their angle.
  struct Quality
  {
    double sineSquared = 1.0; ///< Of the smallest angle.
    double bound = 0.0;       ///< What it should be at least.
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
      const double wanted = this->Size((p[0] + p[1] + p[2]) / 3.0);
      // Between the lattice and the boundary triangles are up to half as long again as wanted.
      constexpr double Slack = 1.5;
      quality.oversize = lengths[2] / (Slack * Slack * wanted * wanted);
      // sin² 20.7° = 1/8: up to here the refinement provably ends (CGAL manual, Mesh_2). 27° is
      // asked of triangles above a fifth of the wanted size: their number is limited, so this ends too.
      const double sine = std::sin(27.0 / 180.0 * Pi);
      quality.bound = lengths[2] > 0.04 * wanted * wanted ? sine * sine : 0.125;
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

/// One point inside every inner loop: the centroid of the largest triangle there.
std::vector<CgalPoint> HoleSeeds(const Triangulation& triangulation, std::size_t loopCount)
{
  std::vector<double> areas(loopCount, 0.0);
  std::vector<CgalPoint> seeds(loopCount);
  for (auto face = triangulation.finite_faces_begin(); face != triangulation.finite_faces_end();
       ++face)
  {
    if (face->info().depth == 2)
    {
      // All corners of a triangle inside an inner loop lie on that loop.
      const auto loop = static_cast<std::size_t>(face->vertex(0)->info().loop);
      const double area = triangulation.triangle(face).area();
      if (area > areas[loop])
      {
        areas[loop] = area;
        seeds[loop] = CGAL::centroid(triangulation.triangle(face));
      }
    }
  }
  std::vector<CgalPoint> result;
  for (std::size_t loop = 0; loop < loopCount; ++loop)
  {
    if (areas[loop] > 0.0)
    {
      result.push_back(seeds[loop]);
    }
  }
  return result;
}

/// Whether a point keeps its distance, relative to the wanted size, from the vertices and segments
/// of the face that it lies in; points of a boundary-only triangulation near a segment or vertex
/// lie in a face that has it.
bool IsClear(const Triangulation::Face_handle& face, const Point& point, double size)
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
std::vector<CgalPoint> KeepClear(
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

/// Two rings of points around every hole, staggered against its vertices: the field is steepest
/// there, and the same triangles on all sides of a hole keep its numerical error even.
std::vector<Point> HoleRings(
  const PlanarDomain& domain, const std::vector<BoundaryEdge>& loopMarks, const SizeField& size)
{
  std::vector<Point> rings;
  for (std::size_t l = 0; l < domain.loops.size(); ++l)
  {
    if (loopMarks[l].kind != BoundaryKind::Hole)
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

/// Gives the points that the mesher put on a segment the number of that segment's loop.
void SpreadLoopNumbers(Triangulation& triangulation)
{
  std::vector<Triangulation::Vertex_handle> stack;
  for (auto vertex = triangulation.finite_vertices_begin();
       vertex != triangulation.finite_vertices_end(); ++vertex)
  {
    if (vertex->info().loop != None)
    {
      stack.push_back(vertex);
    }
  }
  while (!stack.empty())
  {
    const Triangulation::Vertex_handle vertex = stack.back();
    stack.pop_back();
    auto edge = triangulation.incident_edges(vertex);
    const auto end = edge;
    do
    {
      if (triangulation.is_constrained(*edge))
      {
        for (int other : { Triangulation::cw(edge->second), Triangulation::ccw(edge->second) })
        {
          const auto neighbour = edge->first->vertex(other);
          if (neighbour->info().loop == None)
          {
            neighbour->info().loop = vertex->info().loop;
            stack.push_back(neighbour);
          }
        }
      }
    } while (++edge != end);
  }
}

TriangleMesh ReadOut(Triangulation& triangulation, const std::vector<BoundaryEdge>& loopMarks)
{
  TriangleMesh mesh;
  for (auto face = triangulation.finite_faces_begin(); face != triangulation.finite_faces_end();
       ++face)
  {
    if (!face->is_in_domain())
    {
      continue;
    }
    std::array<int, 3> triangle;
    for (int i = 0; i < 3; ++i)
    {
      VertexInfo& info = face->vertex(i)->info();
      if (info.number == None)
      {
        info.number = static_cast<int>(mesh.points.size());
        mesh.points.push_back(FromCgal(face->vertex(i)->point()));
      }
      triangle[static_cast<std::size_t>(i)] = info.number;
    }
    mesh.triangles.push_back(triangle);
    for (int i = 0; i < 3; ++i)
    {
      if (face->is_constrained(i))
      {
        const auto from = face->vertex(Triangulation::ccw(i));
        const auto to = face->vertex(Triangulation::cw(i));
        BoundaryEdge edge = loopMarks[static_cast<std::size_t>(from->info().loop)];
        edge.vertices = { from->info().number, to->info().number };
        mesh.boundary.push_back(edge);
      }
    }
  }
  return mesh;
}
}

std::vector<int> NestingDepths(const std::vector<Loop>& loops)
{
  Triangulation triangulation = TriangulateLoops(loops);
  ComputeDepths(triangulation);
  std::vector<int> depths(loops.size(), std::numeric_limits<int>::max());
  for (auto edge = triangulation.finite_edges_begin(); edge != triangulation.finite_edges_end();
       ++edge)
  {
    if (triangulation.is_constrained(*edge))
    {
      const auto face = edge->first;
      const auto loop = static_cast<std::size_t>(
        face->vertex(Triangulation::cw(edge->second))->info().loop);
      depths[loop] = std::min(
        face->info().depth, face->neighbor(edge->second)->info().depth);
    }
  }
  return depths;
}

TriangleMesh TriangulateDomain(const PlanarDomain& domain,
  const std::vector<BoundaryEdge>& loopMarks, const SizeField& size, const Progress& progress)
{
  Triangulation triangulation = TriangulateLoops(Subdivide(domain.loops, size));
  ComputeDepths(triangulation);
  const std::vector<CgalPoint> seeds = HoleSeeds(triangulation, domain.loops.size());

  const std::vector<CgalPoint> rings =
    KeepClear(triangulation, HoleRings(domain, loopMarks, size), size);
  triangulation.insert(rings.begin(), rings.end());
  ComputeDepths(triangulation);
  const std::vector<CgalPoint> bulk = KeepClear(triangulation, GradedLattice(size), size);
  progress.Report(0.3);
  triangulation.insert(bulk.begin(), bulk.end());
  progress.Report(0.5);

  CGAL::Delaunay_mesher_2<Triangulation, GradedCriteria> mesher(
    triangulation, GradedCriteria(size));
  mesher.set_seeds(seeds.begin(), seeds.end(), false);
  mesher.init();
  // Asked now and then whether to stop; the number of steps to come is not known.
  constexpr int StepsBetweenReports = 4096;
  for (int step = 1; mesher.try_one_step_refine_mesh(); ++step)
  {
    if (step % StepsBetweenReports == 0)
    {
      progress.Report(0.5 + 0.4 * (1.0 - 1.0 / (1.0 + step * 1e-5)));
    }
  }
  SpreadLoopNumbers(triangulation);
  TriangleMesh mesh = ReadOut(triangulation, loopMarks);
  progress.Report(1.0);
  return mesh;
}
}
