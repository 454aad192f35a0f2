#pragma once

#include "CandidateSites.h"
#include "IndexForm.h"

#include <cstdint>

namespace crossfield
{
/// Elements of the group that are regarded, by their numbers.
using Subgroup = std::vector<std::size_t>;

/// Returns one subgroup of each class of conjugate subgroups, the trivial one last.
std::vector<Subgroup> ClassesOfSubgroups(const SymmetryGroup& group);

/// Whether two sites, or orbits, may not be used together, 0 or 1.
using SitePairs = Eigen::Matrix<std::uint8_t, Eigen::Dynamic, Eigen::Dynamic>;

/// The quadratic form in indices that are equal on each orbit of a subgroup.
struct OrbitForm
{
  std::vector<std::vector<std::size_t>> members; ///< Sites of each orbit.
  Eigen::VectorXd linear;
  Eigen::MatrixXd matrix;
  Eigen::VectorXd defects;
  Eigen::MatrixXd defectChanges;
  Eigen::MatrixXd defectEnergy;
  SitePairs isNear; ///< Not used together.
  std::vector<int> sizes;
  std::vector<int> limits; ///< Of the absolute value of an index.
  int total = 0;
  double nodeCost = 0.0; ///< Added to the form for each unit of an absolute value at each site.
};

/// Makes the form for the orbits of a subgroup, without those with members that are near each other.
OrbitForm MakeOrbitForm(const CandidateSites& sites, const IndexForm& given,
  const SitePairs& isNear, const Subgroup& subgroup);
}
