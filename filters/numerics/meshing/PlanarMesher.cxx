// The one file that includes CGAL: its headers take long to compile.
#include "PlanarMesher.h"

#include "Error.h"
#include "MemoryBudget.h"
#include "MeshBudget.h"
#include "MesherCore.h"
#include "MesherCriteria.h"
#include "MesherPoints.h"
#include "MesherReadOut.h"
#include "MesherTriangulation.h"
#include "PointLattice.h"
#include "Segment.h"

#include <CGAL/Delaunay_mesher_2.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <sstream>
#include <string>

namespace crossfield
{
namespace
{
using namespace mesher;

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

/// Where boundaries come much closer than the edges wanted, on either side, refinement adds as many
/// points as the gap fits into its length. The other points are there before, so this is what gaps
/// may cost: three hundred thousand triangles, about a second, and as many as were there: along a boundary of very
/// many points on a circle, whose Delaunay triangles are flat ones, refinement adds nearly as many as the
/// lattice had.
constexpr std::size_t MostAddedVertices = 150000;

/// Names the place where a segment comes nearest to a vertex that is not its end.
[[noreturn]] void ThrowNarrow(const Triangulation& loops)
{
  double narrowest = std::numeric_limits<double>::infinity();
  Point place = Point::Zero();
  for (auto face = loops.finite_faces_begin(); face != loops.finite_faces_end(); ++face)
  {
    for (int i = 0; i < 3; ++i)
    {
      const Point from = FromCgal(face->vertex(Triangulation::ccw(i))->point());
      const Point to = FromCgal(face->vertex(Triangulation::cw(i))->point());
      const Point apex = FromCgal(face->vertex(i)->point());
      // From the segment, not from its line: the next vertex of a fine polyline lies low over the line.
      const double distance = WayFromSegment(apex, from, to).norm();
      if (face->is_constrained(i) && distance < narrowest)
      {
        narrowest = distance;
        place = apex;
      }
    }
  }
  std::ostringstream text;
  text.precision(3);
  text
    << "The boundary comes within " << narrowest << " of itself near " << Describe(place)
    << ", and triangles as small as this gap were not asked for; widen the gap, close it, or give "
       "a mesh size of its width.";
  throw Error(text.str());
}

/// Whether each loop is an imprinted circle, which separates nothing.
std::vector<bool> FindImprinted(const std::vector<BoundaryEdge>& loopMarks)
{
  std::vector<bool> imprinted;
  imprinted.reserve(loopMarks.size());
  for (const BoundaryEdge& mark : loopMarks)
  {
    imprinted.push_back(mark.kind == BoundaryKind::ImprintedCircle);
  }
  return imprinted;
}

/// Numbers every face by the count of loops that enclose it, those that are imprinted not counted,
/// and marks those of depth 1, the domain, for the mesher.
void ComputeDepths(Triangulation& triangulation, const std::vector<bool>& imprinted)
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
          // Loops do not touch: the ends of a segment are of the same one.
          const bool crosses = triangulation.is_constrained({ face, i }) &&
            !imprinted[static_cast<std::size_t>(face->vertex(Triangulation::cw(i))->info().loop)];
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

[[noreturn]] void ThrowBroken()
{
  throw Error(
    "The triangulation of the domain broke down; simplify the boundary where it is finest "
    "or nearly touches itself.");
}
}

std::vector<int> NestingDepths(const std::vector<Loop>& loops)
{
  Triangulation triangulation = TriangulateLoops(loops);
  ComputeDepths(triangulation, std::vector<bool>(loops.size(), false));
  std::vector<int> depths(loops.size(), std::numeric_limits<int>::max());
  for (auto edge = triangulation.finite_edges_begin(); edge != triangulation.finite_edges_end();
       ++edge)
  {
    if (triangulation.is_constrained(*edge))
    {
      const auto face = edge->first;
      const auto loop =
        static_cast<std::size_t>(face->vertex(Triangulation::cw(edge->second))->info().loop);
      depths[loop] = std::min(face->info().depth, face->neighbor(edge->second)->info().depth);
    }
  }
  return depths;
}

TriangleMesh TriangulateDomain(const PlanarDomain& domain,
  const std::vector<BoundaryEdge>& loopMarks, const SizeField& size, const Progress& progress,
  const std::vector<Point>& vertices)
try
{
  Triangulation triangulation = TriangulateLoops(Subdivide(domain.loops, size));
  const std::vector<bool> imprinted = FindImprinted(loopMarks);
  ComputeDepths(triangulation, imprinted);
  const std::vector<CgalPoint> holeSeeds = HoleSeeds(triangulation, domain.loops.size());

  const std::vector<CgalPoint> rings =
    KeepClear(triangulation, HoleRings(domain, loopMarks, size), size);
  triangulation.insert(rings.begin(), rings.end());
  for (const Point& vertex : vertices)
  {
    triangulation.insert(ToCgal(vertex));
  }
  ComputeDepths(triangulation, imprinted);
  const GradedLattice lattice = MakeGradedLattice(size);
  const std::vector<Point> others = OtherPoints(triangulation, lattice);
  const auto isInside = [&triangulation, hint = Triangulation::Face_handle()](
                          const Point& point) mutable
  {
    hint = triangulation.locate(ToCgal(point), hint);
    return !triangulation.is_infinite(hint) && hint->is_in_domain();
  };
  progress.Report(0.3);
  const LatticeCore core(lattice.coarsest, others, CoreMargin, isInside);
  const std::vector<std::size_t> corners = CornersOf(core);
  const std::vector<CgalPoint> bulk =
    KeepClear(triangulation, OutsideOf(core, corners, lattice), size);
  // What was predicted is right within a factor of two where holes grade the mesh. There are two
  // triangles to a point; the lattice and the points kept of it are in memory already.
  const std::size_t triangles = 2 * bulk.size() + core.GetTriangles().size();
  RequireMemory(static_cast<double>(triangles) * (MeshBytesPerTriangle - sizeof(CgalPoint)),
    "A mesh with " + std::to_string(triangles) + " triangles",
    "choose a larger edge length, larger holes or a larger gradation");
  triangulation.insert(bulk.begin(), bulk.end());
  const std::vector<Ends> border = InsertBorder(core, corners, triangulation);
  progress.Report(0.5);

  std::vector<CgalPoint> seeds = CoreSeeds(core);
  seeds.insert(seeds.end(), holeSeeds.begin(), holeSeeds.end());
  CGAL::Delaunay_mesher_2<Triangulation, GradedCriteria> mesher(
    triangulation, GradedCriteria(size));
  mesher.set_seeds(seeds.begin(), seeds.end(), false);
  mesher.init();
  const std::size_t inCore = core.GetTriangles().size() / 2;
  const std::size_t mostVertices =
    2 * (triangulation.number_of_vertices() + inCore) + MostAddedVertices;
  // Asked now and then whether to stop; the number of steps to come is not known.
  constexpr int StepsBetweenReports = 4096;
  for (int step = 1; mesher.try_one_step_refine_mesh(); ++step)
  {
    if (step % StepsBetweenReports == 0)
    {
      progress.Report(0.5 + 0.4 * (1.0 - 1.0 / (1.0 + step * 1e-5)));
      if (triangulation.number_of_vertices() > mostVertices)
      {
        ThrowNarrow(TriangulateLoops(domain.loops));
      }
    }
  }
  for (const Ends& ends : border)
  {
    if (!triangulation.is_edge(ends[0], ends[1]))
    {
      ThrowBroken();
    }
  }
  SpreadLoopNumbers(triangulation);
  TriangleMesh mesh = ReadOut(triangulation, domain, loopMarks, core).Take();
  progress.Report(1.0);
  return mesh;
}
catch (const CGAL::Failure_exception&) // its text is of several lines about CGAL's source
{
  ThrowBroken();
}

//------------------------------------------------------------------------------
struct KeptTriangulation::Kept
{
  Triangulation triangulation;
  PlanarDomain domain;
  std::vector<BoundaryEdge> loopMarks;
};

KeptTriangulation::KeptTriangulation(
  PlanarDomain domain, std::vector<BoundaryEdge> loopMarks, const std::vector<Point>& points)
{
  Triangulation triangulation = TriangulateLoops(domain.loops);
  std::vector<CgalPoint> inside;
  inside.reserve(points.size());
  std::transform(points.begin(), points.end(), std::back_inserter(inside), ToCgal);
  triangulation.insert(inside.begin(), inside.end());
  this->What = std::make_unique<const Kept>(
    Kept{ std::move(triangulation), std::move(domain), std::move(loopMarks) });
}

KeptTriangulation::~KeptTriangulation() = default;

TriangleMesh KeptTriangulation::With(const std::vector<Point>& points, double clear) const
{
  Triangulation triangulation = this->What->triangulation;
  std::vector<Triangulation::Vertex_handle> put;
  for (const Point& point : points)
  {
    put.push_back(triangulation.insert(ToCgal(point)));
  }
  for (const Triangulation::Vertex_handle& vertex : put)
  {
    const Point place = FromCgal(vertex->point());
    // The nearest of all vertices is a neighbour.
    for (bool found = true; found;)
    {
      found = false;
      auto neighbour = triangulation.incident_vertices(vertex);
      const auto end = neighbour;
      do
      {
        found = neighbour->info().loop == None && // neither infinite nor on the boundary
          !triangulation.is_infinite(neighbour) &&
          (FromCgal(neighbour->point()) - place).norm() < clear &&
          std::find(put.begin(), put.end(), neighbour) == put.end();
      } while (!found && ++neighbour != end);
      if (found)
      {
        triangulation.remove(neighbour);
      }
    }
  }
  ComputeDepths(triangulation, FindImprinted(this->What->loopMarks));
  return ReadOut(triangulation, this->What->domain, this->What->loopMarks, {}).Take();
}
}
