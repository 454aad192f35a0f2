#include "ResolvedRequest.h"

#include "Error.h"

#include <algorithm>

namespace crossfield
{
namespace
{
/// Throws Error if something is prescribed for a side that has it already.
void RequireOnce(
  bool isPrescribed, bool isPrescribedAgain, const char* what, const std::string& side)
{
  if (isPrescribed && isPrescribedAgain)
  {
    throw Error(
      "The " + std::string(what) + " of side '" + side + "' is prescribed twice; leave one out.");
  }
}

/// Adds a count, a progression and a size to those of the side of an index.
void Add(const SideRequest& request, int side, SidePrescriptions& all)
{
  auto found = std::find_if(
    all.begin(), all.end(), [side](const SidePrescription& one) { return one.side == side; });
  if (found == all.end())
  {
    all.emplace_back();
    found = all.end() - 1;
    found->side = side;
  }
  RequireOnce(found->count != 0, request.count != 0, "number of edges", request.side);
  RequireOnce(found->isGraded, request.progression.has_value(), "progression", request.side);
  RequireOnce(found->size != 0.0, request.size != 0.0, "size", request.side);
  RequireOnce(found->inside != 0.0, request.inside != 0.0, "size inside", request.side);
  found->count = request.count != 0 ? request.count : found->count;
  found->size = request.size != 0.0 ? request.size : found->size;
  found->inside = request.inside != 0.0 ? request.inside : found->inside;
  if (request.progression)
  {
    found->isGraded = true;
    found->progression = *request.progression;
  }
}
}

ResolvedRequest Resolve(const PlanarDomain& domain, const QuadRequest& request)
{
  ResolvedRequest resolved{ request, {}, {}, {}, {}, {}, {}, false, {} };
  if (resolved.sides.names.empty())
  {
    resolved.sides = NameSides(domain);
  }
  resolved.curveRequest.findsArcs = request.findsArcs;
  for (const SideRequest& one : request.sideRequests)
  {
    if (one.count != 0 || one.progression || one.size != 0.0 || one.inside != 0.0)
    {
      RequireSide(resolved.sides.names, one.side);
      Add(one, resolved.sides.Find(one.side), resolved.prescribed);
    }
    if (one.layer)
    {
      resolved.layers.push_back(*one.layer);
      resolved.layers.back().name = one.side;
    }
    if (one.curve)
    {
      resolved.curveRequest.declared.push_back({ one.side, *one.curve });
    }
    if (!one.partner.empty())
    {
      resolved.partners.push_back({ one.side, one.partner });
    }
  }
  return resolved;
}

bool IsSizingFree(const ResolvedRequest& request)
{
  return !request.sizing && request.layers.empty() &&
    std::none_of(request.prescribed.begin(), request.prescribed.end(),
      [](const SidePrescription& one) { return one.isGraded; });
}
}
