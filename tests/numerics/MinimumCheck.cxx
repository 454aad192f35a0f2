#include "MinimumCheck.h"

#include "RenormalizedEnergy.h"
#include "Support.h"

#include <Eigen/Eigenvalues>
#include <Eigen/SVD>

#include <algorithm>

namespace crossfield::test
{
Derivatives Differentiate(const std::function<double(const Eigen::VectorXd&)>& function,
  const Eigen::VectorXd& at, double step)
{
  const Eigen::Index size = at.size();
  Derivatives result{ Eigen::VectorXd(size), Eigen::MatrixXd(size, size) };
  const double here = function(at);
  const auto value = [&](Eigen::Index i, double si, Eigen::Index j, double sj)
  {
    Eigen::VectorXd moved = at;
    moved[i] += si * step;
    moved[j] += sj * step;
    return function(moved);
  };
  for (Eigen::Index i = 0; i < size; ++i)
  {
    const double above = value(i, 1.0, i, 0.0);
    const double below = value(i, -1.0, i, 0.0);
    result.gradient[i] = (above - below) / (2.0 * step);
    result.hessian(i, i) = (above - 2.0 * here + below) / (step * step);
    for (Eigen::Index j = 0; j < i; ++j)
    {
      result.hessian(i, j) = result.hessian(j, i) =
        (value(i, 1.0, j, 1.0) - value(i, 1.0, j, -1.0) - value(i, -1.0, j, 1.0) +
          value(i, -1.0, j, -1.0)) /
        (4.0 * step * step);
    }
  }
  return result;
}

Eigen::VectorXd Minimise(
  const std::function<double(const Eigen::VectorXd&)>& function, Eigen::VectorXd start)
{
  double value = function(start);
  for (int iteration = 0; iteration < 300; ++iteration)
  {
    const Derivatives here = Differentiate(function, start, 1e-5);
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen(here.hessian);
    // Absolute values of the eigenvalues, so that the iteration leaves a saddle.
    const Eigen::VectorXd slopes = eigen.eigenvectors().transpose() * here.gradient;
    const double floor = 1e-3 * eigen.eigenvalues().cwiseAbs().maxCoeff();
    const Eigen::VectorXd newton =
      -eigen.eigenvectors() * slopes.cwiseQuotient(eigen.eigenvalues().cwiseAbs().cwiseMax(floor));
    double part = std::min(1.0, 0.1 / newton.cwiseAbs().maxCoeff());
    while (part > 1e-12 && !(function(start + part * newton) < value))
    {
      part *= 0.5;
    }
    if (part <= 1e-12)
    {
      break;
    }
    start += part * newton;
    value = function(start);
  }
  return start;
}

MinimumCheck CheckMinimum(
  const PlanarDomain& domain, const Configuration& configuration, double meshSize)
{
  DrillOptions options;
  options.meshSize = meshSize;
  const PointPotential potential =
    PointPotentialOn(DrillHoles(domain, {}, options), {}, TotalQuarters(configuration));
  const auto evaluate = [&](const Eigen::VectorXd& places)
  {
    Configuration moved = configuration;
    for (std::size_t i = 0; i < moved.size(); ++i)
    {
      moved[i].position = places.segment<2>(2 * static_cast<Eigen::Index>(i));
    }
    return EvaluateRenormalizedEnergy(potential, potential.Solve(moved));
  };
  Eigen::VectorXd start(2 * static_cast<Eigen::Index>(configuration.size()));
  for (std::size_t i = 0; i < configuration.size(); ++i)
  {
    start.segment<2>(2 * static_cast<Eigen::Index>(i)) = configuration[i].position;
  }
  const RenormalizedEnergyValue here = evaluate(start);
  const auto defects = [&](const Eigen::VectorXd& places)
  {
    const std::vector<double> found = evaluate(places).holonomyDefect;
    Eigen::VectorXd off(static_cast<Eigen::Index>(found.size()));
    for (std::size_t k = 0; k < found.size(); ++k)
    {
      off[static_cast<Eigen::Index>(k)] =
        std::remainder(found[k] - here.holonomyDefect[k], 2.0 * Pi);
    }
    return off;
  };
  const auto loops = static_cast<Eigen::Index>(here.holonomyDefect.size());
  // Directions that preserve the defects, and the correction that restores them.
  const double step = 1e-3;
  Eigen::MatrixXd slopes = Eigen::MatrixXd::Zero(std::max<Eigen::Index>(loops, 1), start.size());
  for (Eigen::Index i = 0; loops > 0 && i < start.size(); ++i)
  {
    const Eigen::VectorXd along = step * Eigen::VectorXd::Unit(start.size(), i);
    slopes.col(i) = (defects(start + along) - defects(start - along)) / (2.0 * step);
  }
  Eigen::JacobiSVD<Eigen::MatrixXd> decomposition(
    slopes, Eigen::ComputeFullV | Eigen::ComputeFullU);
  decomposition.setThreshold(1e-3);
  const Eigen::Index rank = loops > 0 ? decomposition.rank() : 0;
  const Eigen::MatrixXd free = decomposition.matrixV().rightCols(start.size() - rank);
  const auto energy = [&](const Eigen::VectorXd& along)
  {
    Eigen::VectorXd places = start + free * along;
    for (int i = 0; rank > 0 && i < 2; ++i)
    {
      places -= decomposition.solve(defects(places));
    }
    return evaluate(places).singleValuedEnergy;
  };
  const Derivatives found = Differentiate(energy, Eigen::VectorXd::Zero(free.cols()), step);
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen(found.hessian);
  const Eigen::VectorXd parts = eigen.eigenvectors().transpose() * found.gradient;
  return { eigen.eigenvalues()[0],
    0.5 * parts.cwiseAbs2().cwiseQuotient(eigen.eigenvalues()).sum() };
}
}
