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

std::string ErrorMessage(const std::function<void()>& work)
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

/// Fixture with a folder of files that replace those of the kernel.
class AvailableMemoryTest : public testing::Test
{
protected:
  AvailableMemoryTest()
  {
    // replaced by mkdtemp
    std::string name = testing::TempDir() + "crossfield-memory-" + std::string(6, 'X');
    Root = mkdtemp(name.data());
    Files = { Root + "/proc", Root + "/cgroup" };
  }
  ~AvailableMemoryTest() override { std::filesystem::remove_all(Root); }

  void WriteFile(const std::string& name, const std::string& text) const
  {
    const std::filesystem::path path = Root + "/" + name;
    std::filesystem::create_directories(path.parent_path());
    std::ofstream(path) << text;
  }

  std::string Root;
  SystemFiles Files;
};

TEST_F(AvailableMemoryTest, IsUnknownWithoutAnyLimit)
{
  EXPECT_FALSE(AvailableMemory(Files).has_value());
}

TEST_F(AvailableMemoryTest, EqualsThatOfTheMachine)
{
  WriteFile("proc/meminfo", "MemTotal: 8000 kB\nMemAvailable:    5000 kB\nSwapFree: 9000 kB\n");
  EXPECT_EQ(AvailableMemory(Files), 5000.0 * 1024.0);
}

TEST_F(AvailableMemoryTest, IsTheMinimumOverParentControlGroups)
{
  WriteFile("proc/meminfo", "MemAvailable: 5000 kB\n");
  WriteFile("proc/self/cgroup", "0::/user/shell\n");
  WriteFile("cgroup/user/shell/memory.max", "max\n");
  WriteFile("cgroup/user/shell/memory.current", "700000\n");
  EXPECT_EQ(AvailableMemory(Files), 5000.0 * 1024.0);
  WriteFile("cgroup/user/memory.max", "1000000\n");
  WriteFile("cgroup/user/memory.current", "800000\n");
  EXPECT_EQ(AvailableMemory(Files), 200000.0);
  // Page cache counts as available.
  WriteFile("cgroup/user/memory.stat", "anon 5\ninactive_file 30000\nactive_file 20000\n");
  EXPECT_EQ(AvailableMemory(Files), 250000.0);
}

TEST_F(AvailableMemoryTest, SupportsControlGroupsOfVersionOne)
{
  WriteFile("proc/self/cgroup", "5:cpu,cpuacct:/a\n4:memory:/not/visible/in/a/container\n");
  WriteFile("cgroup/memory/memory.limit_in_bytes", "1000000\n");
  WriteFile("cgroup/memory/memory.usage_in_bytes", "900000\n");
  WriteFile("cgroup/memory/memory.stat", "cache 1\ntotal_inactive_file 1000\n");
  EXPECT_EQ(AvailableMemory(Files), 101000.0);
  // If usage exceeds the limit, 0 is left rather than a negative number.
  WriteFile("cgroup/memory/memory.usage_in_bytes", "2000000\n");
  EXPECT_EQ(AvailableMemory(Files), 0.0);
}

TEST(MemoryBudget, MessageStatesBothAmountsAndTheRemedy)
{
  EXPECT_EQ(ErrorMessage([] { RequireMemory(1.0, "A byte", "leave it out"); }), "");
  const std::string message =
    ErrorMessage([] { RequireMemory(std::ldexp(1.0, 70), "A lot", "ask for less"); });
  EXPECT_EQ(message.find("A lot would need about 1.1e+12 GiB of memory, more than the "), 0u);
  EXPECT_NE(message.find(" GiB available; ask for less."), std::string::npos) << message;
}

/// Compares the prediction with the mesh for the bulk, the boundary and a point inside in turn.
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
  // For a point inside the domain half of the excess is missing, as documented.
  compare(Disk(0.05), { { { 0.3, 0.1 }, 1e-5 } }, 0.05, 0.25, 0.5);
  compare(Disk(0.05), { { { 0.3, 0.1 }, 1e-3 } }, 0.1, 0.02, 0.6);
}

TEST(MeshBudget, PredictsTheTrianglesAroundASource)
{
  // Around a point: ∫ 2πr dr (h⁻² − maximum⁻²) with h = size + 0.25 r, up to the radius where h is
  // the maximum, and half of it.
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

TEST(MeshBudget, RefusesAMeshBeforeAllocation)
{
  const PlanarDomain disk = Disk(0.05);
  DrillOptions options;
  options.meshSize = 1e-6;
  for (const Configuration& configuration :
    { Configuration(), Configuration{ { { 0.0, 0.0 }, 4, 0.1 } } })
  {
    const std::string message = ErrorMessage([&] { DrillHoles(disk, configuration, options); });
    EXPECT_EQ(message.find("A mesh with edge length 1e-06 would have about 7.2"), 0u) << message;
    EXPECT_NE(message.find("choose a larger edge length, about "), std::string::npos) << message;
  }
  options.meshSize = 1e-300; // its square is 0
  EXPECT_NE(ErrorMessage([&] { DrillHoles(disk, {}, options); }), "");
}

TEST(MeshBudget, SuggestsAnEdgeLengthThatFits)
{
  const PlanarDomain disk = Disk(0.05);
  const std::string message = ErrorMessage([&] { RequireMemoryForMesh(disk, {}, 1e-6, 0.25); });
  const std::string before = "edge length, about ";
  ASSERT_NE(message.find(before), std::string::npos) << message;
  const double suggested = std::stod(message.substr(message.find(before) + before.size()));
  // Other processes may allocate memory meanwhile, so the size is a little larger than suggested.
  EXPECT_EQ(ErrorMessage([&] { RequireMemoryForMesh(disk, {}, 1.5 * suggested, 0.25); }), "");
  EXPECT_NE(ErrorMessage([&] { RequireMemoryForMesh(disk, {}, 0.1 * suggested, 0.25); }), "");
}

TEST(MeshBudget, RefusesAGradationThatSpreadsSmallTrianglesEverywhere)
{
  DrillOptions options;
  options.meshSize = 0.1;
  options.gradation = 1e-7;
  options.refinements = { { { 0.1, 0.2 }, 1e-7 } };
  const std::string message = ErrorMessage([&] { DrillHoles(Disk(0.05), {}, options); });
  EXPECT_NE(message.find("larger gradation"), std::string::npos) << message;
}

TEST(MeshBudget, RefusesAHoleWithTooManyEdges)
{
  for (const int quarterIndex : { 2147483647, -2147483647 - 1, 2000000000 })
  {
    const std::string message = ErrorMessage(
      [&] {
        DrillHoles(Disk(0.05), { { { 0.0, 0.0 }, quarterIndex, 0.1 } });
      });
    EXPECT_NE(message.find("edges"), std::string::npos) << quarterIndex << ": " << message;
  }
}

/// Many holes make a dense border: unknowns that are eliminated last.
TEST(MemoryBudget, RefusesADenseBorderBeforeAllocation)
{
  constexpr int Size = 400000; // its square is 1.2 TiB
  Eigen::SparseMatrix<double> matrix(Size, Size);
  matrix.setIdentity();
  const std::vector<SpacePoint> places(Size, SpacePoint::Zero());
  std::vector<int> last;
  for (int i = 0; i < Size; ++i)
  {
    last.push_back(i);
  }
  const std::string message = ErrorMessage([&] { DissectedCholesky(matrix, places, last, {}); });
  EXPECT_EQ(message.find("The factorisation of 400000 unknowns"), 0u) << message;
  EXPECT_NE(message.find("fewer holes"), std::string::npos) << message;
}

/// Checks the estimate of the fill that is used before the fill is known.
TEST(MemoryBudget, EstimatesFillOfNestedDissection)
{
  EXPECT_NEAR(DissectionFill(1024.0), 7.75 * 1024.0 * 10.0, 1e-9);
  EXPECT_EQ(DissectionFill(1.0), 1.0);
  EXPECT_EQ(DissectionFill(0.0), 0.0);
}
}
