#include "PositionResponse.h"

#include "ConjugateField.h"
#include "LogSource.h"

#include <algorithm>

namespace crossfield
{
namespace
{
/// Returns the sources of 4U: the derivatives of the angles at which singularities see the two
/// halves of boundary edges at each vertex, times −k.
Eigen::MatrixXd Sources(
  const PotentialSolver& potential, const SeamlessMap& map, const std::vector<int>& moving)
{
  const PlanarTopology& topology = *RequirePlanar(map.topology);
  Eigen::MatrixXd sources =
    Eigen::MatrixXd::Zero(potential.Rows(), static_cast<Eigen::Index>(2 * moving.size()));
  for (std::size_t m = 0; m < moving.size(); ++m)
  {
    const Cone& cone = map.cones[moving[m]];
    const Point& position = topology.PointAt(cone.vertex);
    auto columns = sources.middleCols<2>(static_cast<Eigen::Index>(2 * m));
    for (std::size_t i = 0; i < topology.mesh.boundary.size(); ++i)
    {
      const std::array<int, 2>& ends = topology.mesh.boundary[i].vertices;
      const Point from = LogSource::TurnDerivative(topology.PointAt(ends[0]), position);
      const Point to = LogSource::TurnDerivative(topology.PointAt(ends[1]), position);
      const Point middle =
        LogSource::TurnDerivative(topology.Midpoint(topology.edges.ofBoundary[i]), position);
      columns.row(ends[0]) -= cone.quarterIndex * (middle - from).transpose();
      columns.row(ends[1]) -= cone.quarterIndex * (to - middle).transpose();
    }
  }
  return sources;
}

/// Returns the distances from moving cones beyond which the map is accurate.
Eigen::VectorXd FindAccurateDistances(const SeamlessMap& map, const std::vector<int>& moving)
{
  const PlanarTopology& topology = *RequirePlanar(map.topology);
  Eigen::VectorXd sums =
    Eigen::VectorXd::Zero(static_cast<Eigen::Index>(topology.mesh.points.size()));
  Eigen::VectorXd counts = sums;
  for (const std::array<int, 2>& ends : topology.edges.vertices)
  {
    const double length = (topology.PointAt(ends[1]) - topology.PointAt(ends[0])).norm();
    for (const int vertex : ends)
    {
      sums[vertex] += length;
      counts[vertex] += 1.0;
    }
  }
  Eigen::VectorXd distances(static_cast<Eigen::Index>(moving.size()));
  for (std::size_t m = 0; m < moving.size(); ++m)
  {
    const int vertex = map.cones[moving[m]].vertex;
    double distance = 2.5 * sums[vertex] / counts[vertex];
    for (const Cone& cone : map.cones)
    {
      if (cone.vertex != vertex)
      {
        const double apart = (topology.PointAt(cone.vertex) - topology.PointAt(vertex)).norm();
        distance = std::min(distance, 0.45 * apart);
      }
    }
    distances[static_cast<Eigen::Index>(m)] = distance;
  }
  return distances;
}
}

PositionResponse::PositionResponse(const SeamlessMap& map,
  std::shared_ptr<const PotentialSolver> potential, const Progress& progress)
  : Map(map)
{
  for (int c = 0; c < static_cast<int>(map.cones.size()); ++c)
  {
    const Cone& cone = map.cones[c];
    if (cone.row >= 0 && !cone.onBoundary)
    {
      this->Moving.push_back(c);
    }
  }
  this->AccurateDistances = FindAccurateDistances(map, this->Moving);
  const PlanarTopology& topology = *RequirePlanar(map.topology);
  if (!potential)
  {
    potential =
      std::make_shared<const PotentialSolver>(RequirePlanar(map.topology), progress.Part(0.0, 0.5));
  }
  const Eigen::MatrixXd solution =
    0.25 * potential->SolveSingleValued(Sources(*potential, map, this->Moving));
  const Eigen::Index vertices = potential->GetOperator().VertexCount();
  this->Real = solution.topRows(vertices).transpose();
  progress.Report(0.8);
  this->Imaginary = IntegrateConjugate(topology, potential->Gradient(solution),
    topology.EdgeOfBoundary(topology.FirstOuterEdge()), Eigen::VectorXd::Zero(this->Columns()));
  // θ does not change on the outer loop, which determines the constant of V.
  std::vector<Eigen::VectorXd> means;
  for (const BoundaryLoop& loop : topology.loops)
  {
    Eigen::VectorXd mean = Eigen::VectorXd::Zero(this->Columns());
    for (const int edge : EdgesOf(loop, topology.edges))
    {
      mean += this->Imaginary.col(edge) + this->SingularAngles(edge);
    }
    means.emplace_back(mean / static_cast<double>(loop.edges.size()));
  }
  this->Imaginary.colwise() -= means.front();
  this->Defects.resize(static_cast<Eigen::Index>(means.size()) - 1, this->Columns());
  for (Eigen::Index k = 0; k < this->Defects.rows(); ++k)
  {
    this->Defects.row(k) = (means[static_cast<std::size_t>(k) + 1] - means.front()).transpose();
  }
  progress.Report(1.0);
}

Eigen::VectorXd PositionResponse::SingularAngles(int edge) const
{
  Eigen::VectorXd angles(this->Columns());
  const Point middle = RequirePlanar(this->Map.topology)->Midpoint(edge);
  for (std::size_t m = 0; m < this->Moving.size(); ++m)
  {
    // The derivative of q arg(z − b) by the position b.
    angles.segment<2>(static_cast<Eigen::Index>(2 * m)) =
      0.25 * this->ConeOf(m).quarterIndex * LogSource::TurnDerivative(middle, this->PositionOf(m));
  }
  return angles;
}

void PositionResponse::AddRegular(int triangle, const Point& place,
  const std::complex<double>& factor, Eigen::Ref<Eigen::VectorXcd> row) const
{
  const PlanarTopology& topology = *RequirePlanar(this->Map.topology);
  const auto& vertices = topology.mesh.triangles[triangle];
  const auto& edges = topology.edges.ofTriangle[triangle];
  const auto point = [&](std::size_t k) -> const Point&
  { return topology.PointAt(vertices[k % 3]); };
  const double area = Cross(point(1) - point(0), point(2) - point(0));
  const std::complex<double> i(0.0, 1.0);
  for (std::size_t k = 0; k < 3; ++k)
  {
    const double weight = Cross(point(k + 2) - point(k + 1), place - point(k + 1)) / area;
    // The function of the edge opposite vertex k that is 1 at its midpoint is 1 − 2λ_k.
    row += factor * weight * this->Real.col(vertices[k]) +
      factor * i * (1.0 - 2.0 * weight) * this->Imaginary.col(edges[(k + 1) % 3]);
  }
}
}
