#include "QuadSmoothing.h"

#include "QuadDescent.h"
#include "QuadPart.h"
#include "QuadQuality.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace crossfield
{
namespace
{
/// Meshes with more quads are smoothed beside coarser ones.
constexpr std::size_t MostAlone = 5000;

/// The part of the determinant against the shape: shape matters, but sizes must not drift. Where even sizes are
/// wanted both count.
constexpr double SizePart = 0.2;
constexpr double UniformSizePart = 0.5;

/// Until a step brings far less than can be seen in a picture, 1e-7 of the energy.
constexpr DescentLimits Alone = { 120, 0.0, 1e-7 };
/// Beside a coarser mesh, which does what is far apart: until a step brings a hundredth of what is above perfect quads.
constexpr DescentLimits BesideCoarser = { 5, 1e-2, 1e-7 };

/// A mesh with what its quads count and its lattices, of itself or of a coarser one.
struct Level
{
  QuadMesh& mesh;
  const std::vector<double>& weights;
  const std::vector<QuadLattice>& lattices;
};

class Smoother
{
public:
  Smoother(const BoundaryCurves& curves, bool release, double sizePart)
    : Curves(curves)
    , Release(release)
    , SizePart(sizePart)
  {
  }

  QuadEnergy EnergyOf(const QuadMesh& mesh, const std::vector<double>& weights) const
  {
    return { mesh, this->Curves, this->Moves(mesh), this->SizePart, weights };
  }

  /// Moves a mesh to the least of its energy, less a tilt if there is one. Returns the number of steps on the mesh itself.
  int Smooth(const Level& level, const Eigen::VectorXd& tilt, const Progress& progress) const
  {
    QuadEnergy energy = this->EnergyOf(level.mesh, level.weights);
    QuadDescent descent(energy);
    Eigen::VectorXd unknowns = energy.Unknowns();
    const bool large = level.mesh.quads.size() > MostAlone;
    int steps = this->Untangle(energy, descent, unknowns, progress);
    if (energy.LeastDeterminant(unknowns) > 0.0)
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
    energy.Store(unknowns, level.mesh);
    return steps;
  }

  /// Smooths some rings around every singularity, and every inverted quad, to the end: there the places of quads change most from one to the
  /// next, and a coarser mesh says least.
  void SmoothNearCones(QuadMesh& mesh) const
  {
    constexpr int Rings = 12; // six of a coarser mesh
    QuadPart part(mesh, this->Moves(mesh), Rings);
    QuadEnergy energy(part.mesh, this->Curves, part.moves, this->SizePart,
      std::vector<double>(part.mesh.quads.size(), 1.0));
    QuadDescent descent(energy);
    Eigen::VectorXd unknowns = energy.Unknowns();
    this->Untangle(energy, descent, unknowns, {});
    if (energy.LeastDeterminant(unknowns) > 0.0)
    {
      descent.Descend(0.0, Alone, unknowns);
      energy.Store(unknowns, part.mesh);
      part.PutBack(mesh);
    }
  }

  /// Moves the points of a mesh that do move. What turns over is untangled with what is around it.
  void Move(const Level& level, const Eigen::VectorXd& way) const
  {
    QuadEnergy energy = this->EnergyOf(level.mesh, level.weights);
    const Eigen::VectorXd moved = energy.Unknowns() + energy.Masked(way);
    energy.Store(moved, level.mesh);
    if (energy.LeastDeterminant(moved) <= 0.0)
    {
      this->SmoothNearCones(level.mesh);
    }
  }

private:
  std::vector<bool> Moves(const QuadMesh& mesh) const
  {
    std::vector<bool> moves;
    moves.reserve(mesh.points.size());
    for (const QuadPoint& point : mesh.points)
    {
      moves.push_back(!point.fixed || (this->Release && point.curve.loop < 0));
    }
    return moves;
  }

  /// ε follows the worst corner down, by half of it at a time (Garanzha et al. 2021).
  int Untangle(QuadEnergy& energy, QuadDescent& descent, Eigen::VectorXd& unknowns,
    const Progress& progress) const
  {
    constexpr int Rounds = 8;
    int steps = 0;
    double least = energy.LeastDeterminant(unknowns);
    for (int round = 0; round < Rounds && least <= 0.0; ++round)
    {
      const double epsilon = std::sqrt(1e-4 + 0.25 * least * least);
      DescentLimits limits = Alone;
      limits.steps /= 3;
      steps += descent.Descend(epsilon, limits, unknowns, progress);
      least = energy.LeastDeterminant(unknowns);
    }
    return steps;
  }

  /// A step along the way of a coarser mesh whose energy is tilted so that it has the gradient of this one: at the
  /// least of this mesh's energy it would stay where it is.
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
    this->Smooth({ coarse.mesh, coarse.weights, coarse.lattices },
      coarseGradient - coarse.Restrict(this->Curves, gradient), progress);
    const Eigen::VectorXd way =
      energy.Masked(coarse.Prolong(this->Curves, coarseEnergy.Unknowns() - start));
    for (double length = 1.0; length > 0.1; length *= 0.5)
    {
      const Eigen::VectorXd next = unknowns + length * way;
      if (energy.Value(next, 0.0, nullptr) < value)
      {
        unknowns = next;
        return;
      }
    }
  }

  const BoundaryCurves& Curves;
  const bool Release;
  const double SizePart;
};

double LeastJacobian(const QuadMesh& mesh)
{
  double worst = 1.0;
  for (std::size_t q = 0; q < mesh.quads.size(); ++q)
  {
    worst = std::min(worst, ScaledJacobian(mesh, q));
  }
  return worst;
}

/// With even sizes the way is long: a coarser mesh goes it first, with singularities fixed and then free.
int SmoothUniform(const Level& level, const BoundaryCurves& curves, const Progress& progress)
{
  const Smoother fixed(curves, false, UniformSizePart);
  const Smoother released(curves, true, UniformSizePart);
  if (level.mesh.quads.size() > MostAlone)
  {
    CoarseQuads coarse(level.mesh, level.lattices);
    if (coarse.IsSmaller())
    {
      const Eigen::VectorXd before = released.EnergyOf(coarse.mesh, coarse.weights).Unknowns();
      SmoothUniform({ coarse.mesh, coarse.weights, coarse.lattices }, curves, progress.Part(0.0, 0.4));
      const Eigen::VectorXd after = released.EnergyOf(coarse.mesh, coarse.weights).Unknowns();
      const std::vector<QuadPoint> start = level.mesh.points;
      released.Move(level, coarse.Interpolate(curves, after - before));
      const int steps = released.Smooth(level, {}, progress.Part(0.4, 1.0));
      released.SmoothNearCones(level.mesh);
      if (LeastJacobian(level.mesh) > 0.0)
      {
        return steps;
      }
      level.mesh.points = start;
    }
  }
  const int steps = fixed.Smooth(level, {}, progress.Part(0.0, 0.5));
  return steps + released.Smooth(level, {}, progress.Part(0.5, 1.0));
}
}

SmoothingReport SmoothQuads(QuadMesh& mesh, const QuadBlocks& blocks, const BoundaryCurves& curves,
  bool even, const Progress& progress)
{
  SmoothingReport report;
  const bool large = mesh.quads.size() > MostAlone;
  const std::vector<QuadLattice> lattices =
    large ? LatticesOf(mesh, blocks) : std::vector<QuadLattice>();
  const std::vector<double> weights(mesh.quads.size(), 1.0);
  const Level level = { mesh, weights, lattices };
  const std::vector<QuadPoint> start = mesh.points;
  const double leastAtStart = LeastJacobian(mesh);
  if (even)
  {
    report.iterations = SmoothUniform(level, curves, progress);
    report.released = true;
  }
  else
  {
    const Smoother fixed(curves, false, SizePart);
    report.iterations = fixed.Smooth(level, {}, progress.Part(0.0, 0.6));
    if (large)
    {
      fixed.SmoothNearCones(mesh);
    }
    if (leastAtStart <= 0.0 && LeastJacobian(mesh) <= 0.0)
    {
      const Smoother released(curves, true, SizePart);
      report.iterations += released.Smooth(level, {}, progress.Part(0.6, 1.0));
      report.released = true;
    }
  }
  const double least = LeastJacobian(mesh);
  if (leastAtStart > least && (!even || least <= 0.0))
  {
    mesh.points = start;
    report.keptStart = true;
    report.released = false;
  }
  for (std::size_t p = 0; report.released && p < mesh.points.size(); ++p)
  {
    const double moved = (mesh.points[p].place - start[p].place).norm();
    report.moved = std::max(report.moved, mesh.points[p].cone >= 0 ? moved : 0.0);
  }
  return report;
}
}
