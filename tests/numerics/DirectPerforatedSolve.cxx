#include "DirectPerforatedSolve.h"

#include "DualSolve.h"
#include "NestedDissection.h"
#include "SparseCholesky.h"

#include <Eigen/Cholesky>

namespace crossfield
{
namespace
{
constexpr int Aligned = -1;

/// Numbering of the unknown edges and prescribed values of the others.
struct Unknowns
{
  std::vector<int> ofEdge;     ///< Number of the unknown on each edge, or Aligned.
  std::vector<Point> midpoint; ///< Midpoint of the edge of each unknown.
  std::vector<int> holes;      ///< Unknowns on holes, hole by hole counter-clockwise.
  ComplexVector aligned;       ///< Prescribed value on each edge; zero if it is an unknown.
};

Unknowns NumberUnknowns(
  const TriangleMesh& mesh, const EdgeNumbering& edges, const std::vector<BoundaryLoop>& loops)
{
  Unknowns unknowns;
  unknowns.ofEdge.assign(static_cast<std::size_t>(edges.Count()), 0);
  unknowns.aligned = ComplexVector::Zero(edges.Count());
  for (std::size_t i = 0; i < mesh.boundary.size(); ++i)
  {
    const BoundaryEdge& edge = mesh.boundary[i];
    if (edge.kind == BoundaryKind::Outer || edge.kind == BoundaryKind::Inner)
    {
      const int number = edges.ofBoundary[i];
      unknowns.ofEdge[static_cast<std::size_t>(number)] = Aligned;
      unknowns.aligned[number] =
        AlignedRepresentation(mesh.points[static_cast<std::size_t>(edge.vertices[1])] -
          mesh.points[static_cast<std::size_t>(edge.vertices[0])]);
    }
  }
  for (std::size_t e = 0; e < unknowns.ofEdge.size(); ++e)
  {
    if (unknowns.ofEdge[e] != Aligned)
    {
      unknowns.ofEdge[e] = static_cast<int>(unknowns.midpoint.size());
      unknowns.midpoint.push_back(0.5 *
        (mesh.points[static_cast<std::size_t>(edges.vertices[e][0])] +
          mesh.points[static_cast<std::size_t>(edges.vertices[e][1])]));
    }
  }
  for (const BoundaryLoop& loop : loops)
  {
    if (loop.kind == BoundaryKind::Hole)
    {
      for (int edge : loop.edges)
      {
        const int number = edges.ofBoundary[static_cast<std::size_t>(edge)];
        unknowns.holes.push_back(unknowns.ofEdge[static_cast<std::size_t>(number)]);
      }
    }
  }
  return unknowns;
}

/// Returns the block of a matrix over all edges that couples unknowns.
SparseMatrix Restrict(const SparseMatrix& matrix, const Unknowns& unknowns)
{
  std::vector<Eigen::Triplet<double>> entries;
  entries.reserve(static_cast<std::size_t>(matrix.nonZeros()));
  for (int column = 0; column < matrix.outerSize(); ++column)
  {
    const int j = unknowns.ofEdge[static_cast<std::size_t>(column)];
    for (SparseMatrix::InnerIterator entry(matrix, column); j != Aligned && entry; ++entry)
    {
      const int i = unknowns.ofEdge[static_cast<std::size_t>(entry.row())];
      if (i != Aligned)
      {
        entries.emplace_back(i, j, entry.value());
      }
    }
  }
  const auto count = static_cast<Eigen::Index>(unknowns.midpoint.size());
  SparseMatrix restricted(count, count);
  restricted.setFromTriplets(entries.begin(), entries.end());
  return restricted;
}

std::vector<DegreeConstraint> MakeConstraints(
  const TriangleMesh& mesh, const std::vector<BoundaryLoop>& loops, const Unknowns& unknowns)
{
  std::vector<DegreeConstraint> constraints;
  int position = 0;
  for (const BoundaryLoop& loop : loops)
  {
    if (loop.kind != BoundaryKind::Hole)
    {
      continue;
    }
    std::vector<int> positions;
    std::vector<Point> midpoints;
    for (std::size_t i = 0; i < loop.edges.size(); ++i, ++position)
    {
      positions.push_back(position);
      midpoints.push_back(
        unknowns
          .midpoint[static_cast<std::size_t>(unknowns.holes[static_cast<std::size_t>(position)])]);
    }
    constraints.push_back(MakeDegreeConstraint(
      std::move(positions), midpoints, CentreOf(loop, mesh), loop.quarterIndex));
  }
  return constraints;
}

ComplexVector Gather(const ComplexVector& values, const std::vector<int>& positions)
{
  ComplexVector result(static_cast<Eigen::Index>(positions.size()));
  for (std::size_t i = 0; i < positions.size(); ++i)
  {
    result[static_cast<Eigen::Index>(i)] = values[positions[i]];
  }
  return result;
}

ComplexVector SolveComplex(const SparseCholesky& factor, const ComplexVector& rightHandSide)
{
  Eigen::MatrixXd parts(rightHandSide.size(), 2);
  parts << rightHandSide.real(), rightHandSide.imag();
  const Eigen::MatrixXd solution = factor.Solve(parts);
  ComplexVector result(rightHandSide.size());
  result.real() = solution.col(0);
  result.imag() = solution.col(1);
  return result;
}
}

GramMatrix MatrixOn(const std::vector<DegreeConstraint>& constraints, const Eigen::MatrixXd& dense)
{
  std::vector<Eigen::Index> sizes;
  for (const DegreeConstraint& constraint : constraints)
  {
    sizes.push_back(static_cast<Eigen::Index>(constraint.unknowns.size()));
  }
  return { sizes, Eigen::MatrixXd(dense.llt().matrixL()) };
}

ComplexVector ConstraintGradients(const ReducedProblem& problem, const MinimiserResult& solution)
{
  ComplexVector forces = ComplexVector::Zero(solution.x.size());
  for (std::size_t i = 0; i < problem.constraints.size(); ++i)
  {
    forces -= solution.multipliers[static_cast<Eigen::Index>(i)] *
      problem.constraints[i].Gradient(solution.x);
  }
  return forces;
}

SolvedField SolvePerforatedDirectly(const TriangleMesh& mesh, const MinimiserOptions& options)
{
  SolvedField field;
  field.topology = ShareTopology(mesh);
  const EdgeNumbering& edges = field.topology->edges;
  const std::vector<BoundaryLoop>& loops = field.topology->loops;
  field.count = CountMeshQuarters(*field.topology);
  RequireConsistent(field.count);

  const Unknowns unknowns = NumberUnknowns(mesh, edges, loops);
  const std::vector<DegreeConstraint> constraints = MakeConstraints(mesh, loops, unknowns);
  const SparseMatrix stiffness = CrouzeixRaviartStiffness(mesh, edges);
  const SparseMatrix matrix = Restrict(stiffness, unknowns);
  const ComplexVector load = -(stiffness * unknowns.aligned);
  ComplexVector rightHandSide(matrix.rows());
  for (std::size_t e = 0; e < unknowns.ofEdge.size(); ++e)
  {
    if (unknowns.ofEdge[e] != Aligned)
    {
      rightHandSide[unknowns.ofEdge[e]] = load[static_cast<Eigen::Index>(e)];
    }
  }

  const SparseCholesky factor(
    matrix, NestedDissection(matrix, InSpace(unknowns.midpoint), unknowns.holes));

  const ComplexVector harmonic = SolveComplex(factor, rightHandSide);
  const Eigen::MatrixXd root = factor.TrailingFactor(static_cast<int>(unknowns.holes.size()));
  ReducedProblem problem;
  problem.matrix = MatrixOn(constraints, root * root.transpose());
  problem.load = problem.matrix * Gather(harmonic, unknowns.holes);
  problem.constraints = constraints;
  const MinimiserResult reduced = SolveReduced(HoleBases(problem), options);
  field.iterations = reduced.iterations;
  field.residual = reduced.residual;
  field.converged = reduced.converged;
  field.multipliers.assign(reduced.multipliers.begin(), reduced.multipliers.end());

  // The multipliers contribute a gradient on the hole edges.
  const ComplexVector forces = ConstraintGradients(problem, reduced);
  for (std::size_t i = 0; i < unknowns.holes.size(); ++i)
  {
    rightHandSide[unknowns.holes[i]] += forces[static_cast<Eigen::Index>(i)];
  }
  const ComplexVector solution = SolveComplex(factor, rightHandSide);
  field.u = unknowns.aligned;
  for (std::size_t e = 0; e < unknowns.ofEdge.size(); ++e)
  {
    if (unknowns.ofEdge[e] != Aligned)
    {
      field.u[static_cast<Eigen::Index>(e)] = solution[unknowns.ofEdge[e]];
    }
  }
  field.energy = 0.5 * field.u.dot(stiffness * field.u).real();
  field.Read();
  return field;
}
}
