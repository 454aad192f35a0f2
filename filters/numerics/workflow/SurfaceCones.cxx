#include "SurfaceCones.h"

#include "BoundaryCorners.h"
#include "Error.h"
#include "Index.h"
#include "NodeIndices.h"
#include "PoincareHopf.h"
#include "SurfaceParts.h"
#include "SurfaceTopology.h"
#include "VertexPlacement.h"
#include "VertexPotential.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <deque>
#include <limits>
#include <utility>

namespace crossfield
{
namespace
{
double LongestSide(const SurfaceMesh& surface, int triangle)
{
  const auto& v = surface.triangles[triangle];
  double longest = 0.0;
  for (std::size_t i = 0; i < 3; ++i)
  {
    longest = std::max(longest, (surface.points[v[(i + 1) % 3]] - surface.points[v[i]]).norm());
  }
  return longest;
}

/// Returns vertices − edges + triangles of a connected surface.
int EulerCharacteristicOf(const SurfaceMesh& surface)
{
  std::size_t sides = 0; // inner edges have two
  for (const std::array<int, 3>& neighbours : FindNeighbours(surface))
  {
    for (const int neighbour : neighbours)
    {
      sides += neighbour < 0 ? 2 : 1;
    }
  }
  return static_cast<int>(surface.points.size()) - static_cast<int>(sides / 2) +
    static_cast<int>(surface.triangles.size());
}

/// Returns for each face the region that has the largest part of its area.
std::vector<int> RegionsOfFaces(const SurfaceMesh& surface, const CutSurface& cut)
{
  std::vector<std::map<int, double>> areas(cut.faces.size());
  for (std::size_t t = 0; t < surface.triangles.size(); ++t)
  {
    areas[Index(cut.faceOf[t])][surface.RegionOf(t)] += AreaOf(surface, t);
  }
  std::vector<int> regions;
  for (const std::map<int, double>& ofFace : areas)
  {
    regions.push_back(std::max_element(ofFace.begin(), ofFace.end(),
      [](const auto& x, const auto& y) {
        return x.second < y.second;
      })->first);
  }
  return regions;
}

/// Returns the distance of a place from the lines of a cut surface.
double DistanceFromLines(const CutSurface& cut, const SpacePoint& place)
{
  double distance = std::numeric_limits<double>::infinity();
  for (const FeatureLine& line : cut.lines)
  {
    const std::vector<SpacePoint>& points = cut.faces[Index(line.faces[0])].points;
    const std::vector<int>& along = line.points[0];
    for (std::size_t i = line.isClosed ? 0 : 1; i < along.size(); ++i)
    {
      const int before = i == 0 ? along.back() : along[i - 1];
      const SpacePoint nearest =
        NearestOnSide(points[Index(before)], points[Index(along[i])], place);
      distance = std::min(distance, (nearest - place).norm());
    }
  }
  return distance;
}

std::string DescribeSingularity(const SurfaceSingularity& one, int row)
{
  return "Singularity " + std::to_string(row + 1) + " at " + DescribeInSpace(one.place);
}

/// Places singularities on vertices of faces.
class SingularityPlacement
{
public:
  explicit SingularityPlacement(CutSurface& cut)
    : Cut(cut)
    , Cones(cut.faces.size())
    , Events(cut.faces.size())
  {
    for (SurfaceMesh& face : cut.faces)
    {
      this->Placements.emplace_back(face);
      for (const SpacePoint& point : face.points)
      {
        this->Box.extend(point);
      }
    }
  }

  void Place(const SurfaceSingularity& one, int row)
  {
    const std::string what = DescribeSingularity(one, row);
    std::size_t face = 0;
    SurfacePoint point;
    for (std::size_t f = 0; f < this->Cut.faces.size(); ++f)
    {
      const SurfacePoint here = FindNearest(this->Cut.faces[f], one.place);
      if (f == 0 || here.distance < point.distance)
      {
        face = f;
        point = here;
      }
    }
    const SurfaceMesh& surface = this->Cut.faces[face];
    // The triangles of a curved surface are off it by less.
    if (!(point.distance <= LongestSide(surface, point.triangle)))
    {
      throw Error(what + " is " + FormatNumber(point.distance) +
        " off the surface; move it to the nearest point of it, " + DescribeInSpace(point.place) +
        ".");
    }
    if (one.quarterIndex == 0)
    {
      return;
    }
    if (DistanceFromLines(this->Cut, point.place) <= BoundaryReach * this->Box.diagonal().norm())
    {
      this->Events[face].push_back(
        what + " is on a line between faces, whose angles determine it.");
      return;
    }
    const auto placed = this->Placements[face].Place(point);
    if (!placed)
    {
      throw Error(what + " has no vertex of its own inside the surface",
        "use smaller triangles there", Error::Kind::CoarseMesh);
    }
    if (placed->distance > 0.0)
    {
      this->Events[face].push_back(what + " is at the vertex " +
        DescribeInSpace(surface.points[placed->vertex]) +
        ", since triangles would be too thin otherwise.");
    }
    this->Cones[face].push_back({ placed->vertex, one.quarterIndex, false, row });
  }

private:
  CutSurface& Cut;
  std::deque<VertexPlacement> Placements; ///< Of all faces.
  Eigen::AlignedBox3d Box;

public:
  std::vector<std::vector<Cone>> Cones; ///< Per face.
  std::vector<std::vector<std::string>> Events;
};

/// Adds the corners of the boundary but for nodes, with the quarter indices nearest to their angles, at most 1:
/// maps have no corner without an angle.
void AddCorners(const std::vector<bool>& isNode, ConedSurface& face)
{
  constexpr int Maximum = 1;
  const MeshTopology& topology = *face.topology;
  for (int i = 0; i < static_cast<int>(topology.mesh.boundary.size()); ++i)
  {
    const int vertex = topology.BoundaryAt(i).vertices[0];
    const auto nearest = static_cast<int>(std::lround(topology.turning[i] / (0.5 * Pi)));
    const int quarters = std::min(Maximum, nearest);
    if (topology.corners[vertex] && !isNode[Index(vertex)] && quarters != 0)
    {
      face.cones.push_back({ vertex, quarters, true, -1 });
    }
  }
}

int SumOf(const std::vector<Cone>& cones, bool onBoundary)
{
  int sum = 0;
  for (const Cone& cone : cones)
  {
    sum += cone.onBoundary == onBoundary ? cone.quarterIndex : 0;
  }
  return sum;
}

/// Adds the corners of all faces: those at a common node together.
void AddCorners(SurfaceBody& body)
{
  std::vector<std::vector<bool>> isNode;
  std::vector<std::vector<double>> angles; // at the vertices of faces
  for (const ConedSurface& face : body.faces)
  {
    isNode.emplace_back(face.topology->VertexCount(), false);
    angles.emplace_back(face.topology->VertexCount(), Pi);
    for (int i = 0; i < static_cast<int>(face.topology->mesh.boundary.size()); ++i)
    {
      angles.back()[Index(face.topology->BoundaryAt(i).vertices[0])] =
        Pi - face.topology->turning[i];
    }
  }
  std::vector<NodeCorners> nodes;
  for (const FeatureNode& node : body.nodes)
  {
    NodeCorners& corners = nodes.emplace_back();
    corners.isOnBoundary = node.isOnBoundary;
    for (const FacePoint& corner : node.corners)
    {
      isNode[Index(corner.face)][Index(corner.point)] = true;
      corners.corners.push_back(
        { corner.face, angles[Index(corner.face)][Index(corner.point)], std::nullopt });
    }
  }
  std::vector<int> required;
  for (std::size_t f = 0; f < body.faces.size(); ++f)
  {
    ConedSurface& face = body.faces[f];
    AddCorners(isNode[f], face);
    required.push_back(face.RequiredQuarters() - face.GivenQuarters());
  }
  const std::vector<std::vector<int>> chosen = ChooseNodeIndices(nodes, required);
  for (std::size_t n = 0; n < nodes.size(); ++n)
  {
    for (std::size_t c = 0; c < chosen[n].size(); ++c)
    {
      const FacePoint& corner = body.nodes[n].corners[c];
      if (chosen[n][c] != 0)
      {
        body.faces[Index(corner.face)].cones.push_back({ corner.point, chosen[n][c], true, -1 });
      }
    }
  }
}

/// Adds the numbers and corners of a part.
void AddNumbers(const ConedSurface& part, SurfaceCheck& check)
{
  const MeshTopology& topology = *part.topology;
  check.eulerCharacteristic += topology.edges.EulerCharacteristic(topology.mesh);
  check.requiredQuarters += part.RequiredQuarters();
  check.givenQuarters += part.GivenQuarters();
  check.totalCurvature += topology.charts->curvature.sum() / (2.0 * Pi);
  check.tangentTurning += topology.turning.sum() / (2.0 * Pi);
  const std::vector<int> quarters = QuartersOfVertices(topology, part.cones);
  for (int i = 0; i < static_cast<int>(topology.mesh.boundary.size()); ++i)
  {
    const int vertex = topology.BoundaryAt(i).vertices[0];
    if (quarters[vertex] != 0)
    {
      check.corners.push_back(
        { topology.PositionOf(vertex), Pi - topology.turning[i], quarters[vertex] });
    }
  }
}
}

bool SurfaceBody::IsWhole() const
{
  return this->lines.empty() && this->nodes.empty() &&
    std::all_of(this->boundaryNames.begin(), this->boundaryNames.end(),
      [](const std::map<int, int>& names) { return names.empty(); });
}

int ConedSurface::RequiredQuarters() const
{
  return 4 * this->topology->edges.EulerCharacteristic(this->topology->mesh) -
    SumOf(this->cones, true);
}

int ConedSurface::GivenQuarters() const
{
  return SumOf(this->cones, false);
}

std::string DescribeQuarters(const ConedSurface& part)
{
  const std::string corners = part.topology->loops.empty()
    ? ""
    : " whose corners have " + std::to_string(SumOf(part.cones, true));
  return "The quarter indices of singularities add up to " + std::to_string(part.GivenQuarters()) +
    ", and a surface of Euler characteristic " +
    std::to_string(part.topology->edges.EulerCharacteristic(part.topology->mesh)) + corners +
    " needs " + std::to_string(part.RequiredQuarters()) + "; give singularities with this sum.";
}

std::string DescribeHolonomy(const std::vector<double>& defects)
{
  double largest = 0.0;
  for (const double defect : defects)
  {
    largest = std::max(largest, std::abs(defect));
  }
  return "The quarter indices of singularities and corners add up to 4χ" +
    (largest > NoticeableDefect ? "; crosses do not close up around a handle or loop by " +
          CrossAngle(largest) + ", so quads are stretched there."
                                : std::string("."));
}

FeaturedParts FindFeaturedParts(
  SurfaceMesh surface, const std::vector<SurfaceSingularity>& singularities, double featureAngle)
{
  SurfaceParts found = FindSurfaceParts(std::move(surface));
  FeaturedParts result;
  result.events = std::move(found.events);
  for (SurfaceMesh& part : found.parts)
  {
    FeaturedPart& one = result.parts.emplace_back();
    one.features = FindFeatureEdges(part, featureAngle);
    one.surface = std::move(part);
    result.events.insert(
      result.events.end(), one.features.events.begin(), one.features.events.end());
  }
  for (std::size_t i = 0; i < singularities.size(); ++i)
  {
    const auto distanceFrom = [&](const FeaturedPart& part)
    { return FindNearest(part.surface, singularities[i].place).distance; };
    FeaturedPart* nearest = &result.parts.front();
    double distance = result.parts.size() == 1 ? 0.0 : distanceFrom(*nearest);
    for (std::size_t p = 1; p < result.parts.size(); ++p)
    {
      const double here = distanceFrom(result.parts[p]);
      if (here < distance)
      {
        nearest = &result.parts[p];
        distance = here;
      }
    }
    nearest->singularities.push_back(singularities[i]);
    nearest->rows.push_back(static_cast<int>(i));
  }
  return result;
}

SurfaceBody PlaceCones(const FeaturedPart& part)
{
  SurfaceBody body;
  body.eulerCharacteristic = EulerCharacteristicOf(part.surface);
  CutSurface cut;
  if (part.features.count == 0 && part.surface.lines.empty())
  {
    cut.faces.push_back(part.surface);
    cut.faceOf.assign(part.surface.triangles.size(), 0);
    cut.boundaryNames.resize(1);
  }
  else
  {
    cut = CutAlongFeatures(part.surface, part.features);
  }
  body.regionOf = RegionsOfFaces(part.surface, cut);
  SingularityPlacement placement(cut);
  for (std::size_t i = 0; i < part.singularities.size(); ++i)
  {
    placement.Place(part.singularities[i], part.rows[i]);
  }
  for (std::size_t f = 0; f < cut.faces.size(); ++f)
  {
    body.faces.push_back({ std::make_shared<const SurfaceTopology>(std::move(cut.faces[f])),
      std::move(placement.Cones[f]), std::move(placement.Events[f]) });
    body.area += body.faces.back().topology->Area();
  }
  body.faceOf = std::move(cut.faceOf);
  body.lines = std::move(cut.lines);
  body.nodes = std::move(cut.nodes);
  body.boundaryNames = std::move(cut.boundaryNames);
  AddCorners(body);
  return body;
}

ConedSurfaces PlaceCones(
  SurfaceMesh surface, const std::vector<SurfaceSingularity>& singularities, double featureAngle)
{
  FeaturedParts found = FindFeaturedParts(std::move(surface), singularities, featureAngle);
  ConedSurfaces result;
  result.events = std::move(found.events);
  for (const FeaturedPart& part : found.parts)
  {
    result.bodies.push_back(PlaceCones(part));
  }
  return result;
}

std::string DescribeFace(const ConedSurface& face)
{
  const MeshTopology& topology = *face.topology;
  const auto centreOf = [&topology](int triangle)
  {
    SpacePoint centre = SpacePoint::Zero();
    for (const int vertex : topology.mesh.triangles[triangle])
    {
      centre += topology.PositionOf(vertex) / 3.0;
    }
    return centre;
  };
  SpacePoint middle = SpacePoint::Zero();
  for (int t = 0; t < topology.TriangleCount(); ++t)
  {
    middle += topology.AreaOf(t) * centreOf(t);
  }
  middle /= topology.Area();
  SpacePoint nearest = centreOf(0);
  for (int t = 1; t < topology.TriangleCount(); ++t)
  {
    const SpacePoint centre = centreOf(t);
    nearest = (centre - middle).norm() < (nearest - middle).norm() ? centre : nearest;
  }
  return "Face at " + DescribeInSpace(nearest);
}

std::vector<const ConedSurface*> ConedSurfaces::Faces() const
{
  std::vector<const ConedSurface*> faces;
  for (const SurfaceBody& body : this->bodies)
  {
    for (const ConedSurface& face : body.faces)
    {
      faces.push_back(&face);
    }
  }
  return faces;
}

SurfaceCheck CheckSurface(const ConedSurfaces& surfaces)
{
  SurfaceCheck check;
  const std::vector<const ConedSurface*> faces = surfaces.Faces();
  for (const ConedSurface* face : faces)
  {
    AddNumbers(*face, check);
  }
  for (std::size_t f = 0; f < faces.size(); ++f)
  {
    if (faces[f]->GivenQuarters() != faces[f]->RequiredQuarters())
    {
      check.reason = faces.size() == 1 ? "" : DescribeFace(*faces[f]) + ": ";
      check.reason += DescribeQuarters(*faces[f]);
      return check;
    }
  }
  check.consistent = true;
  for (const ConedSurface* face : faces)
  {
    for (const double defect : VertexPotential(face->topology)
                                 .Solve(QuartersOfVertices(*face->topology, face->cones))
                                 .holonomyDefect)
    {
      check.holonomyDefect.push_back(defect);
    }
  }
  check.reason = DescribeHolonomy(check.holonomyDefect);
  return check;
}
}
