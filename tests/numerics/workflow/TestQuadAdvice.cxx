// Remedies that errors and warnings of MakeQuadMesh offer: each test follows the advice.

#include "QuadAdvice.h"
#include "QuadWorkflow.h"

#include "MakePlanarDomain.h"
#include "SmoothBoundary.h"
#include "Support.h"

#include <algorithm>

namespace crossfield::test
{
namespace
{
bool Says(const std::vector<std::string>& sentences, const std::string& words)
{
  return std::any_of(sentences.begin(), sentences.end(),
    [&words](const std::string& sentence) { return sentence.find(words) != std::string::npos; });
}

/// Returns a request with singularities of index 1 and one of a given index in a disk.
QuadRequest WithIndex(int quarters)
{
  QuadRequest request;
  request.quadCount = 400;
  request.singularities = OnCircle(4 - quarters, 0.6, 0.1, 1, 0.2);
  request.singularities->push_back({ { 0.05, 0.1 }, quarters });
  return request;
}

TEST(QuadAdvice, SplittingHelpsWithLargeIndices)
{
  const PlanarDomain disk = Builtin("disk");
  QuadRequest three = WithIndex(3);
  EXPECT_TRUE(Refuses([&] { MakeQuadMesh(disk, three); }, { "(0.05, 0.1)", "index 3", "--split" }));
  QuadRequest two = WithIndex(2);
  const QuadWorkflowResult flat = MakeQuadMesh(disk, two);
  EXPECT_LT(flat.quads.quality.jacobian.min, 0.01);
  ASSERT_EQ(flat.warnings.size(), 1U);
  EXPECT_TRUE(Says(flat.warnings, "valence 2")) << flat.warnings[0];
  EXPECT_TRUE(Says(flat.warnings, "--split"));
  QuadRequest minusTwo = WithIndex(-2);
  const QuadWorkflowResult crowded = MakeQuadMesh(disk, minusTwo);
  EXPECT_FALSE(Says(crowded.warnings, "valence")); // a node of valence 6 is no fault
  EXPECT_TRUE(Says(crowded.events, "valence 6"));
  for (QuadRequest* request : { &three, &two, &minusTwo })
  {
    request->split = true;
    const QuadWorkflowResult split = MakeQuadMesh(disk, *request);
    EXPECT_FALSE(Says(split.warnings, "valence"));
    EXPECT_TRUE(Says(split.events, "was split into"));
    EXPECT_FALSE(Says(split.events, "--split"));
    EXPECT_GT(split.quads.quality.jacobian.min, 0.6);
    EXPECT_EQ(TotalQuarters(split.singularities), 4);
    EXPECT_TRUE(std::all_of(split.singularities.begin(), split.singularities.end(),
      [](const Singularity& singularity) { return std::abs(singularity.quarterIndex) == 1; }));
  }
}

TEST(QuadAdvice, RepairHelpsWithStretchedQuads)
{
  // A pair without symmetry: grid lines miss by about 33°.
  const PlanarDomain ring = RingOfEdges(0.05);
  QuadRequest request;
  request.quadCount = 400;
  // With both at the same radius, a repair would make them meet, and is not offered.
  request.singularities = Configuration{ { { 0.75, 0.0 }, 1 }, { { -0.48, 0.57 }, -1 } };
  const QuadWorkflowResult helpless = MakeQuadMesh(ring, request);
  ASSERT_TRUE(Says(helpless.warnings, "stretched by about"));
  EXPECT_FALSE(Says(helpless.warnings, "repair"));
  request.singularities = Configuration{ { { 0.85, 0.0 }, 1 }, { { -0.42, 0.5 }, -1 } };
  const QuadWorkflowResult stretched = MakeQuadMesh(ring, request);
  ASSERT_TRUE(Says(stretched.warnings, "stretched by about"));
  EXPECT_TRUE(Says(stretched.warnings, "--repair-holonomy"));
  request.repairHolonomy = true;
  const QuadWorkflowResult repaired = MakeQuadMesh(ring, request);
  EXPECT_TRUE(repaired.warnings.empty());
  EXPECT_LT(repaired.flattening ? repaired.flattening->PredictedStretch() : 1.0, 1.1);
}

TEST(QuadAdvice, NobodyIsToldToRepairWhatWasChosen)
{
  // A rotated hole without singularities has a defect that no singularity can change.
  PlanarDomain twisted;
  twisted.loops = { { { -1.0, -1.0 }, { 1.0, -1.0 }, { 1.0, 1.0 }, { -1.0, 1.0 } },
    { { 0.3, 0.1 }, { 0.1, -0.3 }, { -0.3, -0.1 }, { -0.1, 0.3 } } };
  QuadRequest request;
  request.quadCount = 400;
  request.repairHolonomy = true;
  const QuadWorkflowResult chosen = MakeQuadMesh(twisted, request);
  EXPECT_EQ(chosen.quads.quality.inverted, 0);
  request.singularities = Configuration{};
  EXPECT_TRUE(Refuses([&] { MakeQuadMesh(twisted, request); }, { "inner loop 1", "add a pair" }));
  request.singularities = Configuration{ { { 0.65, 0.1 }, 1 }, { { 0.0, 0.65 }, -1 } };
  EXPECT_EQ(MakeQuadMesh(twisted, request).quads.quality.inverted, 0);
}

TEST(QuadAdvice, SmoothingHelpsWithCusps)
{
  // A drop whose sides meet with an angle of 0 at (1, 0).
  Loop loop;
  for (int i = 0; i < 100; ++i)
  {
    const double t = 2.0 * Pi * i / 100;
    loop.push_back({ std::cos(t), std::sin(t) * std::pow(std::sin(0.5 * t), 2) });
  }
  const PlanarDomain drop = MakePlanarDomain({ loop });
  QuadRequest request;
  try
  {
    EXPECT_GT(MakeQuadMesh(drop, request).quads.quality.jacobian.min, 0.0);
  }
  catch (const Error& error)
  {
    const std::string message = error.what();
    EXPECT_EQ(message.find("finer mesh"), std::string::npos) << message; // it was tried
    const std::string words = "smooth the boundary with a length of ";
    const std::size_t at = message.find(words);
    ASSERT_NE(at, std::string::npos) << message;
    const PlanarDomain smooth =
      SmoothBoundary(drop, std::stod(message.substr(at + words.size()))).domain;
    EXPECT_GT(MakeQuadMesh(smooth, request).quads.quality.jacobian.min, 0.05);
  }
}

TEST(QuadAdvice, OffersTheFirstLengthThatWorks)
{
  const PlanarDomain disk = Builtin("disk");
  int calls = 0;
  const auto succeedAt = [&calls](int call)
  {
    calls = 0;
    return [&calls, call](const PlanarDomain&)
    {
      if (++calls < call)
      {
        throw Error("No map.");
      }
    };
  };
  EXPECT_NEAR(FindSmoothing(disk, {}, succeedAt(3)), disk.Diagonal() / 100.0, 1e-4);
  EXPECT_EQ(calls, 3);
  EXPECT_EQ(FindSmoothing(disk, {}, succeedAt(99)), 0.0);
  const Error coarse("The map folds", "use a finer mesh", Error::Kind::CoarseMesh);
  EXPECT_STREQ(coarse.what(), "The map folds; use a finer mesh.");
  EXPECT_STREQ(WithSmoothing(coarse, 0.025, false).what(),
    "The map folds; smooth the boundary with a length of 0.025 (SmoothingLength of Boundary Simplifier, "
    "--smooth-boundary).");
  EXPECT_STREQ(WithSmoothing(coarse, 0.0, false).what(),
    "The map folds on a finer mesh as well; give other singularities.");
}

TEST(QuadAdvice, OffersASmallerSizeThatWasTried)
{
  QuadQuality quality;
  quality.inverted = 1;
  quality.where = { 0.25, 0.5, 0.0 };
  EXPECT_EQ(DescribeInverted(quality, { 1, SmallerSize{ 0.0125, 4000 } }, true),
    "1 quad is inverted near (0.25, 0.5); use a smaller size: with 0.0125, 4000 quads, "
    "none is inverted.");
  EXPECT_EQ(DescribeInverted(quality, { 1, SmallerSize{ 0.0125, 4000, true } }, false),
    "1 quad is inverted near (0.25, 0.5); use a smaller size and the same singularities "
    "(--save-singularities, then -s): with 0.0125, 4000 quads, none is inverted.");
  quality.inverted = 2;
  EXPECT_EQ(DescribeInverted(quality, { 2, {} }, true),
    "2 quads are inverted, the worst near (0.25, 0.5), and smaller sizes do not help; choose other "
    "positions for the singularities nearby.");
  EXPECT_EQ(DescribeInverted(quality, { 2, {} }, false),
    "2 quads are inverted, the worst near (0.25, 0.5), and smaller sizes do not help.");
  EXPECT_EQ(DescribeInverted(quality, { 0, {} }, false),
    "2 quads are inverted, the worst near (0.25, 0.5).");
  // The quads of each size, as long as some are inverted.
  QuadResult quads;
  quads.size = 0.1;
  quads.mesh.quads.resize(100);
  const auto withMinimum = [](double minimum)
  {
    return [minimum](double size)
    {
      QuadResult result;
      result.quality.jacobian.min = size < 0.03 ? minimum : -1.0;
      return result;
    };
  };
  EXPECT_EQ(TrySmallerSizes(quads, withMinimum(0.5)).valid->size, 0.025);
  EXPECT_FALSE(TrySmallerSizes(quads, withMinimum(0.0)).valid);
  EXPECT_EQ(TrySmallerSizes(quads, withMinimum(0.0)).tried, 2);
  quads.tMesh.arcs.resize(3000); // trials would take too long
  EXPECT_EQ(TrySmallerSizes(quads, withMinimum(0.5)).tried, 0);
  quads.tMesh.arcs.clear();
  quads.mesh.quads.resize(20000);
  EXPECT_EQ(TrySmallerSizes(quads, withMinimum(0.5)).tried, 0);
}
}
}
