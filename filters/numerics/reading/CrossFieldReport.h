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

  double energy = 0.0;  ///< ½ ∫ |∇u|², summed over triangles; with a penalty, that as well.
  double epsilon = 0.0; ///< Of the penalty 1/(4ε²) ∫ (|u|² − f²)²; 0: there is none.
  double gradientEnergy = 0.0; ///< With a penalty: ½ ∫ w |∇u|²,
  double penaltyEnergy = 0.0;  ///< and the penalty.
  int iterations = 0;
  double residual = 0.0; ///< Of the optimality conditions, relative.
  bool converged = false;
  /// Constrained method: the field was started from the unit-norm field, not the harmonic one.
  bool startedFromUnitNorm = false;
  bool unitHoles = false;          ///< Constrained method: |u| = 1 was forced on holes.
  bool globalConstraint = false;   ///< Only the sum of the degrees was prescribed.
  std::vector<double> multipliers; ///< One per hole, for the constraint C of DegreeConstraint.

  /// Per inner loop, radians; unit-norm method only (UnitNormField.h).
  std::vector<double> holonomyDefect;

  /// Of holes and imprinted circles, in the order of the configuration.
  std::vector<HoleReading> holes;
  int wrongDegrees = 0;       ///< Holes whose degree is not the prescribed one.
  bool degreesReached = true; ///< None is wrong; with the global constraint, their sum is right.
  int unwantedSingularities = 0;
  PoincareHopfCount count;
  StageSeconds seconds;
};

/// Fills holes, degrees and unwantedSingularities from the field. Throws Error if the indices do not
/// add up to 4χ, which would be a defect of this library.
///
/// Unwanted are triangles and vertices with an index other than zero, except corners of the boundary,
/// which may take what they like. Where singularities may appear by themselves, beside imprinted
/// circles and with a penalty, they are counted as FieldSingularities.h reads them, by |k|; those in
/// an imprinted circle or within an edge of it count as far as they exceed what it asks for.
void ReadReport(
  const TriangleMesh& mesh, const std::vector<BoundaryLoop>& loops, CrossField& field);

/// Which of two fields is the better answer: converged, with fewer wrong degrees, fewer unwanted
/// singularities, less energy; the first that differs decides.
bool IsBetter(const CrossField& field, const CrossField& other);
}
