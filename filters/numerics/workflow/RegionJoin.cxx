#include "RegionJoin.h"

#include "Index.h"
#include "JoinLayouts.h"
#include "PeriodicSteps.h"

#include <algorithm>
#include <utility>

namespace crossfield
{
namespace
{
/// Joins regions, one after the other.
class RegionJoiner
{
public:
  RegionJoiner(
    const RegionSet& set, LaidOutRegions& regions, const std::vector<std::string>& targets)
    : Set(set)
    , Regions(regions)
    , Targets(targets)
  {
  }

  JoinedRegions Run()
  {
    std::vector<Layout> layouts;
    for (LaidOutRegion& region : this->Regions)
    {
      layouts.push_back(std::move(region.layout));
    }
    JoinedLayouts joined = JoinLayouts(layouts);
    this->Result.patches = joined.patches;
    std::vector<std::vector<int>> sides; // per region, of its sides in those of all
    for (std::size_t r = 0; r < this->Regions.size(); ++r)
    {
      const ResolvedRequest& own = this->Regions[r].request;
      const PlanarDomain& domain = this->Regions[r].domain;
      const std::vector<LoopArc> arcs(domain.loops.begin(), domain.loops.end());
      sides.push_back(this->AddSides(r, own.sides, arcs, joined.loops[r]));
      this->AddCurves(own.curves, arcs, joined.loops[r]);
      for (SidePrescription prescribed : own.prescribed)
      {
        const std::string& name = own.sides.names[Index(prescribed.side)];
        if (prescribed.count == 0 && !prescribed.isGraded &&
          std::find(this->Targets.begin(), this->Targets.end(), name) != this->Targets.end())
        {
          continue;
        }
        prescribed.side = sides[r][Index(prescribed.side)];
        const bool isNew =
          std::none_of(this->Result.prescribed.begin(), this->Result.prescribed.end(),
            [&prescribed](const SidePrescription& one) { return one.side == prescribed.side; });
        if (isNew) // otherwise the side is on several regions
        {
          this->Result.prescribed.push_back(prescribed);
        }
      }
    }
    const std::vector<Loop> loops = RequirePlanar(joined.layout.map.topology)->AlignedLoops();
    const std::vector<LoopArc> allArcs(loops.begin(), loops.end());
    std::vector<PairedSides> pairs;
    for (const InterfacePiece& piece : this->Set.interfaces)
    {
      PairedSides pair;
      const auto sideIn = [&](std::size_t index)
      {
        const std::size_t region = Index(piece.regions[index]);
        return sides[region][Index(this->Regions[region].request.sides.Find(piece.NameIn(index)))];
      };
      pair.first = sideIn(0);
      pair.second = sideIn(1);
      pair.name = "The interface " + piece.name;
      pair.isClosed = piece.isClosed;
      pair.isInterface = true;
      pair.isOpen = piece.isOpen;
      if (piece.IsSlit())
      {
        pair.spans = { FindSpan(this->Result.sides, allArcs, pair.first),
          FindSpan(this->Result.sides, allArcs, pair.second) };
      }
      this->PrescribeForSecond(pair);
      pairs.push_back(std::move(pair));
    }
    for (std::size_t r = 0; r < this->Regions.size(); ++r)
    {
      for (PairedSides pair : this->Regions[r].request.periodic)
      {
        pair.first = sides[r][Index(pair.first)];
        pair.second = sides[r][Index(pair.second)];
        pairs.push_back(std::move(pair));
      }
    }
    this->Result.layouts = LayoutSet(std::move(joined.layout), std::move(pairs));
    return std::move(this->Result);
  }

private:
  /// Prescribes for the second side of a pair what is prescribed for the first.
  void PrescribeForSecond(const PairedSides& pair)
  {
    SidePrescriptions& all = this->Result.prescribed;
    all.erase(std::remove_if(all.begin(), all.end(),
                [&pair](const SidePrescription& one) { return one.side == pair.second; }),
      all.end());
    const auto first = std::find_if(all.begin(), all.end(),
      [&pair](const SidePrescription& one) { return one.side == pair.first; });
    if (first != all.end())
    {
      all.push_back(Reversed(*first, pair.second));
    }
  }

  /// Adds the sides of a region, and returns their numbers in those of all. Sides of equal names are one,
  /// but for the two sides of an interface.
  std::vector<int> AddSides(std::size_t region, const BoundarySides& sides,
    const std::vector<LoopArc>& arcs, const std::vector<int>& loops)
  {
    std::vector<int> numbers;
    for (const std::string& name : sides.names)
    {
      const bool isSecond = std::any_of(this->Set.interfaces.begin(), this->Set.interfaces.end(),
        [&](const InterfacePiece& piece)
        { return piece.NameIn(1) == name && Index(piece.regions[1]) == region; });
      const int known = isSecond ? -1 : this->Result.sides.Find(name);
      numbers.push_back(known < 0 ? static_cast<int>(this->Result.sides.names.size()) : known);
      if (known < 0)
      {
        this->Result.sides.names.push_back(name);
      }
    }
    const SidesAlong along(sides, arcs);
    for (std::size_t l = 0; l < arcs.size(); ++l)
    {
      for (const LoopSide& start : along.On(l))
      {
        this->Result.sides.starts.push_back(
          { arcs[l].At(start.at), numbers[Index(start.side)], start.isFixed, loops[l] });
      }
    }
    return numbers;
  }

  void AddCurves(
    const CurvedBoundary& curves, const std::vector<LoopArc>& arcs, const std::vector<int>& loops)
  {
    const auto first = static_cast<int>(this->Result.curves.curves.size());
    this->Result.curves.curves.insert(
      this->Result.curves.curves.end(), curves.curves.begin(), curves.curves.end());
    const CurvesAlong along(curves, arcs);
    for (std::size_t l = 0; l < arcs.size(); ++l)
    {
      for (const double at : along.StartsOn(l))
      {
        const int curve = along.At(l, at);
        this->Result.curves.starts.push_back(
          { arcs[l].At(at), curve < 0 ? -1 : first + curve, loops[l] });
      }
    }
  }

  const RegionSet& Set;
  LaidOutRegions& Regions;
  const std::vector<std::string>& Targets;
  JoinedRegions Result;
};
}

JoinedRegions JoinRegions(
  const RegionSet& set, LaidOutRegions& regions, const std::vector<std::string>& targets)
{
  return RegionJoiner(set, regions, targets).Run();
}
}
