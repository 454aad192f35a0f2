#include "BuiltinDomains.h"
#include "DissectedCholesky.h"
#include "DrillHoles.h"
#include "Error.h"
#include "MakePlanarDomain.h"
#include "MemoryBudget.h"
#include "MeshBudget.h"
#include "NestedDissection.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <functional>
#include <string>

namespace
{
using namespace crossfield;

std::string Sentence(const std::function<void()>& work)
{
  try
  {
    work();
  }
  catch (const Error& error)
  {
    return error.what();
  }
  return "";
}

PlanarDomain Disk(double edgeLength)
{
  BuiltinDomain disk;
  disk.edgeLength = edgeLength;
  return MakePlanarDomain(MakeBuiltinDomain(disk));
}

/// A folder in which files stand for those of the kernel.
class AvailableMemoryTest : public testing::Test
{
protected:
  AvailableMemoryTest()
  {
    std::string name = testing::TempDir() + "crossfield-memory-" + std::string(6, 'X'); // mkdtemp's
    Root = mkdtemp(name.data());
    Files = { Root + "/proc", Root + "/cgroup" };
  }
  ~AvailableMemoryTest() override { std::filesystem::remove_all(Root); }

  void Put(const std::string& name, const std::string& text) const
  {
    const std::filesystem::path path = Root + "/" + name;
    std::filesystem::create_directories(path.parent_path());
    std::ofstream(path) << text;
  }

  std::string Root;
  MemoryLimitFiles Files;
};

TEST_F(AvailableMemoryTest, IsUnknownWithoutAnyLimit)
{
  EXPECT_FALSE(AvailableMemory(Files).has_value());
}

TEST_F(AvailableMemoryTest, IsThatOfTheMachine)
{
  Put("proc/meminfo", "MemTotal: 8000 kB\nMemAvailable:    5000 kB\nSwapFree: 9000 kB\n");
  EXPECT_EQ(AvailableMemory(Files), 5000.0 * 1024.0);
}

TEST_F(AvailableMemoryTest, IsTheLeastOfAllControlGroupsAbove)
{
  Put("proc/meminfo", "MemAvailable: 5000 kB\n");
  Put("proc/self/cgroup", "0::/user/shell\n");
  Put("cgroup/user/shell/memory.max", "max\n");
  Put("cgroup/user/shell/memory.current", "700000\n");
  EXPECT_EQ(AvailableMemory(Files), 5000.0 * 1024.0);
  Put("cgroup/user/memory.max", "1000000\n");
  Put("cgroup/user/memory.current", "800000\n");
  EXPECT_EQ(AvailableMemory(Files), 200000.0);
  // Page cache is given back.
  Put("cgroup/user/memory.stat", "anon 5\ninactive_file 30000\nactive_file 20000\n");
  EXPECT_EQ(AvailableMemory(Files), 250000.0);
}

TEST_F(AvailableMemoryTest, KnowsControlGroupsOfTheFirstVersion)
{
  Put("proc/self/cgroup", "5:cpu,cpuacct:/a\n4:memory:/not/visible/in/a/container\n");
  Put("cgroup/memory/memory.limit_in_bytes", "1000000\n");
  Put("cgroup/memory/memory.usage_in_bytes", "900000\n");
  Put("cgroup/memory/memory.stat", "cache 1\ntotal_inactive_file 1000\n");
  EXPECT_EQ(AvailableMemory(Files), 101000.0);
  // More than the limit is in use: nothing is left, not less than nothing.
  Put("cgroup/memory/memory.usage_in_bytes", "2000000\n");
  EXPECT_EQ(AvailableMemory(Files), 0.0);
}

TEST(MemoryBudget, NamesBothNumbersAndTheMend)
{
  EXPECT_EQ(Sentence([] { RequireMemory(1.0, "A byte", "leave it out"); }), "");
  const std::string sentence =
    Sentence([] { RequireMemory(std::ldexp(1.0, 70), "A lot", "ask for less"); });
  EXPECT_EQ(sentence.find("A lot would need about 1.1e+12 GiB of memory, more than the "), 0u);
  EXPECT_NE(sentence.find(" GiB available; ask for less."), std::string::npos) << sentence;
}

/// The prediction against the mesh itself, for bulk, boundary and holes in turn.
TEST(MeshBudget, PredictsTheTrianglesOfAMesh)
{
  const auto compare = [](const PlanarDomain& domain, const std::vector<SizeSource>& sources,
                         double size, double gradation, double tolerance)
  {
    DrillOptions options;
    options.meshSize = size;
    options.gradation = gradation;
    options.refinements = sources;
    const auto made = static_cast<double>(DrillHoles(domain, {}, options).triangles.size());
    EXPECT_NEAR(PredictTriangles(domain, sources, size, gradation) / made, 1.0, tolerance)
      << made << " triangles";
  };
  compare(Disk(0.02), {}, 0.02, 0.25, 0.1);
  // Half of the excess of a place inside the domain is missing, as documented.
  compare(Disk(0.05), { { { 0.3, 0.1 }, 1e-5 } }, 0.05, 0.25, 0.5);
  compare(Disk(0.05), { { { 0.3, 0.1 }, 1e-3 } }, 0.1, 0.02, 0.6);
}

TEST(MeshBudget, TheMiddleOfTheDomainIsAPlaceLikeAnyOther)
{
  // Around a place size + 0.25 r: ∫ 2πr dr (h⁻² − maximum⁻²) to where h is the maximum, and half of it.
  constexpr double Size = 1e-6;
  constexpr double Maximum = 0.05;
  constexpr double Slope = 0.25;
  const PlanarDomain disk = Disk(0.05);
  const double reach = (Maximum - Size) / Slope;
  const double exact = Pi / std::sqrt(3.0) *
    (4.0 / (Slope * Slope) * (std::log(Maximum / Size) + Size / Maximum - 1.0) -
      2.0 * reach * reach / (Maximum * Maximum));
  const double bulk = PredictTriangles(disk, {}, Maximum, Slope);
  for (const Point& place : { Point(0.0, 0.0), Point(0.3, 0.1), Point(0.5, -0.5) })
  {
    const double excess = PredictTriangles(disk, { { place, Size } }, Maximum, Slope) - bulk;
    EXPECT_NEAR(excess / exact, 1.0, 0.1) << place.transpose();
  }
}

TEST(MeshBudget, RefusesAMeshBeforeItIsMade)
{
  const PlanarDomain disk = Disk(0.05);
  DrillOptions options;
  options.meshSize = 1e-6;
  for (const Configuration& configuration :
    { Configuration(), Configuration{ { { 0.0, 0.0 }, 4, 0.1 } } })
  {
    const std::string sentence = Sentence([&] { DrillHoles(disk, configuration, options); });
    EXPECT_EQ(sentence.find("A mesh with edge length 1e-06 would have about 7.2"), 0u) << sentence;
    EXPECT_NE(sentence.find("choose a larger edge length, about "), std::string::npos) << sentence;
  }
  options.meshSize = 1e-300; // its square is 0
  EXPECT_NE(Sentence([&] { DrillHoles(disk, {}, options); }), "");
}

TEST(MeshBudget, SuggestsAnEdgeLengthThatFits)
{
  const PlanarDomain disk = Disk(0.05);
  const std::string sentence = Sentence([&] { RequireMemoryForMesh(disk, {}, 1e-6, 0.25); });
  const std::string before = "edge length, about ";
  ASSERT_NE(sentence.find(before), std::string::npos) << sentence;
  const double suggested = std::stod(sentence.substr(sentence.find(before) + before.size()));
  // Others may take memory meanwhile: a little more than what is suggested.
  EXPECT_EQ(Sentence([&] { RequireMemoryForMesh(disk, {}, 1.5 * suggested, 0.25); }), "");
  EXPECT_NE(Sentence([&] { RequireMemoryForMesh(disk, {}, 0.1 * suggested, 0.25); }), "");
}

TEST(MeshBudget, RefusesAGradationThatSpreadsSmallTrianglesEverywhere)
{
  DrillOptions options;
  options.meshSize = 0.1;
  options.gradation = 1e-7;
  options.refinements = { { { 0.1, 0.2 }, 1e-7 } };
  const std::string sentence = Sentence([&] { DrillHoles(Disk(0.05), {}, options); });
  EXPECT_NE(sentence.find("larger gradation"), std::string::npos) << sentence;
}

TEST(MeshBudget, RefusesAHoleWithTooManyEdges)
{
  for (const int quarterIndex : { 2147483647, -2147483647 - 1, 2000000000 })
  {
    const std::string sentence = Sentence(
      [&] {
        DrillHoles(Disk(0.05), { { { 0.0, 0.0 }, quarterIndex, 0.1 } });
      });
    EXPECT_NE(sentence.find("edges"), std::string::npos) << quarterIndex << ": " << sentence;
  }
}

/// A dense border is what many holes make: unknowns that come last.
TEST(MemoryBudget, RefusesADenseBorderBeforeItIsMade)
{
  constexpr int Size = 400000; // its square is 1.2 TiB
  Eigen::SparseMatrix<double> matrix(Size, Size);
  matrix.setIdentity();
  const std::vector<Point> places(Size, Point::Zero());
  std::vector<int> last;
  for (int i = 0; i < Size; ++i)
  {
    last.push_back(i);
  }
  const std::string sentence = Sentence([&] { DissectedCholesky(matrix, places, last, {}); });
  EXPECT_EQ(sentence.find("The factorisation of 400000 unknowns"), 0u) << sentence;
  EXPECT_NE(sentence.find("fewer holes"), std::string::npos) << sentence;
}

/// The bound on the fill that stands for it before it is known.
TEST(MemoryBudget, FillGrowsAsOfNestedDissection)
{
  EXPECT_NEAR(DissectionFill(1024.0), 7.75 * 1024.0 * 10.0, 1e-9);
  EXPECT_EQ(DissectionFill(1.0), 1.0);
  EXPECT_EQ(DissectionFill(0.0), 0.0);
}
}
