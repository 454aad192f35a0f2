#pragma once

#include "PlanarDomain.h"
#include "Singularity.h"

#include <cstdint>

namespace crossfield::test
{
/// A domain with singularities placed at random whose quarter indices have the right sum. Grid
/// lines around its inner loops do not close up in general.
struct RandomCase
{
  PlanarDomain domain;
  Configuration singularities;
};

/// Quads that the cases are meant for; singularities are at least 1.5 of their edges from each other
/// and from the boundary.
constexpr int QuadsOfRandomCases = 1000;

/// Returns a ring, the inner circle not always in the middle, with four to eight singularities.
RandomCase RandomRing(std::uint32_t seed);

/// Returns a rectangle with 2 to 10 circular holes, four singularities −1 per hole and up to four
/// pairs ±1.
RandomCase RandomPlate(std::uint32_t seed);
}
