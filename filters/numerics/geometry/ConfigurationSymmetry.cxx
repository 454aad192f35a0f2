#include "ConfigurationSymmetry.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <optional>

namespace crossfield
{
namespace
{
/// Returns the subgroups with at most `maximumRotations` rotations, largest first, each without a
/// reflection or with one of the axes.
std::vector<SymmetryGroup> Subgroups(const SymmetryGroup& group, int maximumRotations)
{
  std::vector<SymmetryGroup> subgroups;
  for (int order = 1; order <= std::min(group.order, maximumRotations); ++order)
  {
    if (group.order % order != 0)
    {
      continue;
    }
    subgroups.push_back({ group.centre, order, false, 0.0 });
    for (int i = 0; group.reflects && i < group.order / order; ++i)
    {
      subgroups.push_back({ group.centre, order, true, group.axis + Pi * i / group.order });
    }
  }
  const auto size = [](const SymmetryGroup& subgroup)
  { return (subgroup.reflects ? 2 : 1) * subgroup.order; };
  std::stable_sort(subgroups.begin(), subgroups.end(),
    [&size](const auto& a, const auto& b) { return size(a) > size(b); });
  return subgroups;
}

/// Maps each singularity by an isometry and returns the row of the nearest one with the same
/// quarter index. Returns nothing if one of them is farther away than `distance`, or if two have
/// the same image.
std::optional<std::vector<std::size_t>> FindImages(
  const Configuration& configuration, const Isometry& map, double distance)
{
  std::vector<std::size_t> images;
  std::vector<bool> isUsed(configuration.size(), false);
  for (const Singularity& singularity : configuration)
  {
    const Point place = map(singularity.position);
    double nearest = std::numeric_limits<double>::infinity();
    std::size_t image = 0;
    for (std::size_t j = 0; j < configuration.size(); ++j)
    {
      const double apart = (configuration[j].position - place).norm();
      if (configuration[j].quarterIndex == singularity.quarterIndex && apart < nearest)
      {
        nearest = apart;
        image = j;
      }
    }
    if (!(nearest <= distance) || isUsed[image])
    {
      return std::nullopt;
    }
    isUsed[image] = true;
    images.push_back(image);
  }
  return images;
}

std::optional<ConfigurationSymmetry> Match(
  const Configuration& configuration, const SymmetryGroup& group, double distance)
{
  ConfigurationSymmetry symmetry;
  symmetry.group = group;
  for (const Isometry& map : group.Elements())
  {
    // A singularity may be displaced by `distance`, and its image by as much in the opposite
    // direction.
    const auto images = FindImages(configuration, map, 2.0 * distance);
    if (!images)
    {
      return std::nullopt;
    }
    symmetry.elements.push_back(map);
    symmetry.images.push_back(*images);
  }
  Configuration projected = configuration;
  symmetry.Project(projected);
  // The mean is symmetric only if the images define a group action.
  Configuration again = projected;
  symmetry.Project(again);
  double rounding = 1e-9 * distance;
  for (const Singularity& singularity : configuration)
  {
    rounding = std::max(rounding, 1e-14 * (singularity.position.norm() + group.centre.norm()));
  }
  for (std::size_t i = 0; i < configuration.size(); ++i)
  {
    const double moved = (projected[i].position - configuration[i].position).norm();
    if (moved > distance || (again[i].position - projected[i].position).norm() > rounding)
    {
      return std::nullopt;
    }
  }
  return symmetry;
}
}

void ConfigurationSymmetry::Project(Configuration& configuration) const
{
  if (this->IsTrivial())
  {
    return;
  }
  std::vector<Point> means(configuration.size(), Point::Zero());
  for (std::size_t g = 0; g < this->elements.size(); ++g)
  {
    const Isometry inverse = this->elements[g].Inverse();
    for (std::size_t i = 0; i < configuration.size(); ++i)
    {
      means[i] += inverse(configuration[this->images[g][i]].position) - inverse.centre;
    }
  }
  for (std::size_t i = 0; i < configuration.size(); ++i)
  {
    configuration[i].position =
      this->elements[0].centre + means[i] / static_cast<double>(this->elements.size());
  }
}

Eigen::VectorXd ConfigurationSymmetry::ProjectDirections(const Eigen::VectorXd& directions) const
{
  if (this->IsTrivial())
  {
    return directions;
  }
  Eigen::VectorXd means = Eigen::VectorXd::Zero(directions.size());
  for (std::size_t g = 0; g < this->elements.size(); ++g)
  {
    Isometry inverse = this->elements[g].Inverse();
    inverse.centre = Point::Zero(); // directions are mapped by the linear part only
    for (std::size_t i = 0; i < this->images[g].size(); ++i)
    {
      const Point direction =
        directions.segment<2>(2 * static_cast<Eigen::Index>(this->images[g][i]));
      means.segment<2>(2 * static_cast<Eigen::Index>(i)) += inverse(direction);
    }
  }
  return means / static_cast<double>(this->elements.size());
}

ConfigurationSymmetry MatchSymmetry(const Configuration& configuration, const SymmetryGroup& group,
  double distance, const IsometryTest& isInvariant)
{
  // A single singularity can be at the centre; any other has as many images as there are rotations.
  const int maximumRotations =
    configuration.size() < 2 ? group.order : static_cast<int>(configuration.size());
  for (const SymmetryGroup& subgroup : Subgroups(group, maximumRotations))
  {
    const auto symmetry = Match(configuration, subgroup, distance);
    if (symmetry &&
      (!isInvariant ||
        std::all_of(symmetry->elements.begin(), symmetry->elements.end(), isInvariant)))
    {
      return *symmetry;
    }
  }
  ConfigurationSymmetry none;
  none.elements.resize(1);
  none.images.emplace_back(configuration.size());
  std::iota(none.images[0].begin(), none.images[0].end(), std::size_t{ 0 });
  return none;
}
}
