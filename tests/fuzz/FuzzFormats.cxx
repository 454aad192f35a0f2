/**
 * Makes meshes of quads or hexahedra from the bytes of the fuzzer, most of them damaged, and writes them in every
 * format of the numerics. Each writer throws crossfield::Error with a sentence, or returns files that are not empty.
 */
#include "Error.h"
#include "MeshFormats.h"
#include "SweepQuads.h"

#include <fuzzer/FuzzedDataProvider.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <limits>

namespace
{
using namespace crossfield;

void Require(bool condition, const char* what)
{
  if (!condition)
  {
    std::fprintf(stderr, "violated property: %s\n", what);
    std::abort();
  }
}

/** Returns a valid grid of quads, which is one block and may close to a ring. */
SolverMesh MakeGrid(FuzzedDataProvider& bytes)
{
  SolverMesh mesh;
  mesh.order = bytes.ConsumeIntegralInRange<int>(1, 3);
  const int columns = bytes.ConsumeIntegralInRange<int>(1, 5);
  const int rows = bytes.ConsumeIntegralInRange<int>(1, 4);
  const bool isRing = columns > 2 && bytes.ConsumeBool();
  const int p = mesh.order;
  const int wide = isRing ? columns * p : columns * p + 1;
  const double low = bytes.PickValueInArray({ 0.0, 0.5, -1.0 }); // on the axis, above, across
  for (int n = 0; n < wide * (rows * p + 1); ++n)
  {
    mesh.points.emplace_back(0.3 * (n % wide), low + 0.2 * (n / wide), 0.0);
  }
  const auto at = [&](int i, int j) { return i % wide + wide * j; };
  MeshBlock block = { { columns, rows, 0 }, {} };
  for (int j = 0; j <= rows; ++j)
  {
    for (int i = 0; i <= columns; ++i)
    {
      block.nodes.push_back(at(i * p, j * p));
    }
  }
  mesh.blocks = { block };
  mesh.regionNames = { "domain", "other" };
  for (int side = 0; side < 4; ++side)
  {
    std::string name = bytes.ConsumeRandomLengthString(40);
    std::replace(name.begin(), name.end(), '\0', ' '); // a message ends with the first zero
    mesh.sideNames.push_back(name);
  }
  const auto addFace = [&](int a, int b, int side)
  {
    mesh.faces.insert(mesh.faces.end(), { a, b });
    mesh.side.push_back(side);
  };
  for (int cell = 0; cell < columns * rows; ++cell)
  {
    const int i = cell % columns * p;
    const int j = cell / columns * p;
    for (int n = 0; n < (p + 1) * (p + 1); ++n)
    {
      mesh.cells.push_back(at(i + n % (p + 1), j + n / (p + 1)));
    }
    mesh.region.push_back(bytes.ConsumeIntegralInRange<int>(0, 7) == 0 ? 1 : 0);
    if (j == 0)
    {
      addFace(at(i, 0), at(i + p, 0), 0);
    }
    if (j + p == rows * p)
    {
      addFace(at(i, rows * p), at(i + p, rows * p), 1);
    }
    if (i == 0 && !isRing)
    {
      addFace(at(0, j), at(0, j + p), 2);
    }
    if (i + p == columns * p && !isRing)
    {
      addFace(at(columns * p, j), at(columns * p, j + p), 3);
    }
  }
  return mesh;
}

/** Changes a number of an array, or its length. */
void Damage(std::vector<int>& numbers, FuzzedDataProvider& bytes)
{
  if (numbers.empty() || bytes.ConsumeIntegralInRange<int>(0, 4) == 0)
  {
    numbers.resize(bytes.ConsumeIntegralInRange<std::size_t>(0, numbers.size() + 2));
    return;
  }
  const auto place = bytes.ConsumeIntegralInRange<std::size_t>(0, numbers.size() - 1);
  numbers[place] =
    bytes.ConsumeBool() ? bytes.ConsumeIntegralInRange<int>(-1, 40) : bytes.ConsumeIntegral<int>();
}

void Damage(SolverMesh& mesh, FuzzedDataProvider& bytes)
{
  switch (bytes.ConsumeIntegralInRange<int>(0, 12))
  {
  case 0:
    return Damage(mesh.cells, bytes);
  case 1:
    return Damage(mesh.faces, bytes);
  case 2:
    return Damage(mesh.side, bytes);
  case 3:
    return Damage(mesh.region, bytes);
  case 4:
    if (!mesh.points.empty())
    {
      const auto place = bytes.ConsumeIntegralInRange<std::size_t>(0, mesh.points.size() - 1);
      mesh.points[place][bytes.ConsumeIntegralInRange<int>(0, 2)] =
        bytes.PickValueInArray({ std::numeric_limits<double>::quiet_NaN(),
          std::numeric_limits<double>::infinity(), 1e308, -1e308, 5e-324, -0.0 });
    }
    return;
  case 5:
    mesh.points.resize(bytes.ConsumeIntegralInRange<std::size_t>(0, mesh.points.size()));
    return;
  case 6:
    mesh.blocks.emplace_back();
    return;
  case 7:
    mesh.blocks.clear();
    return;
  case 8:
    mesh.sideNames.resize(bytes.ConsumeIntegralInRange<std::size_t>(0, 6));
    return;
  case 9:
    mesh.order = bytes.ConsumeIntegralInRange<int>(-1, 4);
    return;
  case 10:
    mesh.dimension = bytes.ConsumeIntegralInRange<int>(0, 4);
    return;
  default:
    if (!mesh.blocks.empty())
    {
      MeshBlock& block = mesh.blocks[0];
      if (bytes.ConsumeBool())
      {
        Damage(block.nodes, bytes);
        return;
      }
      block.cells[bytes.ConsumeIntegralInRange<std::size_t>(0, 2)] = bytes.ConsumeBool()
        ? bytes.ConsumeIntegralInRange<int>(-1, 9)
        : bytes.ConsumeIntegral<int>();
    }
  }
}

/** Calls a step, whose error must be one sentence. */
template <typename Step>
void Try(const Step& step)
{
  try
  {
    step();
  }
  catch (const Error& error)
  {
    const std::string sentence = error.what();
    if (sentence.size() <= 20 || sentence.back() != '.')
    {
      std::fprintf(stderr, "not one sentence: %s\n", sentence.c_str());
    }
    Require(sentence.size() > 20 && sentence.back() == '.', "an error is a sentence");
  }
}
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  FuzzedDataProvider bytes(data, size);
  SolverMesh mesh = MakeGrid(bytes);
  if (bytes.ConsumeBool())
  {
    Sweep sweep;
    sweep.kind = bytes.ConsumeBool() ? Sweep::Translation : Sweep::Rotation;
    sweep.layers = bytes.ConsumeIntegralInRange<int>(1, 4);
    sweep.angle = bytes.PickValueInArray({ 5.0, 90.0, 360.0 });
    Try([&] { mesh = SweepQuads(mesh, sweep); });
  }
  const int damages = bytes.ConsumeIntegralInRange<int>(0, 3);
  for (int i = 0; i < damages; ++i)
  {
    Damage(mesh, bytes);
  }
  for (const char* name : { "a.msh", "a.inp", "a.su2", "a.xyz", "a.ex2" })
  {
    Try(
      [&]
      {
        for (const FileText& file : WriteMeshFiles(mesh, name))
        {
          Require(!file.text.empty(), "a file has content");
        }
      });
  }
  return 0;
}
