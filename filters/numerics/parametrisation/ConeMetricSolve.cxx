#include "ConeMetricSolve.h"

#include "DissectedCholesky.h"
#include "HolomorphicStrains.h"
#include "MetricRemeshing.h"
#include "QuarterTurns.h"

#include <Eigen/LU>

#include <algorithm>

#include <cmath>

namespace crossfield
{
namespace
{
/// Errors below this are rounding: lengths are products of tens of steps, radians.
constexpr double Negligible = 1e-10;

/// Far from the right angles a prediction of the alignment is wrong: then steps are conformal, which
/// minimise a convex energy. Radians.
constexpr double LargestAngleDefect = 0.2;

/// Solves with the Laplacian of a metric, one vertex held.
class LaplacianSolve
{
public:
  explicit LaplacianSolve(const MetricDerivatives& derivatives)
    : Factor(derivatives.Laplacian(), derivatives.GetMetric().Points(), {}, { 0 })
  {
  }

  /// Returns (G B)⁻¹ b: G B is minus the Laplacian.
  Eigen::MatrixXd operator()(const Eigen::MatrixXd& rightHandSides) const
  {
    return -this->Factor.Substitute(this->Factor.Eliminate(rightHandSides));
  }

private:
  const DissectedCholesky Factor;
};

class Flattening
{
public:
  Flattening(ConeMetric& metric, double quantile)
    : Metric(metric)
    , Quantile(quantile)
  {
  }

  FlatteningReport Run(const Progress& progress)
  {
    // Cases that converge take 4 to 40 iterations.
    constexpr int MaximumIterations = 60;
    for (; this->Report.iterations < MaximumIterations; ++this->Report.iterations)
    {
      const auto done = static_cast<double>(this->Report.iterations);
      const Progress part =
        progress.Part(done / MaximumIterations, (done + 1.0) / MaximumIterations);
      part.Report(0.0);
      if (!this->Metric.IsValid())
      {
        return this->Report; // triangles were divided until they degenerated
      }
      const MetricDerivatives derivatives(this->Metric);
      const Eigen::VectorXd angles = derivatives.AngleDefects();
      const LoopAlignment alignment = MeasureAlignment(derivatives);
      this->Report.angleDefect = angles.lpNorm<Eigen::Infinity>();
      this->Report.alignmentDefect =
        alignment.defects.size() == 0 ? 0.0 : alignment.defects.lpNorm<Eigen::Infinity>();
      if (this->Report.angleDefect <= Negligible && this->Report.alignmentDefect <= Negligible)
      {
        this->Report.converged = true;
        return this->Report;
      }
      const bool hasMoved = this->Step(derivatives, angles, alignment, part);
      const bool hasChanged = this->Remesh();
      if (!hasMoved && !hasChanged)
      {
        return this->Report;
      }
    }
    return this->Report;
  }

private:
  /// Takes one step. Returns whether it reduced the errors.
  bool Step(const MetricDerivatives& derivatives, const Eigen::VectorXd& angles,
    const LoopAlignment& alignment, const Progress& progress)
  {
    const auto loops = alignment.defects.size();
    Eigen::MatrixXd rightHandSides(angles.size(), 1 + loops);
    rightHandSides.col(0) = angles;
    for (Eigen::Index j = 0; j < loops; ++j)
    {
      Eigen::VectorXd row =
        Eigen::VectorXd::Zero(static_cast<Eigen::Index>(this->Metric.LogLengths().size()));
      for (const auto& [edge, value] : alignment.rows[j])
      {
        row[edge] += value;
      }
      rightHandSides.col(1 + j) = ConformalPullback(this->Metric, row);
    }
    const LaplacianSolve solve(derivatives);
    const Eigen::MatrixXd solutions = solve(rightHandSides);
    Eigen::VectorXd change = ConformalChanges(this->Metric, solutions.col(0));
    const bool strains = loops > 0 && angles.lpNorm<Eigen::Infinity>() <= LargestAngleDefect;
    if (strains)
    {
      const Eigen::MatrixXd potentials = solutions.rightCols(loops);
      const Eigen::VectorXd strain =
        this->Strain(HolomorphicStrains(derivatives, alignment, potentials),
          alignment.defects + potentials.transpose() * angles, alignment.HasHandles(), progress);
      change +=
        strain - ConformalChanges(this->Metric, solve(derivatives.AngleSumChanges(strain)).col(0));
    }
    return this->Move(derivatives, change, strains);
  }

  /// Returns the strain that corrects the directions of loops, limited to what a linear model is
  /// good for. `defects` are those that conformal changes leave.
  Eigen::VectorXd Strain(const HolomorphicStrains& basis, Eigen::VectorXd defects, bool hasHandles,
    const Progress& progress)
  {
    if (defects.lpNorm<Eigen::Infinity>() <= Negligible)
    {
      return Eigen::VectorXd::Zero(static_cast<Eigen::Index>(this->Metric.LogLengths().size()));
    }
    constexpr int Passes = 3;
    HolomorphicStrains::Strains strains;
    Eigen::VectorXd coefficients;
    // For integrals to a few per cent (docs/method.md §12.5).
    constexpr int Sampled = 600;
    const DifferentialSample sample = basis.Sample(Sampled);
    double least = 0.0;
    const auto choose = [&]
    {
      coefficients.resize(0);
      least = LeastStrain(sample, defects, coefficients);
      for (int pass = 0; pass < Passes; ++pass)
      {
        strains = basis.For(coefficients, this->Quantile);
        coefficients = -strains.response.fullPivLu().solve(defects);
      }
    };
    choose();
    if (!this->HasTurned)
    {
      this->HasTurned = true;
      // Crosses around a handle keep the quarter turns of the frames.
      const Eigen::VectorXi turns = hasHandles ? Eigen::VectorXi::Zero(defects.size())
                                               : ChooseQuarterTurns(sample, defects, progress);
      if (!turns.isZero())
      {
        for (Eigen::Index j = 0; j < turns.size(); ++j)
        {
          this->Metric.TurnLoop(static_cast<std::size_t>(j) + 1, turns[j]);
        }
        defects -= 0.5 * Pi * turns.cast<double>();
        choose();
      }
      this->Report.loopDefects.assign(defects.begin(), defects.end());
      this->Report.predictedStrain = least;
    }
    // Radians and logarithms of lengths.
    constexpr double LargestChange = 0.25;
    const Eigen::VectorXd strain = strains.edges * coefficients;
    const double largest =
      std::max(strain.lpNorm<Eigen::Infinity>(), defects.lpNorm<Eigen::Infinity>());
    return strain * std::min(1.0, LargestChange / largest);
  }

  /// Errors of a metric, which a step must reduce.
  struct Errors
  {
    double largestAngle;
    double angles; ///< Sum of squares.
    double alignment;

    Errors(const MetricDerivatives& derivatives)
      : Errors(derivatives.AngleDefects(), MeasureAlignment(derivatives).defects)
    {
    }
    Errors(const Eigen::VectorXd& atVertices, const Eigen::VectorXd& atLoops)
      : largestAngle(atVertices.lpNorm<Eigen::Infinity>())
      , angles(atVertices.squaredNorm())
      , alignment(atLoops.squaredNorm())
    {
    }
    /// Conformal steps leave the alignment alone. Steps with strains may leave angle errors that the
    /// next step corrects.
    bool IsBetterThan(const Errors& before, bool strains) const
    {
      return strains ? this->angles + this->alignment < before.angles + before.alignment ||
          (this->largestAngle <= LargestAngleDefect && this->alignment < 0.9 * before.alignment)
                     : this->angles < before.angles;
    }
  };

  /// Moves along a change, halved until no triangle is degenerate and the errors fall.
  bool Move(const MetricDerivatives& derivatives, const Eigen::VectorXd& change, bool strains)
  {
    constexpr int MaximumHalvings = 12;
    const std::vector<double> start = this->Metric.LogLengths();
    const Errors before(derivatives);
    double length = 1.0;
    for (int halving = 0; halving < MaximumHalvings; ++halving, length *= 0.5)
    {
      std::vector<double> logs = start;
      for (std::size_t e = 0; e < logs.size(); ++e)
      {
        logs[e] += length * change[static_cast<Eigen::Index>(e)];
      }
      this->Metric.SetLogLengths(std::move(logs));
      if (!this->Metric.IsValid())
      {
        continue;
      }
      if (Errors(MetricDerivatives(this->Metric)).IsBetterThan(before, strains))
      {
        return true;
      }
    }
    this->Metric.SetLogLengths(start);
    return false;
  }

  /// Improves the triangulation. Returns whether it changed.
  bool Remesh()
  {
    // A split per ten triangles in all: more beget more, which means that the metric degenerates.
    constexpr std::size_t TrianglesPerSplit = 10;
    const auto limit = static_cast<int>(this->Metric.Triangles().size() / TrianglesPerSplit);
    const RemeshingCount count =
      ImproveTriangles(this->Metric, std::max(0, limit - this->Report.splits));
    this->Report.flips += count.flips;
    this->Report.splits += count.splits;
    return count.flips + count.splits > 0;
  }

  ConeMetric& Metric;
  const double Quantile;
  bool HasTurned = false;
  FlatteningReport Report;
};
}

FlatteningReport FlattenMetric(ConeMetric& metric, double quantile, const Progress& progress)
{
  return Flattening(metric, quantile).Run(progress);
}
}
