#include "GinzburgLandau.h"

#include "Error.h"
#include "FieldSingularities.h"
#include "SparseCholesky.h"
#include "Stopwatch.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <string>

namespace crossfield
{
namespace
{
/// The convexifications τ that are tried in turn.
constexpr double FirstShift = 1.0 / 64.0;
constexpr double ShiftGrowth = 4.0;
/// Adding the whole metric always makes the Hessian positive definite.
constexpr double LastShift = 1.0;

/// A convexified step that lowers the energy by less than this, relatively, is caught at a saddle:
/// such steps converge to it slowly, where the way down is another one.
constexpr double SlowDescent = 1e-4;

/// Energies that differ by less than this, relatively, differ by rounding.
constexpr double EnergyRounding = 1e-13;

void RequireNoHoles(const MeshTopology& topology)
{
  if (topology.LoopCount(BoundaryKind::Hole) > 0)
  {
    throw Error("The mesh has holes for singularities, but the Ginzburg-Landau method places "
                "singularities by itself; give the domain drilled without any.");
  }
}

ComplexVector Start(const GinzburgLandauOptions& options, const GinzburgLandauEnergy& energy,
  const EdgeNumbering& edges)
{
  ComplexVector u;
  switch (options.start)
  {
  case GinzburgLandauStart::Harmonic:
    return energy.HarmonicField();
  case GinzburgLandauStart::Constant:
    u = ComplexVector::Ones(edges.Count());
    break;
  case GinzburgLandauStart::Zero:
    u = ComplexVector::Zero(edges.Count());
    break;
  case GinzburgLandauStart::Given:
    if (options.given.size() != edges.Count() || !options.given.allFinite())
    {
      throw Error("The field to start from has " + std::to_string(options.given.size()) +
        " values or some that are not finite; give one finite value for each of the " +
        std::to_string(edges.Count()) + " edges.");
    }
    u = options.given;
    break;
  }
  energy.Align(u);
  return u;
}

class Minimiser
{
public:
  Minimiser(const GinzburgLandauEnergy& energy, ComplexVector start)
    : Functional(energy)
    , Order(energy.UnknownOrder())
    , U(std::move(start))
    , Energy(energy.Value(this->U))
    , Residual(energy.RelativeResidual(this->U))
  {
  }

  const ComplexVector& GetField() const { return this->U; }
  double GetEnergy() const { return this->Energy; }
  double GetResidual() const { return this->Residual; }
  bool WasConvexified() const { return this->Shift > 0.0; }

  /// Whether the Hessian is positive definite here.
  bool AtMinimum()
  {
    this->Shift = 0.0;
    return this->TryFactor();
  }

  /// One step of Newton's method; false when no step decreases the energy.
  bool Step()
  {
    this->FactorConvexified();
    const Eigen::VectorXd gradient = this->Functional.Gradient(this->U);
    const Eigen::VectorXd direction = -this->Factor->Solve(gradient);
    const double slope = gradient.dot(direction);
    // Forty halvings: below that a step is lost in the rounding of the field.
    double length = 1.0;
    for (int halving = 0; halving < 40; ++halving, length *= 0.5)
    {
      if (this->Accept(length * direction, 1e-4 * length * slope))
      {
        // A full step says that the quadratic model holds: ask for less help next time.
        this->NextShift = halving == 0 ? this->Shift / ShiftGrowth : this->Shift;
        return true;
      }
    }
    return false;
  }

  /// Leaves a critical point in a direction of negative curvature; false when none is found.
  bool LeaveSaddle()
  {
    this->Shift = LastShift;
    if (!this->TryFactor())
    {
      return false;
    }
    const Eigen::VectorXd metric = this->Functional.Metric();
    Eigen::VectorXd direction(metric.size());
    for (Eigen::Index i = 0; i < direction.size(); ++i)
    {
      // Anything that has no symmetry of the mesh.
      direction[i] = std::sin(12.9898 * static_cast<double>(i + 1));
    }
    // The lowest eigenvalue of (H + D, D) is below 1; what is above 2 fades by half in each round.
    for (int round = 0; round < 30; ++round)
    {
      direction = this->Factor->Solve(metric.cwiseProduct(direction).eval());
      direction /= direction.lpNorm<Eigen::Infinity>();
    }
    if (direction.dot(this->Functional.Gradient(this->U)) > 0.0)
    {
      direction = -direction;
    }
    const Eigen::VectorXd curved = this->Functional.Hessian(this->U) * direction;
    const double curvature = direction.dot(curved);
    for (double length = 1.0; curvature < 0.0 && length > 1e-6; length *= 0.5)
    {
      if (this->Accept(length * direction, 0.25 * length * length * curvature))
      {
        return true;
      }
    }
    return false;
  }

private:
  bool TryFactor()
  {
    try
    {
      this->Factor = std::make_unique<SparseCholesky>(
        this->Functional.Hessian(this->U, this->Shift), this->Order);
      return true;
    }
    catch (const NotPositiveDefinite&)
    {
      return false;
    }
  }

  /// Factors the Hessian with the smallest shift that works, starting from that of the last step.
  void FactorConvexified()
  {
    this->Shift = this->NextShift < FirstShift ? 0.0 : this->NextShift;
    while (!this->TryFactor())
    {
      if (this->Shift >= LastShift)
      {
        throw Error("The Hessian of the Ginzburg-Landau energy cannot be factored; the mesh may be "
                    "in several parts or have degenerate triangles, remesh the domain.");
      }
      this->Shift = std::clamp(ShiftGrowth * this->Shift, FirstShift, LastShift);
    }
  }

  /// Takes a step if the energy decreases by a given amount, or, where rounding hides that, the
  /// gradient halves.
  bool Accept(const Eigen::VectorXd& step, double wantedChange)
  {
    ComplexVector trial = this->U;
    const std::vector<int>& free = this->Functional.FreeEdges();
    for (std::size_t i = 0; i < free.size(); ++i)
    {
      const auto row = 2 * static_cast<Eigen::Index>(i);
      trial[free[i]] += Complex(step[row], step[row + 1]);
    }
    const double energy = this->Functional.Value(trial);
    const double residual = this->Functional.RelativeResidual(trial);
    const bool decreases = energy <= this->Energy + wantedChange && energy < this->Energy;
    const bool settles = energy <= this->Energy + EnergyRounding * std::abs(this->Energy) &&
      residual <= 0.5 * this->Residual;
    if (!decreases && !settles)
    {
      return false;
    }
    this->U = std::move(trial);
    this->Energy = energy;
    this->Residual = residual;
    return true;
  }

  const GinzburgLandauEnergy& Functional;
  std::vector<int> Order;
  ComplexVector U;
  double Energy;
  double Residual;
  double Shift = 0.0;     ///< Of the last factorisation.
  double NextShift = 0.0; ///< To begin with in the next step.
  std::unique_ptr<SparseCholesky> Factor;
};

void Iterate(Minimiser& minimiser, const GinzburgLandauOptions& options, const Progress& progress,
  GinzburgLandauField& field)
{
  field.energies.push_back(minimiser.GetEnergy());
  bool moved = true;
  bool slow = false;
  while (moved && !field.converged && field.iterations < options.maximumIterations)
  {
    progress.Report(static_cast<double>(field.iterations) / options.maximumIterations);
    const bool critical = minimiser.GetResidual() <= options.tolerance;
    if (critical && minimiser.AtMinimum())
    {
      field.converged = true;
      return;
    }
    const double before = minimiser.GetEnergy();
    const bool leaves = (critical || slow) && minimiser.LeaveSaddle();
    field.saddlesLeft += leaves ? 1 : 0;
    slow = false;
    if (!leaves)
    {
      moved = !critical && minimiser.Step();
      const bool convexified = !critical && minimiser.WasConvexified();
      field.convexifiedSteps += convexified ? 1 : 0;
      slow = convexified && before - minimiser.GetEnergy() < SlowDescent * std::abs(before);
    }
    ++field.iterations;
    field.energies.push_back(minimiser.GetEnergy());
  }
}

}

double ResolveEpsilon(const GinzburgLandauOptions& options, const MeshTopology& topology)
{
  if (options.epsilon != 0.0)
  {
    return options.epsilon;
  }
  double sum = 0.0;
  for (const auto& [from, to] : topology.edges.vertices)
  {
    sum += (topology.PointAt(to) - topology.PointAt(from)).norm();
  }
  return sum / topology.edges.Count();
}

GinzburgLandauField SolveGinzburgLandau(
  const SharedTopology& topology, const GinzburgLandauOptions& options, const Progress& progress)
{
  Stopwatch stopwatch;
  RequireNoHoles(*topology);
  GinzburgLandauField field;
  field.topology = topology;
  field.count = CountMeshQuarters(*topology);
  field.epsilon = ResolveEpsilon(options, *topology);
  const GinzburgLandauEnergy energy(*topology, field.epsilon, options.pinning);
  field.seconds.assemble = stopwatch.Lap();
  progress.Report(0.05);

  field.u = Start(options, energy, topology->edges);
  field.seconds.factor = stopwatch.Lap();
  progress.Report(0.1);

  Minimiser minimiser(energy, field.u);
  if (energy.FreeEdges().empty())
  {
    field.converged = true;
  }
  Iterate(minimiser, options, progress.Part(0.1, 0.95), field);
  field.u = minimiser.GetField();
  field.residual = minimiser.GetResidual();
  field.gradientEnergy = energy.GradientPart(field.u);
  field.penaltyEnergy = energy.PenaltyPart(field.u);
  field.energy = field.gradientEnergy + field.penaltyEnergy;
  field.Read();
  field.count.givenInteriorQuarters = 0;
  for (const FieldSingularity& singularity : FindFieldSingularities(field))
  {
    field.count.givenInteriorQuarters += singularity.quarterIndex;
  }
  field.seconds.solve = stopwatch.Lap();
  progress.Report(1.0);
  return field;
}
}
