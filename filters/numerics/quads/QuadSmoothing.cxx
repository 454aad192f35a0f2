#include "QuadSmoothing.h"

#include "QuadEnergy.h"
#include "QuadQuality.h"

#include <algorithm>
#include <cmath>
#include <deque>
#include <limits>

namespace crossfield
{
namespace
{
/// Steps of the limited memory method, and how many of them it remembers.
constexpr int MostSteps = 120;
constexpr std::size_t Memory = 8;

/// The part of the determinant against the shape: shape matters, but sizes must not drift. Where even sizes are
/// wanted both count.
constexpr double SizePart = 0.2;
constexpr double EvenSizePart = 0.5;

struct Correction
{
  Eigen::VectorXd step;
  Eigen::VectorXd change;
  double inverse;
};

/// The two-loop recursion, with the inverse of the curvature as first guess.
Eigen::VectorXd Direction(const std::deque<Correction>& memory, const Eigen::VectorXd& curvature,
  const Eigen::VectorXd& gradient)
{
  Eigen::VectorXd direction = -gradient;
  std::vector<double> factors(memory.size());
  for (std::size_t i = memory.size(); i-- > 0;)
  {
    factors[i] = memory[i].inverse * memory[i].step.dot(direction);
    direction -= factors[i] * memory[i].change;
  }
  double scale = 1.0;
  if (!memory.empty())
  {
    const Correction& last = memory.back();
    scale = 1.0 / (last.inverse * last.change.dot(last.change.cwiseQuotient(curvature)));
  }
  direction = scale * direction.cwiseQuotient(curvature);
  for (std::size_t i = 0; i < memory.size(); ++i)
  {
    direction +=
      (factors[i] - memory[i].inverse * memory[i].change.dot(direction)) * memory[i].step;
  }
  return direction;
}

int Descend(QuadEnergy& energy, double epsilon, int mostSteps, const Progress& progress)
{
  const Eigen::VectorXd& curvature = energy.Curvature();
  Eigen::VectorXd at = energy.Unknowns();
  Eigen::VectorXd gradient;
  double value = energy.Value(epsilon, &gradient);
  std::deque<Correction> memory;
  int step = 0;
  for (; step < mostSteps && at.size() > 0; ++step)
  {
    progress.Report(static_cast<double>(step) / mostSteps);
    Eigen::VectorXd direction = Direction(memory, curvature, gradient);
    double slope = direction.dot(gradient);
    if (!(slope < 0.0))
    {
      memory.clear();
      direction = -gradient.cwiseQuotient(curvature);
      slope = direction.dot(gradient);
    }
    // A decrease far below what can be seen in a picture: 1e-7 of the energy.
    if (!(-slope > 1e-7 * value))
    {
      break;
    }
    // Armijo's rule, halving. Infinite where a corner would turn over.
    double length = 1.0;
    double next = std::numeric_limits<double>::infinity();
    for (int halving = 0; halving < 30; ++halving, length *= 0.5)
    {
      energy.Move(at + length * direction);
      next = energy.Value(epsilon);
      if (next <= value + 1e-4 * length * slope)
      {
        break;
      }
    }
    if (!(next <= value + 1e-4 * length * slope))
    {
      energy.Move(at);
      if (memory.empty())
      {
        break;
      }
      memory.clear();
      continue;
    }
    Eigen::VectorXd newGradient;
    energy.Value(epsilon, &newGradient);
    Correction correction = { length * direction, newGradient - gradient, 0.0 };
    const double product = correction.step.dot(correction.change);
    if (product > 0.0)
    {
      correction.inverse = 1.0 / product;
      memory.push_back(std::move(correction));
      if (memory.size() > Memory)
      {
        memory.pop_front();
      }
    }
    at += length * direction;
    gradient = std::move(newGradient);
    value = next;
  }
  return step;
}

int Smooth(QuadMesh& mesh, const BoundaryCurves& curves, bool release, double sizePart,
  const Progress& progress)
{
  QuadEnergy energy(mesh, curves, release, sizePart);
  int steps = 0;
  // Untangles: ε follows the worst corner down, by half of it at a time (Garanzha et al. 2021).
  constexpr int Rounds = 8;
  for (int round = 0; round < Rounds; ++round)
  {
    const double least = energy.LeastDeterminant();
    if (least > 0.0)
    {
      break;
    }
    const double epsilon = std::sqrt(1e-4 + 0.25 * least * least);
    steps += Descend(energy, epsilon, MostSteps / 3, progress);
  }
  if (energy.LeastDeterminant() > 0.0)
  {
    steps += Descend(energy, 0.0, MostSteps, progress);
  }
  return steps;
}
}

SmoothingReport SmoothQuads(
  QuadMesh& mesh, const BoundaryCurves& curves, bool even, const Progress& progress)
{
  SmoothingReport report;
  const auto least = [](const QuadMesh& quads)
  {
    double worst = 1.0;
    for (std::size_t q = 0; q < quads.quads.size(); ++q)
    {
      worst = std::min(worst, ScaledJacobian(quads, q));
    }
    return worst;
  };
  const QuadMesh start = mesh;
  report.iterations =
    Smooth(mesh, curves, false, even ? EvenSizePart : SizePart, progress.Part(0.0, 0.6));
  if (even || (least(mesh) <= 0.0 && least(start) <= 0.0))
  {
    report.released = true;
    report.iterations +=
      Smooth(mesh, curves, true, even ? EvenSizePart : SizePart, progress.Part(0.6, 1.0));
    for (std::size_t p = 0; p < mesh.points.size(); ++p)
    {
      const double moved = (mesh.points[p].place - start.points[p].place).norm();
      report.moved = std::max(report.moved, mesh.points[p].cone >= 0 ? moved : 0.0);
    }
  }
  if (least(start) > least(mesh) && (!even || least(mesh) <= 0.0))
  {
    mesh = start;
    report.keptStart = true;
    report.released = false;
    report.moved = 0.0;
  }
  return report;
}
}
