#pragma once

#include "FieldIndices.h"
#include "PoincareHopf.h"

namespace crossfield
{
/// Seconds spent in the stages of a solve.
struct StageSeconds
{
  double assemble = 0.0;
  double factor = 0.0;
  double solve = 0.0;
  double newton = 0.0; ///< The part of solve that is iterations on the hole edges.
};

/// A cross field on a drilled mesh, and what the solver has to say about it.
struct CrossField
{
  EdgeNumbering edges;
  ComplexVector u; ///< Representation at each edge.

  double energy = 0.0; ///< ½ ∫ |∇u|², summed over triangles.
  int iterations = 0;
  double residual = 0.0; ///< Of the optimality conditions, relative.
  bool converged = false;
  /// Constrained method: the field was started from the unit-norm field, not the harmonic one.
  bool startedFromUnitNorm = false;
  bool unitHoles = false; ///< Constrained method: |u| = 1 was forced on the holes.
  std::vector<double> multipliers; ///< One per hole, for the constraint C of DegreeConstraint.

  /// Per inner loop, radians; unit-norm method only (UnitNormField.h).
  std::vector<double> holonomyDefect;

  std::vector<HoleReading> holes; ///< In the order of the configuration.
  int wrongDegrees = 0; ///< Holes whose degree is not the prescribed one.
  int unwantedSingularities = 0;
  PoincareHopfCount count;
  StageSeconds seconds;
};

/// Fills holes, wrongDegrees and unwantedSingularities from the field: triangles and vertices with an index
/// other than zero count as unwanted, except corners of the boundary, which may take what they
/// like. Throws Error if the indices do not add up to 4χ, which would be a defect of this library.
void ReadReport(const TriangleMesh& mesh, const std::vector<BoundaryLoop>& loops, CrossField& field);
}
