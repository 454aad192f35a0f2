#pragma once

#include "Singularity.h"
#include "TriangleMesh.h"

#include <string>
#include <vector>

namespace crossfield::test
{
/// Drilled domain on which plain Newton's method has difficulties, or which has islands.
struct HardCase
{
  std::string name;
  TriangleMesh mesh;
};

/// Returns the configurations of docs/method.md §3 and §9 and other hard cases for the reduced
/// solve.
std::vector<HardCase> NamedHardCases();

/// Returns a random smooth domain with 4 + n singularities k = +1 and n of k = −1 at random
/// positions, n up to 2. The same number gives the same case on every platform.
HardCase RandomHardCase(int number);
}
