#include "QuadSmoothing.h"

#include "BoundaryOrder.h"
#include "Index.h"
#include "NodePairs.h"
#include "Parts.h"
#include "QuadDescent.h"
#include "QuadPart.h"
#include "QuadQuality.h"
#include "QuadRank.h"
#include "QuadSizes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace crossfield
{
namespace
{
/// Maximum number of quads that are smoothed without coarser meshes.
constexpr std::size_t MaximumAlone = 5000;

/// Weight of size against shape for the sizes of the map: shape matters most, but sizes must not
/// drift.
constexpr double ConformalSizePart = 0.2;

/// Limits without a coarser mesh: until a step gains 1e-7 of the energy, far below what is visible.
constexpr DescentLimits Alone = { 120, 0.0, 1e-7 };
/// Limits with a coarser mesh, which corrects long wavelengths: until a step gains a hundredth of
/// the energy above the ideal value.
constexpr DescentLimits BesideCoarser = { 5, 1e-2, 1e-7 };

/// Maximum number of steps that untangle quads for one ε.
constexpr int StepsOfRound = 100;

/// Returns the maximum number of steps that untangle quads. Quads that can be untangled
/// took at most 200 steps in all examples. The steps of large meshes are limited to two seconds.
int MaximumUntangling(Eigen::Index unknowns)
{
  constexpr Eigen::Index MaximumSteps = 2000;
  constexpr Eigen::Index Work = 5000000; // unknowns, two of each point, times steps
  const Eigen::Index steps = Work / std::max<Eigen::Index>(unknowns, 1);
  return static_cast<int>(std::clamp<Eigen::Index>(steps, StepsOfRound, MaximumSteps));
}

/// A mesh of the hierarchy with its weights and lattices.
struct Level
{
  QuadMesh& mesh;
  const std::vector<double>& weights;
  const std::vector<QuadLattice>& lattices;
};

class Smoother
{
public:
  Smoother(const SmoothingDomain& domain, bool release, double sizePart)
    : Curves(domain.curves)
    , Surface(domain.surface)
    , Release(release)
    , SizePart(sizePart)
  {
  }

  QuadEnergy EnergyOf(const QuadMesh& mesh, const std::vector<double>& weights) const
  {
    return { mesh, this->Curves, this->Moves(mesh), this->SizePart, weights, this->Surface };
  }

  /// Minimises the energy of a mesh. Returns the number of steps on the mesh itself.
  int Smooth(const Level& level, const Progress& progress) const
  {
    return this->InRounds(level.mesh, SurfaceRounds, progress,
      [&](const Progress& part) { return this->SmoothOnce(level, {}, part); });
  }

  /// Smooths some rings around every singularity, periodic side and inverted quad until convergence:
  /// there quads vary most, and a coarser mesh is least accurate.
  void SmoothNearCones(QuadMesh& mesh) const
  {
    this->InRounds(
      mesh, SurfaceRounds, {}, [&](const Progress&) { return this->SmoothNearConesOnce(mesh); });
  }

  /// Distributes a deviation that cannot vanish: minimises sums of growing powers of the energy of
  /// corners. Returns the number of steps.
  int Even(QuadMesh& mesh, const Progress& progress) const
  {
    // Each descent starts with the smallest power, and so moves points again.
    constexpr int Few = 2;
    return this->InRounds(
      mesh, Few, progress, [&](const Progress& part) { return this->EvenOnce(mesh, part); });
  }

  /// Displaces the points of a mesh that are not fixed, and untangles quads that this inverts
  /// together with their surroundings.
  void Displace(const Level& level, const Eigen::VectorXd& displacement) const
  {
    QuadEnergy energy = this->EnergyOf(level.mesh, level.weights);
    const Eigen::VectorXd moved = energy.Unknowns() + energy.Masked(displacement);
    energy.Store(moved, level.mesh);
    if (energy.MinimumDeterminant(moved) <= 0.0)
    {
      this->SmoothNearCones(level.mesh);
    }
  }

private:
  /// Most descents on a surface: enough where quads are smaller than its radius of curvature.
  static constexpr int SurfaceRounds = 6;

  /// What one descent did.
  struct Descent
  {
    int steps = 0;
    double distance = 0.0; ///< That of QuadEnergy::Store.
  };

  /// Repeats a descent on a surface until its tangent planes are near the surface, each time with new ones, unless it
  /// inverts quads: that is undone. Returns the number of steps.
  template <typename Once>
  int InRounds(QuadMesh& mesh, int rounds, const Progress& progress, const Once& once) const
  {
    if (this->Surface == nullptr)
    {
      return once(progress).steps;
    }
    constexpr double Near = 1e-3; // of an edge: hardly visible
    SetNormals(*this->Surface, mesh);
    int steps = 0;
    for (int round = 0; round < rounds; ++round)
    {
      const std::vector<QuadPoint> before = mesh.points;
      const int inverted = RankOf(mesh).inverted;
      const double done = static_cast<double>(round) / rounds;
      const Descent descent = once(progress.Part(done, done + 1.0 / rounds));
      steps += descent.steps;
      SetNormals(*this->Surface, mesh);
      if (RankOf(mesh).inverted > inverted)
      {
        mesh.points = before;
        SetNormals(*this->Surface, mesh);
        break;
      }
      if (descent.distance < Near)
      {
        break;
      }
    }
    return steps;
  }

  /// Minimises the energy of a mesh, with a tilt if it is not empty.
  Descent SmoothOnce(
    const Level& level, const Eigen::VectorXd& tilt, const Progress& progress) const
  {
    QuadEnergy energy = this->EnergyOf(level.mesh, level.weights);
    QuadDescent descent(energy);
    Eigen::VectorXd unknowns = energy.Unknowns();
    // Around a loop with few edges one of them might become so long that its chord crosses the hole.
    // Four equal edges, the fewest of a loop, are not too long.
    constexpr double LongPart = 0.25;
    if (!(energy.MinimumDeterminant(unknowns) > 0.0) ||
      HasLongEdges(level.mesh, this->Curves, LongPart))
    {
      energy.HoldOrderOnBoundary();
    }
    const bool large = level.mesh.quads.size() > MaximumAlone && !level.lattices.empty();
    int steps = this->Untangle(energy, descent, unknowns, progress);
    if (energy.MinimumDeterminant(unknowns) > 0.0)
    {
      energy.Tilt(tilt, unknowns);
      if (large)
      {
        steps += descent.Descend(0.0, BesideCoarser, unknowns, progress.Part(0.0, 0.4));
        energy.Store(unknowns, level.mesh);
        this->Correct(energy, level, unknowns, progress.Part(0.4, 0.6));
      }
      steps += descent.Descend(
        0.0, large ? BesideCoarser : Alone, unknowns, progress.Part(large ? 0.6 : 0.0, 1.0));
    }
    return { steps, energy.Store(unknowns, level.mesh) };
  }

  Descent SmoothNearConesOnce(QuadMesh& mesh) const
  {
    constexpr int Rings = 12; // six rings of a coarser mesh
    QuadPart part(mesh, this->Moves(mesh), Rings);
    QuadEnergy energy(part.mesh, this->Curves, part.moves, this->SizePart,
      std::vector<double>(part.mesh.quads.size(), 1.0), this->Surface);
    QuadDescent descent(energy);
    Eigen::VectorXd unknowns = energy.Unknowns();
    Descent result = { this->Untangle(energy, descent, unknowns, {}), 0.0 };
    if (energy.MinimumDeterminant(unknowns) > 0.0)
    {
      result.steps += descent.Descend(0.0, Alone, unknowns);
      result.distance = energy.Store(unknowns, part.mesh);
      part.CopyPoints(mesh);
    }
    return result;
  }

  Descent EvenOnce(QuadMesh& mesh, const Progress& progress) const
  {
    QuadEnergy energy = this->EnergyOf(mesh, std::vector<double>(mesh.quads.size(), 1.0));
    energy.HoldOrderOnBoundary();
    QuadDescent descent(energy);
    Eigen::VectorXd unknowns = energy.Unknowns();
    if (!(energy.MinimumDeterminant(unknowns) > 0.0))
    {
      return {};
    }
    int steps = 0;
    for (const double power : { 2.0, 4.0, 8.0, 16.0, 32.0 })
    {
      energy.SetPower(power);
      steps += descent.Descend(0.0, Alone, unknowns, progress);
    }
    return { steps, energy.Store(unknowns, mesh) };
  }

  /// Returns which points are not fixed.
  std::vector<bool> Moves(const QuadMesh& mesh) const
  {
    std::vector<bool> moves;
    moves.reserve(mesh.points.size());
    for (const QuadPoint& point : mesh.points)
    {
      moves.push_back(!point.fixed || (this->Release && point.curve.loop < 0 && !point.held));
    }
    MovePairsTogether(mesh, moves);
    return moves;
  }

  /// Makes the determinants of all corners at least Flattest, if possible. ε follows the minimum
  /// determinant and the decrease of the energy (Garanzha et al. 2021): the next minimum of χ is to be
  /// the present one less the part by which the energy decreased. Returns the number of steps.
  int Untangle(QuadEnergy& energy, QuadDescent& descent, Eigen::VectorXd& unknowns,
    const Progress& progress) const
  {
    // A corner of determinant D has a gradient of about 1/D², so with ε = 0 the first step is too long by 1/D³, and 30
    // halvings shorten it enough from here on.
    constexpr double Flattest = 1e-3;
    // χ decreases by a tenth at least per round: to 2e-3 of its start in all.
    constexpr int Rounds = 60;
    constexpr double SmallestDecrease = 0.1;
    const int maximumSteps = MaximumUntangling(unknowns.size());
    int steps = 0;
    double minimum = energy.MinimumDeterminant(unknowns);
    double epsilon = std::sqrt(1e-4 + 0.25 * minimum * minimum);
    for (int round = 0; round < Rounds && minimum < Flattest && steps < maximumSteps; ++round)
    {
      const DescentLimits limits = { std::min(StepsOfRound, maximumSteps - steps), 0.0, 1e-6 };
      const double before = energy.Value(unknowns, epsilon, nullptr);
      steps += descent.Descend(epsilon, limits, unknowns, progress);
      minimum = energy.MinimumDeterminant(unknowns);
      const double decrease =
        std::max(SmallestDecrease, 1.0 - energy.Value(unknowns, epsilon, nullptr) / before);
      const double goal = 0.5 * (1.0 - decrease) * (minimum + std::hypot(minimum, epsilon));
      epsilon = 2.0 * std::sqrt(goal * std::max(0.0, goal - minimum));
    }
    return steps;
  }

  /// Applies a coarse correction: minimises the energy of the coarser mesh, tilted so that it has
  /// the restricted gradient of this one and stays in place at a minimum, and takes a step along
  /// the prolonged displacement.
  void Correct(QuadEnergy& energy, const Level& level, Eigen::VectorXd& unknowns,
    const Progress& progress) const
  {
    CoarseQuads coarse(level.mesh, level.lattices);
    if (!coarse.IsSmaller())
    {
      return;
    }
    QuadEnergy coarseEnergy = this->EnergyOf(coarse.mesh, coarse.weights);
    const Eigen::VectorXd start = coarseEnergy.Unknowns();
    Eigen::VectorXd gradient;
    Eigen::VectorXd coarseGradient;
    const double value = energy.Value(unknowns, 0.0, &gradient);
    if (!std::isfinite(coarseEnergy.Value(start, 0.0, &coarseGradient)))
    {
      return;
    }
    const TangentFrames& frames = energy.GetFrames();
    const TangentFrames& coarseFrames = coarseEnergy.GetFrames();
    this->SmoothOnce({ coarse.mesh, coarse.weights, coarse.lattices },
      coarseGradient -
        coarseEnergy.WithoutImages(coarse.Restrict(this->Curves, frames, coarseFrames, gradient)),
      progress);
    const Eigen::VectorXd displacement = energy.Masked(coarse.Prolong(this->Curves, frames,
      coarseFrames, coarseEnergy.WithImages(coarseEnergy.Unknowns() - start)));
    for (double length = 1.0; length > 0.1; length *= 0.5)
    {
      const Eigen::VectorXd next = unknowns + length * displacement;
      if (energy.Value(next, 0.0, nullptr) < value)
      {
        unknowns = next;
        return;
      }
    }
  }

  const BoundaryCurves& Curves;
  const SurfaceWalk* const Surface;
  const bool Release;
  const double SizePart;
};

/// Improves the worst quads where target lengths cannot be met: with the lengths that the mesh has
/// as targets, right angles count and sizes follow.
class ShapeSearch
{
public:
  ShapeSearch(const Smoother& smoother, const Level& level)
    : Shapes(smoother)
    , At(level)
    , Targets(level.mesh.targetLengths)
    , Best(RankOf(level.mesh))
    , Points(level.mesh.points)
  {
  }

  /// Smooths while the worst quad is poor. The mesh ends with the points of the best one found and
  /// its own target lengths. Returns the number of steps.
  int Run(const Progress& progress)
  {
    // Part of the attainable minimum scaled Jacobian below which sizes give way to shapes.
    constexpr double Poor = 0.8;
    // Later rounds gain less than a tenth of what these gain.
    constexpr int Rounds = 2;
    QuadMesh& mesh = this->At.mesh;
    // With many quads, only to untangle: powers need hundreds of steps of the whole mesh.
    const bool large = mesh.quads.size() > MaximumAlone;
    const double enough = large ? 0.0 : Poor * AttainableJacobian(mesh);
    int steps = 0;
    for (int round = 0; round < 2 * Rounds && this->Best.minimum <= enough; ++round)
    {
      SetMeasuredLengths(mesh);
      const Progress part = progress.Part(0.5 * round / Rounds, 0.5 * (round + 1.0) / Rounds);
      steps += round < Rounds ? this->Shapes.Smooth(this->At, part) : this->Shapes.Even(mesh, part);
      this->Keep();
    }
    mesh.points = this->Points;
    mesh.targetLengths = this->Targets;
    return steps;
  }

private:
  void Keep()
  {
    const QuadRank rank = RankOf(this->At.mesh);
    if (rank.IsBetterThan(this->Best))
    {
      this->Best = rank;
      this->Points = this->At.mesh.points;
    }
  }

  const Smoother& Shapes;
  const Level& At;
  const std::vector<std::array<double, 2>> Targets;
  QuadRank Best;
  std::vector<QuadPoint> Points;
};

/// Smooths for uniform sizes. Displacements are large, so a coarser mesh is smoothed first, with
/// singularities fixed and then free. Returns the number of steps on the mesh itself.
int SmoothUniform(const Level& level, const SmoothingDomain& domain, double sizePart, bool hold,
  const Progress& progress)
{
  const Smoother fixed(domain, false, sizePart);
  const Smoother released(domain, !hold, sizePart);
  if (level.mesh.quads.size() > MaximumAlone && !level.lattices.empty())
  {
    CoarseQuads coarse(level.mesh, level.lattices);
    if (coarse.IsSmaller())
    {
      const QuadEnergy energy = released.EnergyOf(coarse.mesh, coarse.weights);
      const Eigen::VectorXd before = energy.Unknowns();
      SmoothUniform({ coarse.mesh, coarse.weights, coarse.lattices }, domain, sizePart, hold,
        progress.Part(0.0, 0.4));
      const Eigen::VectorXd moves = energy.WithImages(energy.Unknowns() - before);
      const std::vector<QuadPoint> start = level.mesh.points;
      const TangentFrames frames(level.mesh, domain.surface);
      released.Displace(
        level, coarse.Interpolate(domain.curves, frames, energy.GetFrames(), moves));
      const int steps = released.Smooth(level, progress.Part(0.4, 1.0));
      released.SmoothNearCones(level.mesh);
      if (RankOf(level.mesh).inverted == 0)
      {
        return steps;
      }
      level.mesh.points = start;
    }
  }
  const int steps = fixed.Smooth(level, progress.Part(0.0, 0.5));
  return hold ? steps : steps + released.Smooth(level, progress.Part(0.5, 1.0));
}
}

SmoothingReport SmoothQuads(QuadMesh& mesh, const QuadBlocks& blocks, const SmoothingDomain& domain,
  std::optional<double> sizePart, bool hold, const Progress& progress)
{
  const BoundaryCurves& curves = domain.curves;
  SmoothingReport report;
  const bool large = mesh.quads.size() > MaximumAlone;
  const std::vector<QuadLattice> lattices =
    large && !blocks.blocks.empty() ? LatticesOf(mesh, blocks) : std::vector<QuadLattice>();
  const std::vector<double> weights(mesh.quads.size(), 1.0);
  const Level level = { mesh, weights, lattices };
  const std::vector<QuadPoint> start = mesh.points;
  if (domain.surface != nullptr)
  {
    SetNormals(*domain.surface, mesh);
  }
  const QuadRank rankAtStart = RankOf(mesh);
  if (rankAtStart.inverted > 0 || HasLongEdges(mesh, curves, LongestPartAtStart))
  {
    // Points that nearly coincide on the boundary would hardly move apart while quads untangle.
    constexpr double Shortest = 0.1;
    OrderOnBoundary(mesh, curves, Shortest);
    MatchPairs(curves, mesh);
  }
  const std::vector<QuadPoint> ordered = mesh.points;
  const Smoother fixed(domain, false, sizePart.value_or(ConformalSizePart));
  const Smoother released(domain, true, sizePart.value_or(ConformalSizePart));
  if (sizePart)
  {
    report.iterations = SmoothUniform(level, domain, *sizePart, hold, progress.Part(0.0, 0.6));
    report.released = !hold;
  }
  else
  {
    report.iterations = fixed.Smooth(level, progress.Part(0.0, 0.6));
    if (large)
    {
      fixed.SmoothNearCones(mesh);
    }
  }
  report.iterations +=
    ShapeSearch(report.released ? released : fixed, level).Run(progress.Part(0.6, 0.8));
  if (!report.released && !hold && rankAtStart.inverted > 0 && RankOf(mesh).inverted > 0)
  {
    report.released = true;
    mesh.points = ordered; // moves of the first attempt are in the way
    report.iterations += released.Smooth(level, progress.Part(0.8, 0.9));
    report.iterations += ShapeSearch(released, level).Run(progress.Part(0.9, 1.0));
  }
  const QuadRank rank = RankOf(mesh);
  if (rankAtStart.inverted < rank.inverted ||
    (rankAtStart.inverted == rank.inverted && rankAtStart.minimum > rank.minimum &&
      (!sizePart || rank.minimum <= 0.0)))
  {
    mesh.points = start;
    report.keptStart = true;
    report.released = false;
  }
  if (domain.surface != nullptr)
  {
    SetNormals(*domain.surface, mesh);
  }
  for (std::size_t p = 0; report.released && p < mesh.points.size(); ++p)
  {
    const double moved = (mesh.points[p].place - start[p].place).norm();
    report.moved = std::max(report.moved, mesh.points[p].cone >= 0 ? moved : 0.0);
  }
  return report;
}
}
