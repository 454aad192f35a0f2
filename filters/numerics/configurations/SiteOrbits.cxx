#include "SiteOrbits.h"

#include <algorithm>

namespace crossfield
{
std::vector<Subgroup> ClassesOfSubgroups(const SymmetryGroup& group)
{
  std::vector<Subgroup> classes;
  const auto order = static_cast<std::size_t>(group.order);
  for (std::size_t rotations = order; rotations >= 1; --rotations)
  {
    if (order % rotations != 0)
    {
      continue;
    }
    const std::size_t step = order / rotations;
    Subgroup turns;
    for (std::size_t i = 0; i < order; i += step)
    {
      turns.push_back(i);
    }
    // A rotation by one step of the group moves an axis by two.
    const std::size_t axes = !group.reflects ? 0 : step % 2 == 0 ? 2 : 1;
    for (std::size_t axis = 0; axis < axes; ++axis)
    {
      Subgroup reflected = turns;
      for (std::size_t i = axis; i < order; i += step)
      {
        reflected.push_back(order + i);
      }
      classes.push_back(reflected);
    }
    classes.push_back(turns);
  }
  return classes;
}

OrbitForm MakeOrbitForm(const CandidateSites& sites, const IndexForm& given,
  const SitePairs& isNear, const Subgroup& subgroup)
{
  OrbitForm form;
  const std::size_t count = sites.positions.size();
  std::vector<bool> isDone(count, false);
  for (std::size_t i = 0; i < count; ++i)
  {
    if (isDone[i])
    {
      continue;
    }
    std::vector<std::size_t> orbit;
    for (const std::size_t g : subgroup)
    {
      const std::size_t image = sites.images[g][i];
      if (!isDone[image])
      {
        isDone[image] = true;
        orbit.push_back(image);
      }
    }
    bool isCrowded = false;
    for (const std::size_t a : orbit)
    {
      for (const std::size_t b : orbit)
      {
        isCrowded = isCrowded || (a != b && isNear(a, b) != 0);
      }
    }
    if (!isCrowded)
    {
      form.members.push_back(std::move(orbit));
    }
  }
  const auto orbits = static_cast<Eigen::Index>(form.members.size());
  const StrengthChanges::Form& sum = given.form;
  const Eigen::Index islands = sum.defects.size();
  form.linear = Eigen::VectorXd::Zero(orbits);
  form.defectChanges = Eigen::MatrixXd::Zero(islands, orbits);
  Eigen::MatrixXd columns = Eigen::MatrixXd::Zero(sum.matrix.rows(), orbits);
  for (Eigen::Index o = 0; o < orbits; ++o)
  {
    for (const std::size_t i : form.members[o])
    {
      form.linear[o] += sum.linear[i];
      form.defectChanges.col(o) += sum.defectChanges.col(i);
      columns.col(o) += sum.matrix.col(i);
    }
  }
  form.matrix = Eigen::MatrixXd::Zero(orbits, orbits);
  form.isNear = SitePairs::Zero(orbits, orbits);
  for (Eigen::Index o = 0; o < orbits; ++o)
  {
    for (const std::size_t i : form.members[o])
    {
      form.matrix.row(o) += columns.row(i);
    }
    const std::size_t first = form.members[o].front();
    for (Eigen::Index p = 0; p < orbits; ++p)
    {
      // all members are images of the first
      form.isNear(o, p) = p != o &&
          std::any_of(form.members[p].begin(), form.members[p].end(),
            [&](std::size_t i) { return isNear(first, i) != 0; })
        ? 1
        : 0;
    }
    form.sizes.push_back(static_cast<int>(form.members[o].size()));
    form.limits.push_back(form.sizes.back() == 1 && subgroup.size() > 1 ? 4 : 1);
  }
  form.defects = sum.defects;
  form.defectEnergy = sum.defectEnergy;
  // Islands on an axis have defects 0 or π, which no symmetric change of positions removes.
  form.defectEnergy *= subgroup.size() > 2 ? 1.0 : 0.1;
  form.total = given.total;
  return form;
}
}
