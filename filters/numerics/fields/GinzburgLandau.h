#pragma once

#include "GinzburgLandauEnergy.h"
#include "Progress.h"
#include "SolvedField.h"

namespace crossfield
{
/// Field from which the iteration starts; it determines which minimum is found. The values on
/// aligned edges are always those of the boundary.
enum class GinzburgLandauStart
{
  Harmonic, ///< The field without penalty.
  Constant, ///< u = 1, crosses along the axes.
  Zero,     ///< u = 0.
  Given     ///< GinzburgLandauOptions::given.
};

struct GinzburgLandauOptions
{
  /// ε, a length: approximately the radius of the cores of singularities. 0 selects the mean edge
  /// length weighted by area, which represents most of the domain even if most edges are on a fine
  /// boundary. Below a third of the edge length, the mesh pins singularities at arbitrary
  /// positions.
  double epsilon = 0.0;
  GinzburgLandauStart start = GinzburgLandauStart::Harmonic;
  ComplexVector given; ///< One value per edge.
  GinzburgLandauPinning pinning;
  int maximumIterations = 500;
  /// Converged when the derivative relative to GinzburgLandauEnergy::ResidualScale is below this.
  double tolerance = 1e-10;
};

/// Returns the ε that the options select on a mesh.
double ResolveEpsilon(const GinzburgLandauOptions& options, const PlanarTopology& topology);

/// Local minimiser of GinzburgLandauEnergy, with the report of the solver. In the report:
/// - energy = gradientEnergy + penaltyEnergy;
/// - count.givenInteriorQuarters is the sum of the singularities found inside, so that the count
///   compares the sum that the domain requires with that of the field;
/// - unwantedSingularities counts those in excess of the minimum that the Poincaré-Hopf theorem
///   requires.
struct GinzburgLandauField : SolvedField
{
  /// Energies at the start and after every iteration; they never increase by more than rounding.
  std::vector<double> energies;
  int convexifiedSteps = 0; ///< Iterations in which the Hessian was not positive definite.
  int saddlesLeft = 0;      ///< Iterations that left a saddle along negative curvature.
};

/// Minimises the Ginzburg-Landau energy (docs/method.md §4.2; paper, "Ginzburg-Landau") by
/// PenaltySolve.h without constraints: Newton's method with a line search on the energy.
///
/// Where the Hessian H is not positive definite, H + τ D is factored instead, where D is the matrix
/// of 1/ε² ∫ f² u · v and τ = 1/64, 1/16, 1/4 or 1; for τ = 1 it is always positive definite. Steps
/// with a small τ follow the directions in which the energy decreases from a saddle. The result
/// counts as converged only if H itself is positive definite at the end; intermediate saddles are
/// left along their negative curvature.
///
/// Any domain is allowed, since the field chooses its singularities. Throws Error when the mesh has
/// holes, ε is not positive, or the given start does not fit the mesh. An iteration that does not
/// converge is not an error: see SolveReport::converged.
GinzburgLandauField SolveGinzburgLandau(const SharedPlanarTopology& topology,
  const GinzburgLandauOptions& options = {}, const Progress& progress = {});
}
