#include "RegionRequests.h"

#include "Error.h"
#include "Index.h"
#include "PoincareHopf.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace crossfield
{
namespace
{
/// Returns whether a piece has a name: that of its side, its own, or its materials in either order.
bool IsCalled(const RegionSet& set, const InterfacePiece& piece, const std::string& name)
{
  const auto nameOf = [&](int region)
  { return set.materials[Index(set.regions[Index(region)].material)]; };
  return piece.side == name || piece.name == name ||
    nameOf(piece.regions[1]) + "+" + nameOf(piece.regions[0]) == name;
}

/// Returns a request with what it prescribes for an interface, by one of its names, prescribed for each of its
/// pieces. What is prescribed for the left side of a slit holds for both.
QuadRequest ForPieces(const RegionSet& set, QuadRequest request)
{
  std::vector<SideRequest> expanded;
  for (const SideRequest& one : request.sideRequests)
  {
    const std::size_t before = expanded.size();
    for (const InterfacePiece& piece : set.interfaces)
    {
      if (IsCalled(set, piece, one.side))
      {
        expanded.push_back(one);
        expanded.back().side = piece.NameIn(0);
      }
    }
    if (expanded.size() == before)
    {
      expanded.push_back(one);
    }
  }
  request.sideRequests = std::move(expanded);
  return request;
}

/// Removes sizes inside of materials from a request, and returns them per material; 0 without one.
std::vector<double> TakeSizesInside(const RegionSet& set, QuadRequest& request)
{
  std::vector<double> sizes(set.materials.size(), 0.0);
  const auto take = [&](const SideRequest& one)
  {
    const auto found = std::find(set.materials.begin(), set.materials.end(), one.side);
    if (one.inside <= 0.0 || found == set.materials.end())
    {
      return false;
    }
    sizes[static_cast<std::size_t>(found - set.materials.begin())] = one.inside;
    return true;
  };
  std::vector<SideRequest>& all = request.sideRequests;
  all.erase(std::remove_if(all.begin(), all.end(), take), all.end());
  const bool hasSizes =
    std::any_of(sizes.begin(), sizes.end(), [](double size) { return size > 0.0; });
  if (hasSizes && request.quadSize == 0.0 && request.quadCount == 0)
  {
    double area = 0.0;
    for (const PlanarDomain& outline : set.outlines)
    {
      area += outline.Area();
    }
    request.quadSize = std::sqrt(area / DefaultQuads);
  }
  return sizes;
}

/// Throws Error if a size is requested inside of what is neither a material nor a loop.
void RequireMaterials(
  const RegionSet& set, const std::vector<DomainPart>& parts, const QuadRequest& rest)
{
  for (const SideRequest& one : rest.sideRequests)
  {
    const bool isSide = std::any_of(parts.begin(), parts.end(),
      [&one](const DomainPart& part) { return part.sides.Find(one.side) >= 0; });
    if (one.inside > 0.0 && !isSide)
    {
      std::string names;
      for (const std::string& name : set.materials)
      {
        names += (names.empty() ? "'" : ", '") + name + "'";
      }
      throw Error("There is no material or side '" + one.side +
        "' for a size inside of it; the materials are " + names + ".");
    }
  }
}

/// Requests the sizes inside of materials in their regions, and at the interfaces of others with them.
void AddSizesInside(
  const RegionSet& set, const std::vector<double>& sizes, RegionRequests& regionRequests)
{
  std::vector<PartRequest>& requests = regionRequests.ofRegions;
  const auto sizeOf = [&](int region) { return sizes[Index(set.regions[Index(region)].material)]; };
  for (std::size_t r = 0; r < requests.size(); ++r)
  {
    QuadRequest& own = requests[r].request;
    const double size = sizeOf(static_cast<int>(r));
    if (size > 0.0)
    {
      own.minimumSize = own.maximumSize = own.quadSize = size;
      own.quadCount = 0;
    }
  }
  for (const InterfacePiece& piece : set.interfaces)
  {
    for (const std::size_t end : { std::size_t(0), std::size_t(1) })
    {
      const double size = sizeOf(piece.regions[end]);
      const int other = piece.regions[1 - end];
      if (size <= 0.0 || (sizeOf(other) > 0.0 && sizeOf(other) <= size))
      {
        continue;
      }
      QuadRequest& coarser = requests[Index(other)].request;
      if (sizeOf(other) > 0.0)
      {
        coarser.minimumSize = std::min(coarser.minimumSize, size); // its sizes grow from there
      }
      std::vector<SideRequest>& all = coarser.sideRequests;
      const bool isGiven = std::any_of(all.begin(), all.end(),
        [&piece](const SideRequest& one) { return one.side == piece.name && one.size > 0.0; });
      if (!isGiven)
      {
        all.emplace_back();
        all.back().side = piece.name;
        all.back().size = size;
        regionRequests.targets.push_back(piece.name);
      }
    }
  }
}

/// Chooses the indices of corners at nodes and adds them to the requests of the regions.
void CompleteNodeCorners(const RegionSet& set, RegionRequests& requests)
{
  std::vector<std::vector<CornerChoice>> given;
  for (const PartRequest& one : requests.ofRegions)
  {
    given.push_back(one.request.corners);
  }
  requests.nodeCorners = FindNodeCorners(set, given);
  for (const std::vector<RegionCorner>& corners : requests.nodeCorners)
  {
    for (const RegionCorner& one : corners)
    {
      std::vector<CornerChoice>& own = requests.ofRegions[one.region].request.corners;
      const bool isGiven = std::any_of(own.begin(), own.end(),
        [&one](const CornerChoice& choice) { return choice.position == one.corner.position; });
      if (!isGiven && one.quarterIndex != SmallestRotationIndex(one.corner.Turning()))
      {
        own.push_back({ one.corner.position, one.quarterIndex });
      }
    }
  }
}
}

void OpenInterfaces(const std::vector<std::string>& names, RegionSet& set)
{
  for (const std::string& name : names)
  {
    bool isFound = false;
    std::string all;
    for (InterfacePiece& piece : set.interfaces)
    {
      const bool isCalled = IsCalled(set, piece, name);
      piece.isOpen = piece.isOpen || isCalled;
      isFound = isFound || isCalled;
      all += (all.empty() ? "'" : ", '") + piece.side + "'";
    }
    if (!isFound)
    {
      throw Error("There is no line or interface '" + name + "' to open" +
        (all.empty() ? "; the domain has none." : "; there are " + all + "."));
    }
  }
}

RegionRequests SplitForRegions(
  const RegionSet& set, const std::vector<DomainPart>& parts, const QuadRequest& request)
{
  QuadRequest rest = request;
  const std::vector<double> sizes = TakeSizesInside(set, rest);
  RequireMaterials(set, parts, rest);
  RegionRequests requests{ SplitRequest(parts, ForPieces(set, std::move(rest))), {}, {} };
  AddSizesInside(set, sizes, requests);
  CompleteNodeCorners(set, requests);
  return requests;
}
}
