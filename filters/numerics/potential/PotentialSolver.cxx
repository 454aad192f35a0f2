#include "PotentialSolver.h"

#include "Error.h"
#include "P1Laplacian.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <numeric>
#include <string>
#include <utility>

namespace crossfield
{
namespace
{
/// See PotentialSolver::HoleSources.
Eigen::SparseMatrix<double> DifferencesOnHoles(
  const MeshTopology& topology, const std::vector<LoopStrip>& strips)
{
  std::vector<Eigen::Triplet<double>> entries;
  const auto firstPeriod = static_cast<int>(topology.mesh.points.size());
  auto period = static_cast<std::size_t>(topology.LoopCount(BoundaryKind::Inner));
  int first = 0;
  for (const BoundaryLoop& loop : topology.loops)
  {
    if (loop.kind != BoundaryKind::Hole)
    {
      continue;
    }
    const auto size = static_cast<int>(loop.edges.size());
    for (int j = 0; j < size; ++j)
    {
      // Edges are directed clockwise around the hole, so edge j starts where edge j + 1 ends.
      const int edge = loop.edges[static_cast<std::size_t>(j)];
      const int vertex = topology.BoundaryAt(edge).vertices[0];
      entries.emplace_back(vertex, first + j, 1.0);
      entries.emplace_back(vertex, first + (j + 1) % size, -1.0);
      if (edge == strips[period].lastBoundaryEdge)
      {
        entries.emplace_back(firstPeriod + static_cast<int>(period), first + j, -1.0);
      }
    }
    first += size;
    ++period;
  }
  Eigen::SparseMatrix<double> differences(
    firstPeriod + static_cast<Eigen::Index>(strips.size()), first);
  differences.setFromTriplets(entries.begin(), entries.end());
  return differences;
}

/// The P1 matrix bordered by the periods.
Eigen::SparseMatrix<double> BorderedMatrix(
  const TriangleMesh& mesh, const EdgeNumbering& edges, const std::vector<LoopStrip>& strips)
{
  Eigen::SparseMatrix<double> matrix = P1Stiffness(mesh, edges);
  const Eigen::Index vertexCount = matrix.rows();
  const auto size = vertexCount + static_cast<Eigen::Index>(strips.size());
  matrix.conservativeResize(size, size);
  std::vector<Eigen::Triplet<double>> border;
  for (std::size_t k = 0; k < strips.size(); ++k)
  {
    const auto row = static_cast<int>(vertexCount + static_cast<Eigen::Index>(k));
    // η_k on the triangles of its strip, to find where other strips overlap.
    std::vector<std::pair<int, Eigen::Vector3d>> products;
    for (const LoopStrip::Step& step : strips[k].steps)
    {
      const Eigen::Vector3d product =
        P1ElementStiffness(mesh, static_cast<std::size_t>(step.triangle)) *
        Eigen::Map<const Eigen::Vector3d>(step.left.data());
      products.emplace_back(step.triangle, product);
      for (std::size_t i = 0; i < 3; ++i)
      {
        const int vertex = mesh.triangles[static_cast<std::size_t>(step.triangle)][i];
        border.emplace_back(vertex, row, product[static_cast<Eigen::Index>(i)]);
        border.emplace_back(row, vertex, product[static_cast<Eigen::Index>(i)]);
      }
    }
    std::sort(products.begin(), products.end(),
      [](const auto& a, const auto& b) { return a.first < b.first; });
    for (std::size_t l = 0; l < strips.size(); ++l)
    {
      for (const LoopStrip::Step& step : strips[l].steps)
      {
        const auto found = std::lower_bound(products.begin(), products.end(), step.triangle,
          [](const auto& entry, int triangle) { return entry.first < triangle; });
        if (found != products.end() && found->first == step.triangle)
        {
          border.emplace_back(static_cast<int>(vertexCount + static_cast<Eigen::Index>(l)), row,
            found->second.dot(Eigen::Map<const Eigen::Vector3d>(step.left.data())));
        }
      }
    }
  }
  if (!border.empty())
  {
    Eigen::SparseMatrix<double> addition(size, size);
    addition.setFromTriplets(border.begin(), border.end());
    matrix += addition;
  }
  return matrix;
}
}

PotentialSolver::PotentialSolver(
  SharedTopology topology, Boundary boundary, const Progress& progress)
  : Topology(std::move(topology))
  , VertexCount(static_cast<Eigen::Index>(this->Topology->mesh.points.size()))
  , IslandCount(this->Topology->LoopCount(BoundaryKind::Inner))
  , Strips(FindLoopStrips(this->Topology->mesh, this->Topology->edges, this->Topology->loops, true))
  , OnLoops(boundary)
  , Differences(DifferencesOnHoles(*this->Topology, this->Strips))
{
  const TriangleMesh& mesh = this->Topology->mesh;
  std::vector<int> leftOut = {
    mesh.boundary[static_cast<std::size_t>(this->Topology->FirstOuterEdge())].vertices[0]
  };
  if (boundary == Boundary::Given)
  {
    leftOut.clear();
    for (const BoundaryEdge& edge : mesh.boundary)
    {
      if (edge.IsAligned())
      {
        leftOut.push_back(edge.vertices[0]);
      }
    }
  }
  std::vector<int> trailing;
  std::vector<int>& periodRows = boundary == Boundary::Natural ? trailing : leftOut;
  for (Eigen::Index k = 0; k < this->PeriodCount(); ++k)
  {
    periodRows.push_back(static_cast<int>(this->PeriodRow(k)));
  }

  std::vector<Point> places(mesh.points);
  places.resize(static_cast<std::size_t>(this->Rows()), Point::Zero()); // periods have no place
  const Eigen::SparseMatrix<double> matrix =
    BorderedMatrix(mesh, this->Topology->edges, this->Strips);
  progress.Report(0.1);
  this->Factor =
    std::make_unique<DissectedCholesky>(matrix, places, trailing, leftOut, progress.Part(0.1, 1.0));
}

const DissectedCholesky::SparseEliminated& PotentialSolver::EliminatedHoles() const
{
  if (!this->Holes)
  {
    std::vector<Eigen::SparseMatrix<double>> blocks;
    Eigen::Index first = 0;
    for (const BoundaryLoop& loop : this->Topology->loops)
    {
      if (loop.kind == BoundaryKind::Hole)
      {
        const auto size = static_cast<Eigen::Index>(loop.edges.size());
        blocks.emplace_back(this->Differences.middleCols(first, size));
        first += size;
      }
    }
    this->Holes = std::make_unique<const DissectedCholesky::SparseEliminated>(
      this->Factor->EliminateSparse(blocks));
  }
  return *this->Holes;
}

const PotentialSolver::HoleResponse& PotentialSolver::GetHoleResponse(Periods periods) const
{
  std::unique_ptr<const HoleResponse>& kept = this->Responses[periods == Periods::Islands ? 0 : 1];
  if (kept)
  {
    return *kept;
  }
  HoleResponse response;
  response.periods.resize(0, this->TrailingCount(periods));
  if (this->Differences.cols() > 0)
  {
    const DissectedCholesky::SparseEliminated& holes = this->EliminatedHoles();
    std::vector<Eigen::Index> sizes(holes.firsts.size());
    std::adjacent_difference(holes.firsts.begin(), holes.firsts.end(), sizes.begin());
    sizes.erase(sizes.begin());
    // The last rows are the periods; those that the question does not have are held at zero.
    std::vector<GramNode> nodes = holes.nodes;
    Eigen::MatrixXd& border = nodes.back().rows;
    const Eigen::Index without =
      this->Factor->GetTrailingFactor().rows() - this->TrailingCount(periods);
    border.conservativeResize(border.rows() - without, Eigen::NoChange);
    response.periods = this->PeriodFactor(periods)
                         .transpose()
                         .triangularView<Eigen::Upper>()
                         .solve(border.bottomRows(this->TrailingCount(periods)))
                         .transpose();
    response.elastic = GramMatrix(sizes, std::move(nodes));
    if (periods == Periods::Islands || this->OnLoops == Boundary::Given)
    {
      // The gauge: any positive weight will do; the mean of the diagonal keeps the matrix well scaled.
      const double mean = response.elastic.Trace() / static_cast<double>(response.elastic.Rows());
      for (int hole = 0; hole < response.elastic.BlockCount(); ++hole)
      {
        const Eigen::Index size = response.elastic.Size(hole);
        response.elastic.AddToBlock(
          hole, Eigen::MatrixXd::Constant(size, size, mean / static_cast<double>(size)));
      }
    }
  }
  kept = std::make_unique<const HoleResponse>(std::move(response));
  return *kept;
}

PotentialSolver::Eliminated PotentialSolver::Eliminate(
  const Eigen::MatrixXd& rightHandSides, Periods periods) const
{
  // A given boundary takes whatever is missing.
  const auto atVertices = rightHandSides.topRows(this->VertexCount);
  for (Eigen::Index column = 0;
       this->OnLoops == Boundary::Natural && column < rightHandSides.cols(); ++column)
  {
    const double sum = atVertices.col(column).sum();
    // Sums of n terms in floating point are off by at most n ε times the sum of their sizes.
    const double rounding = static_cast<double>(this->VertexCount) *
      std::numeric_limits<double>::epsilon() * atVertices.col(column).lpNorm<1>();
    if (!(std::abs(sum) <= rounding))
    {
      throw Error("The sources of the potential add up to " + std::to_string(sum) +
        " instead of zero, so it has no solution; the quarter indices violate Poincaré-Hopf.");
    }
  }
  Eliminated sources = this->Factor->Eliminate(rightHandSides);
  this->LeaveOutPeriods(sources, periods);
  return sources;
}

void PotentialSolver::LeaveOutPeriods(Eliminated& sources, Periods periods) const
{
  sources.border.bottomRows(this->Factor->GetTrailingFactor().rows() - this->TrailingCount(periods))
    .setZero();
}

Eigen::MatrixXd PotentialSolver::OnHoles(const Eliminated& sources) const
{
  return this->EliminatedHoles().Against(sources);
}

void PotentialSolver::AddOnHoles(
  Eliminated& sources, const Eigen::MatrixXd& x, Periods periods) const
{
  this->EliminatedHoles().AddTo(sources, x);
  this->LeaveOutPeriods(sources, periods);
}

Eigen::MatrixXd PotentialSolver::AtPeriods(const Eliminated& sources, Periods periods) const
{
  const Eigen::Index all = this->Factor->GetTrailingFactor().rows();
  return this->PeriodFactor(periods).transpose().triangularView<Eigen::Upper>().solve(
    sources.border.middleRows(sources.border.rows() - all, this->TrailingCount(periods)));
}

void PotentialSolver::AddAtPeriods(
  Eliminated& sources, const Eigen::MatrixXd& atPeriods, Periods periods) const
{
  const Eigen::Index all = this->Factor->GetTrailingFactor().rows();
  sources.border.middleRows(sources.border.rows() - all, this->TrailingCount(periods)) +=
    this->PeriodFactor(periods).triangularView<Eigen::Lower>().solve(atPeriods);
}

Eigen::MatrixXd PotentialSolver::Gradient(const Eigen::MatrixXd& solutions) const
{
  const auto gradientOf = [this](std::size_t t, double f0, double f1, double f2) -> Point
  {
    const auto& triangle = this->Topology->mesh.triangles[t];
    const Point& p0 = this->Topology->mesh.points[static_cast<std::size_t>(triangle[0])];
    const Point a = this->Topology->mesh.points[static_cast<std::size_t>(triangle[1])] - p0;
    const Point b = this->Topology->mesh.points[static_cast<std::size_t>(triangle[2])] - p0;
    const double da = f1 - f0;
    const double db = f2 - f0;
    return Point(da * b.y() - db * a.y(), db * a.x() - da * b.x()) / Cross(a, b);
  };
  Eigen::MatrixXd gradient(
    2 * solutions.cols(), static_cast<Eigen::Index>(this->Topology->mesh.triangles.size()));
  for (std::size_t t = 0; t < this->Topology->mesh.triangles.size(); ++t)
  {
    const auto& v = this->Topology->mesh.triangles[t];
    for (Eigen::Index c = 0; c < solutions.cols(); ++c)
    {
      gradient.block<2, 1>(2 * c, static_cast<Eigen::Index>(t)) =
        gradientOf(t, solutions(v[0], c), solutions(v[1], c), solutions(v[2], c));
    }
  }
  for (Eigen::Index k = 0; k < this->PeriodCount(); ++k)
  {
    for (const LoopStrip::Step& step : this->Strips[static_cast<std::size_t>(k)].steps)
    {
      const Point cut = gradientOf(
        static_cast<std::size_t>(step.triangle), step.left[0], step.left[1], step.left[2]);
      for (Eigen::Index c = 0; c < solutions.cols(); ++c)
      {
        gradient.block<2, 1>(2 * c, step.triangle) += solutions(this->PeriodRow(k), c) * cut;
      }
    }
  }
  return gradient;
}

Eigen::VectorXd PotentialSolver::Apply(const Eigen::VectorXd& solution) const
{
  const Eigen::Matrix2Xd gradient = this->Gradient(solution);
  Eigen::VectorXd sources = Eigen::VectorXd::Zero(this->Rows());
  // ∫ ∇Φ · ∇λ_i over a triangle: the gradient turned by −90° times half the opposite edge.
  const auto load = [&](std::size_t t, std::size_t i)
  {
    const auto& v = this->Topology->mesh.triangles[t];
    const Point opposite = this->Topology->mesh.points[static_cast<std::size_t>(v[(i + 2) % 3])] -
      this->Topology->mesh.points[static_cast<std::size_t>(v[(i + 1) % 3])];
    return 0.5 * Cross(opposite, gradient.col(static_cast<Eigen::Index>(t)));
  };
  for (std::size_t t = 0; t < this->Topology->mesh.triangles.size(); ++t)
  {
    for (std::size_t i = 0; i < 3; ++i)
    {
      sources[this->Topology->mesh.triangles[t][i]] += load(t, i);
    }
  }
  for (Eigen::Index k = 0; k < this->PeriodCount(); ++k)
  {
    for (const LoopStrip::Step& step : this->Strips[static_cast<std::size_t>(k)].steps)
    {
      for (std::size_t i = 0; i < 3; ++i)
      {
        sources[this->PeriodRow(k)] +=
          step.left[i] * load(static_cast<std::size_t>(step.triangle), i);
      }
    }
  }
  return sources;
}

const Eigen::MatrixXd& PotentialSolver::IslandSources() const
{
  std::call_once(this->HasIslands,
    [this]
    {
      this->OfIslands.resize(this->Rows(), this->IslandCount);
      Eigen::Index k = 0;
      for (const BoundaryLoop& loop : this->Topology->loops)
      {
        if (loop.kind == BoundaryKind::Inner)
        {
          Eigen::VectorXd one = Eigen::VectorXd::Zero(this->Rows());
          for (const int edge : loop.edges)
          {
            one[this->Topology->BoundaryAt(edge).vertices[0]] = 1.0;
          }
          this->OfIslands.col(k) = this->HarmonicSources(one);
          ++k;
        }
      }
    });
  return this->OfIslands;
}

const PotentialSolver& PotentialSolver::OfGivenBoundary() const
{
  std::call_once(this->HasOther,
    [this]
    { this->Other = std::make_unique<const PotentialSolver>(this->Topology, Boundary::Given); });
  return *this->Other;
}
}
