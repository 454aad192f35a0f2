#include "PartRequests.h"

#include "SegmentSearch.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numeric>

namespace crossfield
{
namespace
{
/// Returns for a part how much of the quads it has, up to a factor.
double WeightOf(const PlanarDomain& part, const QuadRequest& request)
{
  const double size = request.sizing == Sizing::Field
    ? ComputeRelativeSizes(request.prescribedSizes, part, request.meshSize).mean
    : 1.0;
  return part.Area() / (size * size);
}

/// Returns whether sizes are requested besides one for all quads.
bool RequestsSizes(const QuadRequest& request)
{
  return !request.sizesNear.empty() || request.minimumSize > 0.0 || request.maximumSize > 0.0 ||
    std::any_of(request.sideRequests.begin(), request.sideRequests.end(),
      [](const SideRequest& one) { return one.size != 0.0 || one.inside != 0.0; });
}

/// Throws Error if something is prescribed for a side that no part has.
void RequireSides(const std::vector<DomainPart>& parts, const QuadRequest& request)
{
  std::vector<std::string> names;
  for (const DomainPart& part : parts)
  {
    std::copy_if(part.sides.names.begin(), part.sides.names.end(), std::back_inserter(names),
      [&names](const std::string& name)
      { return std::find(names.begin(), names.end(), name) == names.end(); });
  }
  for (const SideRequest& one : request.sideRequests)
  {
    RequireSide(names, one.side, one.curve ? " for a curve" : one.layer ? " for a layer" : "");
  }
  for (const CornerRule& rule : request.cornerRows)
  {
    if (!rule.side.empty())
    {
      RequireSide(names, rule.side);
    }
  }
}

/// Returns the names of the sides on inner loops.
std::vector<std::string> NamesOfHoles(const std::vector<DomainPart>& parts)
{
  std::vector<std::string> names;
  for (const DomainPart& part : parts)
  {
    const std::vector<LoopArc> loops(part.domain.loops.begin(), part.domain.loops.end());
    const SidesAlong along(part.sides, loops);
    for (std::size_t l = 1; l < loops.size(); ++l)
    {
      for (const LoopSide& start : along.On(l))
      {
        const std::string& name = part.sides.names[start.side];
        if (std::find(names.begin(), names.end(), name) == names.end())
        {
          names.push_back(name);
        }
      }
    }
  }
  return names;
}

/// Replaces the items of the side `holes`, unless there is a side of this name, by items of all
/// sides of inner loops.
template <class Item>
void ExpandHoles(const std::vector<DomainPart>& parts, std::vector<Item>& items)
{
  const std::string all = "holes";
  const bool isSide = std::any_of(
    parts.begin(), parts.end(), [&](const DomainPart& part) { return part.sides.Find(all) >= 0; });
  const std::vector<std::string> names = isSide ? std::vector<std::string>() : NamesOfHoles(parts);
  std::vector<Item> expanded;
  for (const Item& item : items)
  {
    if (item.side != all || names.empty())
    {
      expanded.push_back(item);
      continue;
    }
    for (const std::string& name : names)
    {
      expanded.push_back(item);
      expanded.back().side = name;
    }
  }
  items = std::move(expanded);
}

/// Copies the items of a request that belong to a part.
template <class Item, class Belongs>
void Keep(std::vector<Item>& items, const Belongs& belongs)
{
  items.erase(
    std::remove_if(items.begin(), items.end(), [&](const Item& item) { return !belongs(item); }),
    items.end());
}
}

std::vector<PartRequest> SplitRequest(
  const std::vector<DomainPart>& parts, const QuadRequest& given)
{
  QuadRequest request = given;
  ExpandHoles(parts, request.sideRequests);
  ExpandHoles(parts, request.cornerRows);
  if (parts.size() == 1)
  {
    PartRequest all{ request, {}, 1.0 };
    all.request.sides = parts[0].sides;
    all.request.givenCurves = parts[0].curves;
    all.rows.resize(request.singularities ? request.singularities->size() : 0);
    std::iota(all.rows.begin(), all.rows.end(), std::size_t(0));
    return { all };
  }
  RequireSides(parts, request);
  std::vector<SegmentSearch> searches;
  std::vector<double> weights;
  double sum = 0.0;
  for (const DomainPart& part : parts)
  {
    searches.emplace_back(part.domain);
    weights.push_back(WeightOf(part.domain, request));
    sum += weights.back();
  }
  if (request.quadSize == 0.0 && request.quadCount == 0 && request.sizing != Sizing::Field)
  {
    // The size elsewhere is that of all parts together.
    double area = 0.0;
    for (const DomainPart& part : parts)
    {
      area += part.domain.Area();
    }
    request.quadSize = RequestsSizes(request) ? std::sqrt(area / DefaultQuads) : 0.0;
    request.quadCount = DefaultQuads;
  }
  const auto partAt = [&](const Point& place)
  {
    std::vector<double> distances;
    std::transform(searches.begin(), searches.end(), std::back_inserter(distances),
      [&place](const SegmentSearch& search) { return search.SignedDistance(place); });
    return static_cast<std::size_t>(
      std::max_element(distances.begin(), distances.end()) - distances.begin());
  };
  std::vector<PartRequest> result(parts.size(), { request, {}, 0.0 });
  for (std::size_t p = 0; p < parts.size(); ++p)
  {
    const auto isHere = [&](const Point& place) { return partAt(place) == p; };
    const auto hasSide = [&](const std::string& name) { return parts[p].sides.Find(name) >= 0; };
    QuadRequest& own = result[p].request;
    own.isPart = true;
    own.sides = parts[p].sides;
    own.givenCurves = parts[p].curves;
    result[p].share = weights[p] / sum;
    own.quadCount = request.quadCount < 1
      ? request.quadCount // as many as sizes need; a negative one is refused
      : std::max(1, static_cast<int>(std::lround(result[p].share * request.quadCount)));
    Keep(own.sideRequests, [&](const SideRequest& one) { return hasSide(one.side); });
    Keep(own.sizesNear, [&](const SizeNear& near) { return isHere(near.place); });
    Keep(own.nodes, isHere);
    Keep(own.corners, [&](const CornerChoice& corner) { return isHere(corner.position); });
    Keep(own.cornerRows,
      [&](const CornerRule& rule)
      { return rule.position ? isHere(*rule.position) : rule.side.empty() || hasSide(rule.side); });
    if (!request.singularities)
    {
      continue;
    }
    own.singularities->clear();
    for (std::size_t row = 0; row < request.singularities->size(); ++row)
    {
      const Singularity& singularity = (*request.singularities)[row];
      if (isHere(singularity.position))
      {
        own.singularities->push_back(singularity);
        result[p].rows.push_back(row);
      }
    }
    if (result[p].rows.empty() && !request.singularities->empty())
    {
      own.singularities.reset();
    }
  }
  return result;
}
}
