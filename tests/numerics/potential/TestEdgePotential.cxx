#include "CrouzeixRaviart.h"
#include "DrillHoles.h"
#include "EdgePotential.h"
#include "MakePlanarDomain.h"
#include "Support.h"

#include <Eigen/SparseCholesky>

#include <cmath>

namespace crossfield::test
{
namespace
{
/// Returns a square with two islands, one of them next to the boundary.
SharedPlanarTopology WithIslands(double size)
{
  const PlanarDomain domain =
    MakePlanarDomain({ { { 0.0, 0.0 }, { 1.0, 0.0 }, { 1.0, 1.0 }, { 0.0, 1.0 } },
      { { 0.2, 0.2 }, { 0.4, 0.2 }, { 0.4, 0.4 }, { 0.2, 0.4 } },
      { { 0.7, 0.6 }, { 0.9, 0.7 }, { 0.8, 0.9 } } });
  DrillOptions options;
  options.meshSize = size;
  return ShareTopology(DrillHoles(domain, {}, options));
}

/// Returns fluxes through boundary edges that add up to zero; those through each loop do not.
Eigen::VectorXd FluxesOn(const PlanarTopology& topology)
{
  Eigen::VectorXd fluxes(static_cast<Eigen::Index>(topology.mesh.boundary.size()));
  for (Eigen::Index i = 0; i < fluxes.size(); ++i)
  {
    fluxes[i] = std::sin(1.0 + 2.7 * static_cast<double>(i)) + 0.1;
  }
  fluxes.array() -= fluxes.mean();
  return fluxes;
}

TEST(EdgePotential, AgreesWithTheCrouzeixRaviartSolution)
{
  const SharedPlanarTopology topology = WithIslands(0.07);
  const PotentialSolver solver(topology);
  const Eigen::VectorXd fluxes = FluxesOn(*topology);
  const Eigen::VectorXd values = EdgePotential(solver).Solve(fluxes);

  // Compare with a direct solve. A term on the diagonal at the first outer edge makes the potential
  // 0 there.
  SparseMatrix matrix = CrouzeixRaviartStiffness(topology->mesh, topology->edges);
  const int ground = topology->EdgeOfBoundary(topology->loops[0].edges.front());
  matrix.coeffRef(ground, ground) += 1.0;
  Eigen::VectorXd sources = Eigen::VectorXd::Zero(matrix.rows());
  for (Eigen::Index i = 0; i < fluxes.size(); ++i)
  {
    sources[topology->EdgeOfBoundary(static_cast<int>(i))] += fluxes[i];
  }
  const Eigen::VectorXd expected = Eigen::SimplicialLDLT<SparseMatrix>(matrix).solve(sources);
  for (Eigen::Index i = 0; i < fluxes.size(); ++i)
  {
    EXPECT_NEAR(values[i], expected[topology->EdgeOfBoundary(static_cast<int>(i))], 1e-10);
  }
}

TEST(EdgePotential, IsSymmetricAndHasMoreEnergyThanThePotentialAtVertices)
{
  const SharedPlanarTopology topology = WithIslands(0.1);
  const PotentialSolver solver(topology);
  const EdgePotential edges(solver);
  const Eigen::VectorXd fluxes = FluxesOn(*topology);
  const Eigen::VectorXd others = fluxes.reverse();
  EXPECT_NEAR(
    others.dot(edges.Solve(fluxes).col(0)), fluxes.dot(edges.Solve(others).col(0)), 1e-10);

  // Dividing the flux of an edge equally between its ends is exact for functions that are linear on
  // edges.
  Eigen::VectorXd sources = Eigen::VectorXd::Zero(solver.Rows());
  for (Eigen::Index i = 0; i < fluxes.size(); ++i)
  {
    for (const int vertex : topology->BoundaryAt(static_cast<int>(i)).vertices)
    {
      sources[vertex] += 0.5 * fluxes[i];
    }
  }
  // With free periods the potential has more energy than with periods of zero, which W uses, but
  // still less than the potential on edges.
  const Eigen::VectorXd atVertices = solver.Solve(sources, PotentialSolver::Periods::Islands);
  EXPECT_GT(fluxes.dot(edges.Solve(fluxes).col(0)), 1.01 * sources.dot(atVertices));
}
}
}
