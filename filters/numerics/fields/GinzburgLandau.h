#pragma once

#include "GinzburgLandauEnergy.h"
#include "Progress.h"
#include "SolvedField.h"

namespace crossfield
{
/// The field that the iteration starts from; the minimum that it ends in depends on it. The values
/// on aligned edges are those of the boundary in any case.
enum class GinzburgLandauStart
{
  Harmonic, ///< The field without penalty.
  Constant, ///< u = 1, crosses along the axes.
  Zero,     ///< u = 0.
  Given     ///< GinzburgLandauOptions::given.
};

struct GinzburgLandauOptions
{
  /// ε, a length: about the radius of the cores of singularities. 0: the mean edge length weighted
  /// by area, that of most of the domain also where a fine boundary has most of the edges. Below a
  /// third of the edge length the mesh holds singularities wherever they happen to be.
  double epsilon = 0.0;
  GinzburgLandauStart start = GinzburgLandauStart::Harmonic;
  ComplexVector given; ///< One value per edge.
  GinzburgLandauPinning pinning;
  int maximumIterations = 500;
  /// Converged when the derivative, relative to GinzburgLandauEnergy::ResidualScale, is below this.
  double tolerance = 1e-10;
};

/// The ε that options ask for on a mesh.
double ResolveEpsilon(const GinzburgLandauOptions& options, const MeshTopology& topology);

/// A local minimiser of GinzburgLandauEnergy, and what the solver has to say about it. In the
/// report:
/// - energy = gradientEnergy + penaltyEnergy;
/// - count.givenInteriorQuarters is the sum of the singularities found inside, so that the count
///   compares what the domain requires with what the field has;
/// - unwantedSingularities is what the field has beyond the least that the Poincaré-Hopf theorem requires.
struct GinzburgLandauField : SolvedField
{
  /// Of the start and after every iteration; never rises by more than rounding.
  std::vector<double> energies;
  int convexifiedSteps = 0; ///< Iterations in which the Hessian was not positive definite.
  int saddlesLeft = 0;      ///< Iterations that left a saddle by its negative curvature.
};

/// Minimises the Ginzburg-Landau energy (docs/method.md §4.2; paper, "Ginzburg-Landau") by
/// PenaltySolve.h without constraints: Newton's method with a line search on the energy.
///
/// Where the Hessian H is not positive definite, H + τ D is factored instead, D the matrix of
/// 1/ε² ∫ f² u · v and τ = 1/64, 1/16, 1/4 or 1, for which it always is; steps with a small τ
/// follow the directions in which the energy falls off a saddle. It is converged only if H itself
/// is positive definite at the end; saddles on the way are left by their negative curvature.
///
/// Any domain is allowed, since the singularities come by themselves. Throws Error when the mesh
/// has holes, ε is not positive, or the given start does not fit the mesh. An iteration that does
/// not converge is not an error: see SolveReport::converged.
GinzburgLandauField SolveGinzburgLandau(const SharedTopology& topology,
  const GinzburgLandauOptions& options = {}, const Progress& progress = {});
}
