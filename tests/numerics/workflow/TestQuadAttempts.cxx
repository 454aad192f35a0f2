// The order of attempts: each is made once, and what follows depends on the errors and quads so
// far.

#include "QuadAttempts.h"

#include "QuadWorkflow.h"
#include "SideRequests.h"
#include "Support.h"

#include <algorithm>
#include <set>
#include <tuple>

namespace crossfield::test
{
namespace
{
auto Values(const QuadAttempt& a)
{
  return std::tuple(
    a.hasSingularities, a.mergesBlocks, a.layerDistance, a.takesFewRows, a.motion, a.refinement);
}

enum class Result
{
  Good,
  Poor,
  Inverted,
  BadInput,
  CoarseMesh,
  LackOfRows
};

QuadAttemptRecord Record(const QuadAttempt& attempt, Result result)
{
  QuadAttemptRecord record{ attempt, std::nullopt, result == Result::Inverted,
    result == Result::Good, {} };
  if (result > Result::Inverted)
  {
    record.error = Error("It fails", "do this",
      result == Result::CoarseMesh     ? Error::Kind::CoarseMesh
        : result == Result::LackOfRows ? Error::Kind::LackOfRows
                                       : Error::Kind::BadInput);
  }
  return record;
}

/// Calls visit with every list of records that leads to no further attempt.
template <typename Visit>
void ForAllRuns(const PlanarDomain& domain, const ResolvedRequest& request,
  std::vector<QuadAttemptRecord> made, const Visit& visit)
{
  const std::optional<QuadAttempt> next = NextAttempt(domain, request, made);
  if (!next)
  {
    visit(made);
    return;
  }
  ASSERT_LE(made.size(), 30U);
  for (const Result result : { Result::Good, Result::Poor, Result::Inverted, Result::BadInput,
         Result::CoarseMesh, Result::LackOfRows })
  {
    made.push_back(Record(*next, result));
    ForAllRuns(domain, request, made, visit);
    made.pop_back();
  }
}

/// Returns a request with a layer at a disk or ring.
ResolvedRequest WithLayer(const PlanarDomain& domain)
{
  QuadRequest request;
  request.sideRequests = { LayerOf("outer0", 0.01) };
  return Resolve(domain, request);
}

TEST(QuadAttempts, AreDifferentAndEndWithTheFirstGoodOne)
{
  for (const char* name : { "disk", "ring" })
  {
    const PlanarDomain domain = Builtin(name);
    for (const BlockMerge merge : { BlockMerge::None, BlockMerge::Clean })
    {
      for (const bool isGiven : { false, true })
      {
        ResolvedRequest request = WithLayer(domain);
        request.merge = merge;
        if (isGiven)
        {
          request.singularities.emplace(1);
        }
        std::size_t largest = 0;
        ForAllRuns(domain, request, {},
          [&](const std::vector<QuadAttemptRecord>& made)
          {
            largest = std::max(largest, made.size());
            std::set<decltype(Values({}))> different;
            for (const QuadAttemptRecord& record : made)
            {
              different.insert(Values(record.attempt));
            }
            EXPECT_EQ(different.size(), made.size());
            EXPECT_TRUE(std::none_of(made.begin(), made.end() - 1,
              [](const QuadAttemptRecord& record) { return record.isAcceptable; }));
          });
        EXPECT_GE(largest, isGiven && name == std::string("disk") ? 2U : 4U);
      }
    }
  }
}

TEST(QuadAttempts, RefineTheMeshThenRepairTheHolonomy)
{
  const PlanarDomain ring = Builtin("ring");
  ResolvedRequest request = Resolve(ring, {});
  std::vector<QuadAttemptRecord> made;
  const auto next = [&]
  {
    const std::optional<QuadAttempt> attempt = NextAttempt(ring, request, made);
    if (attempt)
    {
      made.push_back(Record(*attempt, Result::CoarseMesh));
    }
    return attempt;
  };
  while (next())
  {
  }
  ASSERT_EQ(made.size(), 4U);
  for (std::size_t i = 0; i < 4; ++i)
  {
    EXPECT_EQ(made[i].attempt.refinement, i % 2 == 0 ? 1.0 : 2.0);
    EXPECT_EQ(made[i].attempt.motion,
      i > 1 ? SingularityMotion::RepairedHolonomy : SingularityMotion::None);
  }
  // Given ones then move to a minimum of the energy.
  made.clear();
  request.singularities.emplace(1);
  while (next())
  {
  }
  ASSERT_EQ(made.size(), 6U);
  EXPECT_EQ(made[3].attempt.motion, SingularityMotion::RepairedHolonomy);
  EXPECT_EQ(made[4].attempt.motion, SingularityMotion::MinimumEnergy);
  EXPECT_EQ(made[5].attempt.refinement, 2.0);
  request.singularities.reset();
  // A repair that was requested is part of every attempt.
  made.clear();
  request.repairHolonomy = true;
  while (next())
  {
  }
  EXPECT_EQ(made.size(), 2U);
}

TEST(QuadAttempts, MoveChosenSingularitiesAwayFromLayersUpToALimit)
{
  const PlanarDomain disk = Builtin("disk");
  ResolvedRequest request = WithLayer(disk);
  request.merge = BlockMerge::Clean;
  std::vector<QuadAttemptRecord> made;
  while (const std::optional<QuadAttempt> attempt = NextAttempt(disk, request, made))
  {
    made.push_back(Record(*attempt, Result::LackOfRows));
  }
  ASSERT_EQ(made.size(), 6U);
  EXPECT_TRUE(made[0].attempt.mergesBlocks);
  EXPECT_FALSE(made[1].attempt.mergesBlocks);
  EXPECT_EQ(made[1].attempt.layerDistance, 1.0);
  EXPECT_NEAR(made[4].attempt.layerDistance, 2.197, 1e-12);
  EXPECT_FALSE(made[4].attempt.takesFewRows);
  EXPECT_TRUE(made[5].attempt.takesFewRows);
  // Given ones stay.
  request.merge = BlockMerge::None;
  request.singularities.emplace();
  EXPECT_FALSE(NextAttempt(disk, request, { Record({}, Result::LackOfRows) }));
}

TEST(QuadAttempts, KeepTheMeshWhereOnlyMergingIsInTheWay)
{
  const PlanarDomain ring = Builtin("ring");
  ResolvedRequest request = WithLayer(ring);
  request.merge = BlockMerge::Clean;
  request.singularities.emplace();
  std::vector<QuadAttemptRecord> made;
  for (const Result result : { Result::CoarseMesh, Result::LackOfRows })
  {
    made.push_back(Record(*NextAttempt(ring, request, made), result));
  }
  const std::optional<QuadAttempt> unmerged = NextAttempt(ring, request, made);
  ASSERT_TRUE(unmerged);
  EXPECT_EQ(unmerged->refinement, 2.0);
  EXPECT_FALSE(unmerged->mergesBlocks);
  EXPECT_EQ(unmerged->motion, SingularityMotion::None);
  made.push_back(Record(*unmerged, Result::LackOfRows));
  EXPECT_FALSE(NextAttempt(ring, request, made)); // given singularities stay where they are
}

TEST(QuadAttempts, MoveGivenSingularitiesOnlyWhereQuadsAreInverted)
{
  const PlanarDomain disk = Builtin("disk");
  ResolvedRequest request = Resolve(disk, {});
  request.singularities.emplace(1);
  EXPECT_FALSE(NextAttempt(disk, request, { Record({}, Result::Poor) }));
  const std::optional<QuadAttempt> moved =
    NextAttempt(disk, request, { Record({}, Result::Inverted) });
  ASSERT_TRUE(moved);
  EXPECT_EQ(moved->motion, SingularityMotion::MinimumEnergy);
  EXPECT_FALSE(NextAttempt(disk, request, { Record(*moved, Result::Inverted) }));
  request.hold = true;
  EXPECT_FALSE(NextAttempt(disk, request, { Record({}, Result::Inverted) }));
}

/// Between the two singularities of this strip, sizes change by a factor of more than 10⁸.
TEST(QuadAttempts, MoveGivenSingularitiesWithoutValidQuadsUnlessTheyAreHeld)
{
  const double length = 24.0;
  PlanarDomain strip;
  strip.loops = { { { 0.0, 0.0 }, { length, 0.0 }, { length, 1.0 }, { 0.0, 1.0 } } };
  QuadRequest request;
  request.quadCount = 500;
  request.singularities = { { { 1.0, 0.5 }, 1 }, { { length - 1.0, 0.5 }, -1 } };
  const QuadWorkflowResult result = MakeQuadMesh(strip, request);
  EXPECT_EQ(result.quads.quality.inverted, 0);
  EXPECT_GT(result.quads.quality.jacobian.min, 0.6);
  EXPECT_EQ(result.attempts.back().what,
    "With the given singularities, moved towards a minimum of the energy");
  ASSERT_EQ(result.singularities.size(), 2U);
  EXPECT_EQ(result.singularities[0].quarterIndex, 1);
  EXPECT_EQ(result.singularities[1].quarterIndex, -1);
  ASSERT_FALSE(result.moves->empty());
  const double largest = std::max_element(result.moves->begin(), result.moves->end(),
    [](const SingularityMove& a, const SingularityMove& b) {
      return a.Distance() < b.Distance();
    })->Distance();
  EXPECT_NEAR(result.moved, largest, 1e-12);
  ASSERT_FALSE(result.warnings.empty());
  EXPECT_NE(
    result.warnings[0].find("were moved towards a minimum of the energy"), std::string::npos);
  request.hold = true;
  EXPECT_TRUE(
    Refuses([&] { MakeQuadMesh(strip, request); }, { "do not hold the singularities", "--hold" }));
}

TEST(QuadAttempts, AreInTheResult)
{
  QuadRequest request;
  request.quadCount = 300;
  const QuadWorkflowResult result = MakeQuadMesh(Builtin("disk"), request);
  ASSERT_EQ(result.attempts.size(), 1U);
  EXPECT_EQ(result.attempts[0].what, "With chosen singularities");
  EXPECT_EQ(
    result.attempts[0].outcome.find(std::to_string(result.quads.mesh.quads.size()) + " quads in "),
    0U)
    << result.attempts[0].outcome;
}
}
}
