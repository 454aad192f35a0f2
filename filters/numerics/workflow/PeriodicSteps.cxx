#include "PeriodicSteps.h"

#include "Error.h"

#include <algorithm>
#include <utility>

namespace crossfield
{
namespace
{
bool AreEqual(const SidePrescription& a, const SidePrescription& b)
{
  constexpr double Rounding = 1e-9; // of numbers typed in both directions, 0.5 and 2
  const auto isNear = [](double x, double y) { return std::abs(x - y) <= Rounding * std::abs(x); };
  return a.count == b.count && isNear(a.size, b.size) && a.isGraded == b.isGraded &&
    a.progression.both == b.progression.both && isNear(a.progression.ratio, b.progression.ratio) &&
    isNear(a.progression.first, b.progression.first) &&
    isNear(a.progression.last, b.progression.last);
}

/// Prescribes for the second side what is prescribed for the first.
void CopyPrescription(const BoundarySides& sides, int first, int second, SidePrescriptions& all)
{
  const auto find = [&all](int side)
  {
    return std::find_if(
      all.begin(), all.end(), [side](const SidePrescription& one) { return one.side == side; });
  };
  const auto from = find(first);
  const auto to = find(second);
  if (from == all.end())
  {
    return;
  }
  const SidePrescription reversed = Reversed(*from, second);
  if (to == all.end())
  {
    all.push_back(reversed);
  }
  else if (!AreEqual(*to, reversed))
  {
    const auto name = [&sides](int side) { return sides.names[side]; };
    throw Error("The periodic sides '" + name(first) + "' and '" + name(second) +
      "' have different numbers, progressions or sizes of edges; prescribe them for one of both.");
  }
}
}

SidePrescription Reversed(SidePrescription prescribed, int side)
{
  prescribed.side = side;
  Progression& progression = prescribed.progression;
  if (!progression.both)
  {
    progression.ratio = 1.0 / progression.ratio;
    std::swap(progression.first, progression.last);
  }
  return prescribed;
}

ResolvedRequest WithPeriodicSides(const PlanarDomain& domain, const ResolvedRequest& request)
{
  ResolvedRequest result = request;
  if (request.partners.empty())
  {
    return result;
  }
  result.periodic = FindPairedSides(domain, result.sides, request.curves, request.partners);
  for (const PairedSides& pair : result.periodic)
  {
    CopyPrescription(result.sides, pair.first, pair.second, result.prescribed);
    CopyPrescription(result.sides, pair.second, pair.first, result.prescribed);
  }
  return result;
}
}
