#pragma once

#include "Singularity.h"
#include "TriangleMesh.h"

#include <string>
#include <vector>

namespace crossfield::test
{
/// A drilled domain on which plain Newton's method has trouble, or that has islands.
struct HardCase
{
  std::string name;
  TriangleMesh mesh;
};

/// The configurations of docs/method.md §3 and §9 and of the issue of the reduced solve.
std::vector<HardCase> NamedHardCases();

/// A random smooth domain with 4 + n singularities k = +1 and n of k = −1 at random places, n up to
/// 2; the same for the same number on every platform.
HardCase RandomHardCase(int number);
}
