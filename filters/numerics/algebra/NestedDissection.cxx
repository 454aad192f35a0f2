#include "NestedDissection.h"

#include "Dissector.h"
#include "Parts.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace crossfield
{
namespace
{
/// Number of unknowns up to which a part of the tree is a leaf: with fewer, the dense blocks on the
/// separators would take most of the time.
constexpr std::ptrdiff_t SmallestLeaf = 4096;

/// Renumbers parts, of which the first is the root, so that each follows the parts below it.
std::vector<DissectionPart> InPostorder(std::vector<DissectionPart> parts)
{
  std::vector<std::vector<int>> below(parts.size());
  for (std::size_t i = 1; i < parts.size(); ++i)
  {
    below[parts[i].parent].push_back(static_cast<int>(i));
  }
  // Parts in reverse: each before those below it.
  std::vector<int> order;
  for (std::vector<int> open = { 0 }; !open.empty();)
  {
    const int part = open.back();
    open.pop_back();
    order.push_back(part);
    const std::vector<int>& children = below[part];
    open.insert(open.end(), children.begin(), children.end());
  }
  std::reverse(order.begin(), order.end());
  std::vector<int> numbers(parts.size());
  for (std::size_t i = 0; i < order.size(); ++i)
  {
    numbers[order[i]] = static_cast<int>(i);
  }
  std::vector<DissectionPart> sorted;
  for (const int part : order)
  {
    sorted.push_back(std::move(parts[part]));
    int& parent = sorted.back().parent;
    parent = parent < 0 ? -1 : numbers[parent];
  }
  return sorted;
}
}

std::vector<DissectionPart> Dissect(const Eigen::SparseMatrix<double>& matrix,
  const std::vector<SpacePoint>& places, const std::vector<int>& trailing,
  const std::vector<int>& leftOut, const std::vector<int>& partners)
{
  Dissector dissector(matrix, places, partners);
  for (int unknown : trailing)
  {
    dissector.Exclude(unknown);
  }
  for (int unknown : leftOut)
  {
    dissector.Exclude(unknown);
  }
  std::vector<int> order;
  order.reserve(places.size());
  for (int unknown = 0; unknown < static_cast<int>(places.size()); ++unknown)
  {
    if (!dissector.IsExcluded(unknown))
    {
      order.push_back(unknown);
    }
  }
  int* const begin = order.data();
  int* const end = begin + order.size();
  dissector.MeasureDensity(begin, end);

  // 1. Divide all parts of a level at once, from the root. Parts are numbered from the root here.
  const std::ptrdiff_t leafSize =
    std::max(SmallestLeaf, (end - begin) / static_cast<std::ptrdiff_t>(MaximumPartCount));
  std::vector<DissectionPart> parts(1);
  std::vector<OpenPart> leaves;
  std::vector<OpenPart> level = { { begin, end, 0, !partners.empty(), 0 } };
  if (end - begin <= leafSize)
  {
    leaves.swap(level); // below a root that has trailing unknowns only
  }
  for (bool isRoot = true; !level.empty(); isRoot = false)
  {
    std::vector<Dissector::Division> divisions(level.size());
    const int first = isRoot ? 0 : static_cast<int>(parts.size());
    ForParts(level.size(),
      [&](std::size_t i)
      { divisions[i] = dissector.Divide(level[i], first + static_cast<int>(i)); });
    std::vector<OpenPart> next;
    for (std::size_t i = 0; i < level.size(); ++i)
    {
      if (!isRoot)
      {
        parts.push_back({ {}, level[i].parent, false });
      }
      parts.back().unknowns.assign(divisions[i].separator, level[i].end);
      for (const OpenPart& below : divisions[i].below)
      {
        (below.end - below.begin <= leafSize ? leaves : next).push_back(below);
      }
    }
    level = std::move(next);
  }
  parts.front().unknowns.insert(parts.front().unknowns.end(), trailing.begin(), trailing.end());

  // 2. Order the leaves.
  ForParts(leaves.size(),
    [&](std::size_t i)
    {
      int number = leaves[i].number;
      dissector.Order(leaves[i].begin, leaves[i].end, number, leaves[i].twoSheets);
    });
  for (const OpenPart& leaf : leaves)
  {
    if (leaf.begin != leaf.end)
    {
      parts.push_back({ { leaf.begin, leaf.end }, leaf.parent, true });
    }
  }
  return InPostorder(std::move(parts));
}

std::vector<int> NestedDissection(const Eigen::SparseMatrix<double>& matrix,
  const std::vector<SpacePoint>& places, const std::vector<int>& trailing)
{
  std::vector<int> order;
  for (const DissectionPart& part : Dissect(matrix, places, trailing))
  {
    order.insert(order.end(), part.unknowns.begin(), part.unknowns.end());
  }
  return order;
}

double DissectionFill(double vertices)
{
  return vertices > 1.0 ? 31.0 / 4.0 * vertices * std::log2(vertices) : vertices;
}
}
