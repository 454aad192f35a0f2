#pragma once

#include "TMesh.h"

namespace crossfield
{
/// Arcs of which one at least must get more edges.
struct Violation
{
  std::vector<int> arcs;
};

/// What must not be one point but is (docs/method.md §14.3): two cones, a singularity and the boundary, points of the
/// boundary that no boundary arcs without edges join; one violation per class of points, with the arcs on the
/// shortest way in between. And boundary loops with less than three edges.
std::vector<Violation> FindViolations(const TMesh& mesh, const std::vector<int>& counts);
}
