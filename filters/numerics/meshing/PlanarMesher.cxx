// The only file that includes CGAL, whose headers take long to compile.
#include "PlanarMesher.h"

#include "Error.h"
#include "MemoryBudget.h"
#include "MeshBudget.h"
#include "MesherCore.h"
#include "MesherCriteria.h"
#include "MesherLoops.h"
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
#include <map>
#include <sstream>
#include <string>
#include <utility>

namespace crossfield
{
namespace
{
using namespace mesher;

/// Maximum number of vertices that refinement may add beyond doubling their number.
///
/// Where boundaries are much closer to each other than the target size, on either side, refinement
/// adds as many points as the gap fits into its length. All other points are inserted beforehand,
/// so this limits what gaps may cost: three hundred thousand triangles, about a second. Doubling is
/// permitted because along a boundary of very many points on a circle, whose Delaunay triangles are
/// flat, refinement adds nearly as many points as the lattice had.
constexpr std::size_t MaximumAddedVertices = 150000;

/// Throws an Error that names the point where a segment is closest to a vertex other than its ends.
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
      // Distance from the segment rather than from its line, because the next vertex of a fine
      // polyline is close to that line.
      const double distance = OffsetFromSegment(apex, from, to).norm();
      if (face->is_constrained(i) && distance < narrowest)
      {
        narrowest = distance;
        place = apex;
      }
    }
  }
  std::ostringstream text;
  text.precision(3);
  text << "The boundary comes within " << narrowest << " of itself near " << Describe(place)
       << ", much less than the target size of triangles there; widen the gap, close it, or give "
          "a mesh size of its width.";
  throw Error(text.str());
}

/// Divides the segments of loops by the spacing of the size field; the given points are retained.
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
      // Integrates ds / h along the segment; steps of h/4 resolve a size that varies by at most the
      // gradation.
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
        const double target = marks.back().second * piece / pieces;
        while (marks[mark].second < target)
        {
          ++mark;
        }
        const auto& [t0, s0] = marks[mark - 1];
        const auto& [t1, s1] = marks[mark];
        fine.push_back(from + (t0 + (t1 - t0) * (target - s0) / (s1 - s0)) * along);
      }
    }
    result.push_back(std::move(fine));
  }
  return result;
}

/// Returns the points of a mesh from the coordinates of a frame to the plane. Given points are
/// restored as they were given.
void MoveFromFrame(const CanonicalFrame& frame, const PlanarDomain& domain,
  const std::vector<Point>& vertices, std::vector<Point>& points)
{
  std::map<std::pair<double, double>, Point> given;
  const auto add = [&](const Point& point)
  {
    const Point coordinates = frame.ToFrame(point);
    given.emplace(std::pair(coordinates.x(), coordinates.y()), point);
  };
  for (const Loop& loop : domain.loops)
  {
    std::for_each(loop.begin(), loop.end(), add);
  }
  std::for_each(vertices.begin(), vertices.end(), add);
  for (Point& point : points)
  {
    const auto found = given.find({ point.x(), point.y() });
    point = found == given.end() ? frame.FromFrame(point) : found->second;
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

TriangleMesh TriangulateDomain(const PlanarDomain& given,
  const std::vector<BoundaryEdge>& loopMarks, const SizeField& size, const Progress& progress,
  const std::vector<Point>& vertices, const CanonicalFrame& frame)
try
{
  const PlanarDomain domain{ frame.ToFrame(given.loops) };
  Triangulation triangulation = TriangulateLoops(Subdivide(domain.loops, size));
  const std::vector<bool> imprinted = FindImprinted(loopMarks);
  ComputeDepths(triangulation, imprinted);
  const std::vector<CgalPoint> holeSeeds = HoleSeeds(triangulation, domain.loops.size());

  const std::vector<CgalPoint> rings =
    SelectClear(triangulation, HoleRings(domain, loopMarks, size), size);
  triangulation.insert(rings.begin(), rings.end());
  for (const Point& vertex : vertices)
  {
    triangulation.insert(ToCgal(frame.ToFrame(vertex)));
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
  const std::vector<std::size_t> corners = BorderVertices(core);
  const std::vector<CgalPoint> bulk =
    SelectClear(triangulation, PointsOutsideCore(core, corners, lattice), size);
  // The prediction is accurate within a factor of two where holes grade the mesh. There are two
  // triangles per point; the lattice and its selected points are in memory already.
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
  const std::size_t maximumVertices =
    2 * (triangulation.number_of_vertices() + inCore) + MaximumAddedVertices;
  // Progress is reported from time to time, which allows an abort; the number of steps ahead is
  // unknown.
  constexpr int StepsBetweenReports = 4096;
  for (int step = 1; mesher.try_one_step_refine_mesh(); ++step)
  {
    if (step % StepsBetweenReports == 0)
    {
      progress.Report(0.5 + 0.4 * (1.0 - 1.0 / (1.0 + step * 1e-5)));
      if (triangulation.number_of_vertices() > maximumVertices)
      {
        ThrowNarrow(TriangulateLoops(given.loops));
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
  TriangleMesh mesh = MeshExtractor(triangulation, domain, loopMarks, core).Release();
  if (!frame.IsIdentity())
  {
    MoveFromFrame(frame, given, vertices, mesh.points);
  }
  progress.Report(1.0);
  return mesh;
}
catch (const CGAL::Failure_exception&) // its message has several lines about CGAL's source
{
  ThrowBroken();
}

//------------------------------------------------------------------------------
struct BaseTriangulation::State
{
  Triangulation triangulation;
  PlanarDomain domain;
  std::vector<BoundaryEdge> loopMarks;
};

BaseTriangulation::BaseTriangulation(
  PlanarDomain domain, std::vector<BoundaryEdge> loopMarks, const std::vector<Point>& points)
{
  Triangulation triangulation = TriangulateLoops(domain.loops);
  std::vector<CgalPoint> inside;
  inside.reserve(points.size());
  std::transform(points.begin(), points.end(), std::back_inserter(inside), ToCgal);
  triangulation.insert(inside.begin(), inside.end());
  this->Current = std::make_unique<const State>(
    State{ std::move(triangulation), std::move(domain), std::move(loopMarks) });
}

BaseTriangulation::~BaseTriangulation() = default;

TriangleMesh BaseTriangulation::With(const std::vector<Point>& points, double clear) const
{
  Triangulation triangulation = this->Current->triangulation;
  std::vector<Triangulation::Vertex_handle> inserted;
  for (const Point& point : points)
  {
    inserted.push_back(triangulation.insert(ToCgal(point)));
  }
  for (const Triangulation::Vertex_handle& vertex : inserted)
  {
    const Point place = FromCgal(vertex->point());
    // The nearest vertex is always a neighbour.
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
          std::find(inserted.begin(), inserted.end(), neighbour) == inserted.end();
      } while (!found && ++neighbour != end);
      if (found)
      {
        triangulation.remove(neighbour);
      }
    }
  }
  ComputeDepths(triangulation, FindImprinted(this->Current->loopMarks));
  return MeshExtractor(triangulation, this->Current->domain, this->Current->loopMarks, {})
    .Release();
}
}
