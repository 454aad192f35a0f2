#pragma once

#include "Minimisation.h"
#include "ReducedProblem.h"
#include "SolvedField.h"

namespace crossfield
{
/// Converts a dense symmetric positive definite matrix to one with a block for each constraint.
GramMatrix MatrixOn(const std::vector<DegreeConstraint>& constraints, const Eigen::MatrixXd& dense);

/// Returns −Σ λ_i A_i x, the gradient of the constraint terms on the hole edges; it equals S x − b
/// at a solution.
ComplexVector ConstraintGradients(const ReducedProblem& problem, const MinimiserResult& solution);

/// Solves the constrained problem of PotentialReduction.h in its direct form (docs/method.md §3.2),
/// as a reference for the reduced form.
///
/// The Crouzeix-Raviart stiffness matrix itself is factored with the hole edges last; its trailing
/// block is the Schur complement S on them, and the energy is ½ uᴴ K u.
SolvedField SolvePerforatedDirectly(const TriangleMesh& mesh, const MinimiserOptions& options = {});
}
