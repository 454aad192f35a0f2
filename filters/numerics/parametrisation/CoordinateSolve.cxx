#include "CoordinateSolve.h"

#include "DissectedCholesky.h"
#include "Error.h"
#include "Index.h"
#include "P1Laplacian.h"
#include "SymmetricAssembly.h"

#include <limits>
#include <utility>

namespace crossfield
{
namespace
{
using Prolongation = Eigen::SparseMatrix<double, Eigen::RowMajor>;

/// A term c |w_a − w_b|² of the sum, for an edge between two vertices of the cut mesh.
struct Coupling
{
  int a;
  int b;
  double value;
};

/// Returns the quadratic part of the sum, edge by edge. The two sides of a cut edge have separate
/// terms.
std::vector<Coupling> CoupleCorners(const SeamlessMap& map, const std::vector<double>& weights)
{
  const MeshTopology& topology = *map.topology;
  std::vector<Coupling> couplings(Index(topology.edges.Count()), { -1, -1, 0.0 });
  for (std::size_t t = 0; t < topology.mesh.triangles.size(); ++t)
  {
    const Eigen::Matrix3d element =
      weights[t] * P1ElementStiffness(topology.ChartOf(static_cast<int>(t)));
    for (std::size_t i = 0; i < 3; ++i)
    {
      const std::size_t next = (i + 1) % 3;
      const int a = map.corners[t][i];
      const int b = map.corners[t][next];
      const double value = -element(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(next));
      Coupling& coupling = couplings[topology.edges.ofTriangle[t][i]];
      if (coupling.a < 0)
      {
        coupling = { a, b, value };
      }
      else if (coupling.a == b && coupling.b == a)
      {
        coupling.value += value;
      }
      else
      {
        couplings.push_back({ a, b, value });
      }
    }
  }
  return couplings;
}

/// Returns the matrix of the sum for the free unknowns of both u and v.
Eigen::SparseMatrix<double> FreeMatrix(
  const std::vector<Coupling>& couplings, const Prolongation& prolongation)
{
  Eigen::VectorXd diagonal = Eigen::VectorXd::Zero(prolongation.cols());
  std::vector<SymmetricEntry> offDiagonal;
  offDiagonal.reserve(2 * couplings.size());
  std::vector<std::pair<int, double>> difference; // w_a − w_b
  for (const Coupling& coupling : couplings)
  {
    for (int part = 0; part < 2; ++part)
    {
      difference.clear();
      for (const auto& [vertex, sign] : { std::pair(coupling.a, 1.0), std::pair(coupling.b, -1.0) })
      {
        for (Prolongation::InnerIterator term(prolongation, 2 * vertex + part); term; ++term)
        {
          difference.emplace_back(static_cast<int>(term.col()), sign * term.value());
        }
      }
      for (std::size_t i = 0; i < difference.size(); ++i)
      {
        const auto& [row, left] = difference[i];
        diagonal[row] += coupling.value * left * left;
        for (std::size_t j = 0; j < i; ++j)
        {
          const auto& [column, right] = difference[j];
          const double value = coupling.value * left * right;
          if (row == column)
          {
            diagonal[row] += 2.0 * value;
          }
          else
          {
            offDiagonal.push_back({ row, column, value });
          }
        }
      }
    }
  }
  return AssembleSymmetric(diagonal, offDiagonal);
}

/// Input of the dissection that orders the free unknowns for elimination.
struct Order
{
  std::vector<SpacePoint> places; ///< Positions of the free unknowns.
  std::vector<int> trailing;      ///< Unknowns on which many others depend: they come last.
  std::vector<int>
    ground; ///< u and v of a vertex on which no other depends, left out to fix the origin.
  /// Per unknown: v of the vertex if it is u, u if it is v, when no other vertex depends on them;
  /// else −1.
  std::vector<int> partners;
};

Order OrderUnknowns(const SeamlessMap& map, const Prolongation& prolongation)
{
  const auto count = static_cast<std::size_t>(prolongation.cols());
  Order order;
  order.places.assign(count, SpacePoint::Zero());
  order.partners.assign(count, -1);
  std::vector<int> dependents(count, 0);
  for (Eigen::Index row = prolongation.rows(); row-- > 0;)
  {
    const auto vertex = static_cast<std::size_t>(row) / 2;
    for (Prolongation::InnerIterator term(prolongation, row); term; ++term)
    {
      const std::size_t unknown = Index(static_cast<int>(term.col()));
      ++dependents[unknown];
      if (vertex < map.original.size()) // descending: the first vertex sets the position
      {
        order.places[unknown] = map.topology->PositionOf(map.original[vertex]);
      }
    }
  }
  // A vertex inside a chain has fewer dependents than this, including those of its copy.
  constexpr int ManyDependents = 4;
  for (int j = 0; j < static_cast<int>(count); ++j)
  {
    if (dependents[j] > ManyDependents)
    {
      order.trailing.push_back(j);
    }
  }
  const auto own = [&](std::size_t row)
  {
    const Prolongation::InnerIterator term(prolongation, static_cast<Eigen::Index>(row));
    return term && dependents[static_cast<int>(term.col())] == 1 ? static_cast<int>(term.col())
                                                                 : -1;
  };
  for (std::size_t vertex = 0; vertex < map.original.size(); ++vertex)
  {
    const int u = own(2 * vertex);
    const int v = own(2 * vertex + 1);
    if (u >= 0 && v >= 0)
    {
      order.partners[u] = v;
      order.partners[v] = u;
      if (order.ground.empty())
      {
        order.ground = { u, v };
      }
    }
  }
  if (order.ground.empty())
  {
    throw Error(
      "The mesh is too coarse for a seamless map: every vertex is on a seam or on the boundary",
      "use a finer mesh", Error::Kind::CoarseMesh);
  }
  return order;
}
}

Eigen::VectorXd SolveCoordinates(const SeamlessMap& map, const SeamlessPoisson& poisson,
  const Prolongation& prolongation, const Progress& progress)
{
  const Order order = OrderUnknowns(map, prolongation);
  const DissectedCholesky factor(FreeMatrix(CoupleCorners(map, poisson.weights), prolongation),
    order.places, order.trailing, order.ground, progress, order.partners);

  // Iterative refinement: the first solution has an error of rounding times the range of the
  // weights, 1e-2 of the extent for hundreds of random singularities. A correction by the fraction
  // c leaves an error of about c² (docs/method.md §12.3).
  constexpr double NegligibleSquared = 1e-8;
  constexpr int MaximumCorrections = 5;
  Eigen::VectorXd free = Eigen::VectorXd::Zero(prolongation.cols());
  double previous = std::numeric_limits<double>::infinity();
  for (int i = 0; i <= MaximumCorrections; ++i)
  {
    const Eigen::MatrixX2d residual = poisson.Residual(map, prolongation * free);
    Eigen::VectorXd full = Eigen::VectorXd::Zero(prolongation.rows());
    for (Eigen::Index vertex = 0; vertex < residual.rows(); ++vertex)
    {
      full.segment<2>(2 * vertex) = residual.row(vertex).transpose();
    }
    const Eigen::VectorXd correction =
      factor.Substitute(factor.Eliminate(prolongation.transpose() * full)).col(0);
    const double fraction =
      i == 0 ? 1.0 : correction.lpNorm<Eigen::Infinity>() / free.lpNorm<Eigen::Infinity>();
    if (!(fraction < previous))
    {
      break; // converged to rounding; RequireInjective reports maps that are unusable
    }
    free += correction;
    previous = fraction;
    if (fraction <= NegligibleSquared)
    {
      break;
    }
  }
  return free;
}
}
