#include "SweepQuads.h"

#include "ElementNodes.h"
#include "Error.h"
#include "Index.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <set>

namespace crossfield
{
namespace
{
constexpr double FullTurn = 360.0; // degrees
// Nodes nearer to the axis or the plane than this part of the extent differ from it by rounding.
constexpr double PlaneRounding = 1e-9;

double ExtentOf(const std::vector<Eigen::Vector3d>& points)
{
  Eigen::AlignedBox3d box;
  for (const Eigen::Vector3d& point : points)
  {
    box.extend(point);
  }
  return box.diagonal().norm();
}

/// Returns the unit normal from which the quads are counter-clockwise.
Eigen::Vector3d NormalOf(const SolverMesh& quads)
{
  const CellLattice lattice(2, quads.order);
  Eigen::Vector3d area = Eigen::Vector3d::Zero(); // twice the sum of the areas
  for (int cell = 0; cell < quads.CellCount(); ++cell)
  {
    const auto corner = [&](int i) -> const Eigen::Vector3d&
    { return quads.points[quads.Cell(cell)[lattice.Corner(i)]]; };
    area += (corner(2) - corner(0)).cross(corner(3) - corner(1));
  }
  if (quads.HasConstantHeight())
  {
    return Eigen::Vector3d::UnitZ() * (area.z() < 0.0 ? -1.0 : 1.0);
  }
  const Eigen::Vector3d normal = area.normalized();
  const Eigen::Vector3d& origin = quads.points.front();
  const double tolerance = PlaneRounding * ExtentOf(quads.points);
  for (std::size_t i = 0; i < quads.points.size(); ++i)
  {
    if (!(std::abs(normal.dot(quads.points[i] - origin)) <= tolerance))
    {
      throw Error("The node at " + PlaceOf(quads, static_cast<int>(i)) +
        " is not in the plane of the others; extrude quads in a plane.");
    }
  }
  return normal;
}

void RequireValid(const SolverMesh& quads, const Sweep& sweep)
{
  if (quads.dimension != 2 || quads.region.empty())
  {
    throw Error("There are no quads to sweep; give the quads of a Quad Mesher.");
  }
  if (quads.order > 2)
  {
    throw Error("Quads of order 3 cannot be swept; use order 1 or 2.");
  }
  if (sweep.layers < 1)
  {
    throw Error("The number of layers is " + std::to_string(sweep.layers) + "; give at least 1.");
  }
  if (sweep.kind == Sweep::Translation && !(sweep.height > 0.0 && std::isfinite(sweep.height)))
  {
    throw Error("The height of an extrusion must be positive.");
  }
  if (!(sweep.ratio > 0.0 && std::isfinite(sweep.ratio)))
  {
    throw Error("The ratio of the last to the first layer must be positive.");
  }
  if (!(sweep.axisDirection.norm() > 0.0 && sweep.axisDirection.allFinite() &&
        sweep.axisPoint.allFinite()))
  {
    throw Error("The axis of a revolution needs two different points.");
  }
  if (sweep.kind == Sweep::Rotation && !(sweep.angle > 0.0 && sweep.angle <= FullTurn))
  {
    throw Error("The angle of a revolution must be more than 0 and at most 360 degrees.");
  }
  if (sweep.kind == Sweep::Rotation && !quads.HasConstantHeight())
  {
    throw Error(
      "The quads are not in a plane z = const, in which the axis of a revolution is; rotate the "
      "domain.");
  }
}

/// Returns the part of a sweep at a level, `order` levels in each layer.
double PartAt(const Sweep& sweep, int order, int level)
{
  const auto count = static_cast<double>(sweep.layers);
  if (sweep.kind == Sweep::Rotation || sweep.layers == 1 || sweep.ratio == 1.0)
  {
    return static_cast<double>(level) / (count * order);
  }
  const double quotient = std::pow(sweep.ratio, 1.0 / (count - 1.0));
  const auto below = [&](int layers)
  { return std::expm1(layers * std::log(quotient)) / std::expm1(count * std::log(quotient)); };
  const int layer = level / order;
  const double between = static_cast<double>(level % order) / order;
  return between == 0.0 ? below(layer)
                        : (1.0 - between) * below(layer) + between * below(layer + 1);
}

/// Places of the nodes of quads at any part of a sweep.
class SweptPlaces
{
public:
  SweptPlaces(const SolverMesh& quads, const Sweep& sweep)
    : Quads(quads)
    , Settings(sweep)
    , Normal(NormalOf(quads))
    , Across(-sweep.axisDirection.y(), sweep.axisDirection.x())
    , OnAxis(quads.points.size(), false)
  {
    this->Across.normalize();
    if (sweep.kind == Sweep::Rotation)
    {
      this->FindAxis();
    }
  }

  bool IsOnAxis(int point) const { return this->OnAxis[point]; }

  /// Returns the place of a point after a part of the sweep, 0 to 1.
  Eigen::Vector3d At(int point, double part) const
  {
    const Eigen::Vector3d& start = this->Quads.points[point];
    if (this->Settings.kind == Sweep::Translation)
    {
      return start + part * this->Settings.height * this->Normal;
    }
    const double first = this->Settings.layers == 1 && this->Settings.angle < FullTurn ? -0.5 : 0.0;
    const double angle = (part + first) * this->Settings.angle * (2.0 * std::acos(-1.0) / FullTurn);
    if (angle == 0.0)
    {
      return start;
    }
    const double offset = this->DistanceOf(point);
    const double distance = this->OnAxis[point] ? 0.0 : offset;
    const Point onAxis = start.head<2>() - offset * this->Across;
    Eigen::Vector3d place = start;
    place.head<2>() = onAxis + distance * std::cos(angle) * this->Across;
    place.z() += this->Normal.z() * std::abs(distance) * std::sin(angle);
    return place;
  }

private:
  /// Returns the signed distance of a point from the axis.
  double DistanceOf(int point) const
  {
    return this->Across.dot(this->Quads.points[point].head<2>() - this->Settings.axisPoint);
  }

  void FindAxis()
  {
    const double tolerance = PlaneRounding * ExtentOf(this->Quads.points);
    int positive = -1;
    int negative = -1;
    for (const int point : this->Quads.cells)
    {
      const double distance = this->DistanceOf(point);
      this->OnAxis[point] = std::abs(distance) <= tolerance;
      if (!this->OnAxis[point])
      {
        (distance > 0.0 ? positive : negative) = point;
      }
    }
    if (positive >= 0 && negative >= 0)
    {
      throw Error("The quads are on both sides of the axis, at " + PlaceOf(this->Quads, positive) +
        " and " + PlaceOf(this->Quads, negative) + "; move the axis or the domain to one side.");
    }
  }

  const SolverMesh& Quads;
  const Sweep& Settings;
  Eigen::Vector3d Normal;
  Point Across; ///< Unit vector normal to the axis.
  std::vector<bool> OnAxis;
};

int SourceOf(const std::vector<int>& sources, int part)
{
  return sources.empty() ? part : sources[part];
}

/// Numbers of the points at the levels of a sweep; those on the axis are at all levels the same.
class SweptPoints
{
public:
  SweptPoints(const SolverMesh& quads, const Sweep& sweep, SolverMesh& mesh)
    : IsClosed(sweep.kind == Sweep::Rotation && sweep.angle == FullTurn)
    , Levels(sweep.layers * quads.order + (this->IsClosed ? 0 : 1))
    , PointCount(quads.points.size())
    , Numbers(this->PointCount * Index(this->Levels), -1)
  {
    const SweptPlaces places(quads, sweep);
    RequireSimpleAxis(quads, places);
    const std::vector<int> used = ElementNodes(quads, NodeOrder::Vtk).UsedPoints();
    for (int level = 0; level < this->Levels; ++level)
    {
      const double part = PartAt(sweep, quads.order, level);
      for (const int point : used)
      {
        int& number = this->Numbers[Index(level) * this->PointCount + Index(point)];
        if (level > 0 && places.IsOnAxis(point))
        {
          number = this->Numbers[point];
          continue;
        }
        number = static_cast<int>(mesh.points.size());
        mesh.sources.points.push_back(SourceOf(quads.sources.points, point));
        mesh.points.push_back(places.At(point, part));
      }
    }
  }

  int At(int point, int level) const
  {
    const int wrapped = this->IsClosed ? level % this->Levels : level;
    return this->Numbers[Index(wrapped) * this->PointCount + Index(point)];
  }

  const bool IsClosed;

private:
  static void RequireSimpleAxis(const SolverMesh& quads, const SweptPlaces& places)
  {
    const CellLattice lattice(2, quads.order);
    for (int cell = 0; cell < quads.CellCount(); ++cell)
    {
      const int* nodes = quads.Cell(cell);
      const auto onAxis = std::count_if(
        nodes, nodes + quads.NodesOfCell(), [&](int node) { return places.IsOnAxis(node); });
      bool hasEdge = false; // on the axis
      for (int face = 0; face < lattice.FaceCount(); ++face)
      {
        const std::vector<int> edge = lattice.Face(face);
        hasEdge = hasEdge ||
          std::all_of(edge.begin(), edge.end(),
            [&](int position) { return places.IsOnAxis(nodes[position]); });
      }
      if (onAxis == 0 || (hasEdge && onAxis == quads.order + 1))
      {
        continue;
      }
      const int* first = std::find_if(
        nodes, nodes + quads.NodesOfCell(), [&](int node) { return places.IsOnAxis(node); });
      throw Error("A quad touches the axis at " + PlaceOf(quads, *first) +
        " with other than one edge; let no singularity be on the axis, or use smaller quads.");
    }
  }

  int Levels;
  std::size_t PointCount;
  std::vector<int> Numbers;
};

/// Returns the index of a side, which is added under the next free name.
int AddSide(const std::string& name, SolverMesh& mesh)
{
  std::string free = name;
  for (int i = 2;
       std::find(mesh.sideNames.begin(), mesh.sideNames.end(), free) != mesh.sideNames.end(); ++i)
  {
    free = name + "_" + std::to_string(i);
  }
  mesh.sideNames.push_back(free);
  return static_cast<int>(mesh.sideNames.size()) - 1;
}

/// Removes sides without faces: those that are on the axis.
void RemoveEmptySides(SolverMesh& mesh)
{
  std::vector<int> number(mesh.sideNames.size(), -1);
  std::vector<std::string> names;
  for (const int side : std::set<int>(mesh.side.begin(), mesh.side.end()))
  {
    number[side] = static_cast<int>(names.size());
    names.push_back(mesh.sideNames[side]);
  }
  for (int& side : mesh.side)
  {
    side = number[side];
  }
  mesh.sideNames = names;
  std::vector<SidePair> pairs;
  for (const SidePair& pair : mesh.pairs)
  {
    const int first = number[pair.first];
    const int second = number[pair.second];
    if (first >= 0 && second >= 0)
    {
      pairs.push_back({ first, second, pair.motion });
    }
  }
  mesh.pairs = pairs;
}

/// Returns whether points that a motion takes to each other still are so after every part of a sweep.
bool Commutes(const Eigen::Matrix4d& motion, const Sweep& sweep)
{
  if (sweep.kind == Sweep::Translation)
  {
    return true; // the motion is in the plane of the quads
  }
  const Point direction = sweep.axisDirection.normalized();
  Eigen::Matrix4d acrossAxis = motion;
  acrossAxis.topRightCorner<2, 1>() -= direction.dot(motion.topRightCorner<2, 1>()) * direction;
  // topRightCorner has the rows x and y of the column of the translation.
  return acrossAxis.isIdentity(PlaneRounding);
}
}

SolverMesh SweepQuads(const SolverMesh& quads, const Sweep& sweep)
{
  RequireValid(quads, sweep);
  SolverMesh mesh;
  const SweptPoints points(quads, sweep, mesh);
  mesh.dimension = 3;
  mesh.order = quads.order;
  mesh.regionNames = quads.regionNames;
  mesh.sideNames = quads.sideNames;
  mesh.patchTypes = quads.patchTypes;
  std::copy_if(quads.pairs.begin(), quads.pairs.end(), std::back_inserter(mesh.pairs),
    [&sweep](const SidePair& pair) { return Commutes(pair.motion, sweep); });
  const int p = quads.order;
  const auto addFace = [&](const std::array<int, 4>& corners, int side, int source)
  {
    mesh.faces.insert(mesh.faces.end(), corners.begin(), corners.end());
    mesh.side.push_back(side);
    mesh.sources.faces.push_back(source);
  };
  for (int layer = 0; layer < sweep.layers; ++layer)
  {
    for (int cell = 0; cell < quads.CellCount(); ++cell)
    {
      for (int level = layer * p; level <= (layer + 1) * p; ++level)
      {
        for (int node = 0; node < quads.NodesOfCell(); ++node)
        {
          mesh.cells.push_back(points.At(quads.Cell(cell)[node], level));
        }
      }
      mesh.region.push_back(quads.region[cell]);
      mesh.sources.cells.push_back(SourceOf(quads.sources.cells, cell));
    }
    for (int face = 0; face < quads.FaceCount(); ++face)
    {
      const int a = quads.faces[2 * Index(face)];
      const int b = quads.faces[2 * Index(face) + 1];
      const std::array<int, 4> corners = { points.At(a, layer * p), points.At(b, layer * p),
        points.At(b, (layer + 1) * p), points.At(a, (layer + 1) * p) };
      if (corners[0] != corners[3] || corners[1] != corners[2]) // else the edge is on the axis
      {
        addFace(corners, quads.side[face], SourceOf(quads.sources.faces, face));
      }
    }
  }
  if (!points.IsClosed)
  {
    const CellLattice lattice(2, p);
    for (std::size_t end = 0; end < sweep.ends.size(); ++end)
    {
      const int side = AddSide(sweep.ends[end], mesh);
      for (int cell = 0; cell < quads.CellCount(); ++cell)
      {
        std::array<int, 4> corners{};
        for (int corner = 0; corner < 4; ++corner)
        {
          corners[corner] =
            points.At(quads.Cell(cell)[lattice.Corner(corner)], end == 0 ? 0 : sweep.layers * p);
        }
        addFace(corners, side, -1);
      }
    }
  }
  RemoveEmptySides(mesh);
  const int sides = static_cast<int>(mesh.sideNames.size());
  mesh.sweep.layers = sweep.layers;
  mesh.sweep.isRotation = sweep.kind == Sweep::Rotation;
  mesh.sweep.back = points.IsClosed ? -1 : sides - 2;
  mesh.sweep.front = points.IsClosed ? -1 : sides - 1;
  for (const MeshBlock& block : quads.blocks)
  {
    mesh.blocks.push_back({ { block.cells[0], block.cells[1], sweep.layers }, {} });
    for (int level = 0; level <= sweep.layers * p; level += p)
    {
      std::transform(block.nodes.begin(), block.nodes.end(),
        std::back_inserter(mesh.blocks.back().nodes),
        [&](int node) { return points.At(node, level); });
    }
  }
  return mesh;
}
}
