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
  std::vector<double> multipliers; ///< One per hole, for the constraint C of DegreeConstraint.

  /// Per inner loop, radians; unit-norm method only (UnitNormField.h).
  std::vector<double> holonomyDefect;

  std::vector<HoleReading> holes; ///< In the order of the configuration.
  int unwantedSingularities = 0;
  PoincareHopfCount count;
  StageSeconds seconds;
};

/// Fills holes and unwantedSingularities from the field: triangles and vertices with an index
/// other than zero count as unwanted, except corners of the boundary, which may take what they
/// like. Throws Error if the indices do not add up to 4χ, which would be a defect of this library.
void ReadReport(const TriangleMesh& mesh, const std::vector<BoundaryLoop>& loops, CrossField& field);
}
