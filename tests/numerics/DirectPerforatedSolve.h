#pragma once

#include "Minimisation.h"
#include "ReducedProblem.h"
#include "SolvedField.h"

namespace crossfield
{
/// A symmetric positive definite matrix with a block for every constraint.
GramMatrix MatrixOn(const std::vector<DegreeConstraint>& constraints, const Eigen::MatrixXd& dense);

/// −Σ λ_i A_i x: the forces on the hole edges that hold the constraints, S x − b when solved.
ComplexVector ConstraintGradients(const ReducedProblem& problem, const MinimiserResult& solution);

/// The constrained problem of PotentialReduction.h in its direct form (docs/method.md §3.2): the oracle
/// that the reduced form is compared with.
///
/// The Crouzeix-Raviart stiffness matrix itself is factored with the hole edges last; its trailing
/// block is the Schur complement S on them, and the energy is ½ uᴴ K u.
SolvedField SolvePerforatedDirectly(const TriangleMesh& mesh, const MinimiserOptions& options = {});
}
