// Sets of corner indices, compared with counts by hand, and their effect on proposals.

#include "CornerSets.h"

#include "ConfigurationProposal.h"
#include "MakePlanarDomain.h"
#include "PoincareHopf.h"
#include "Support.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace crossfield::test
{
namespace
{
TEST(CornerSets, HexagonHasOneOrTwoFlatCorners)
{
  // The energy of a corner of 120 degrees at k = 0 exceeds that at k = 1 by that of an interior
  // quarter. The six corners have k = 1 and the sum must be four, so one or two may be 0; two may
  // be neighbours, have one between them, or be opposite.
  const PlanarDomain hexagon = MakePlanarDomain({ RegularPolygon(6) });
  const auto sets = FindCornerSets(hexagon, {});
  std::map<int, int> byDistance; // distance of the two in tenths of the side, 0 for a single one
  for (const std::vector<CornerChoice>& set : sets)
  {
    ASSERT_TRUE(set.size() == 1 || set.size() == 2);
    for (const CornerChoice& corner : set)
    {
      EXPECT_EQ(corner.quarterIndex, 0);
    }
    ++byDistance[static_cast<int>(
      std::round(10.0 * (set.front().position - set.back().position).norm()))];
  }
  EXPECT_EQ(byDistance, (std::map<int, int>{ { 0, 1 }, { 10, 1 }, { 17, 1 }, { 20, 1 } }));
  CornerSetOptions others;
  others.known = { sets.back() };
  EXPECT_EQ(FindCornerSets(hexagon, others).size(), 3U);
  // With equal angles and sides of different lengths, all sets are different.
  Loop irregular = { Point::Zero() };
  for (const double side : { 1.0, 2.0, 1.5, 1.3, 1.7 })
  {
    const double direction = Pi / 3.0 * static_cast<double>(irregular.size());
    irregular.push_back(irregular.back() + side * Point(std::cos(direction), std::sin(direction)));
  }
  CornerSetOptions all;
  all.count = 100;
  EXPECT_EQ(FindCornerSets(MakePlanarDomain({ irregular }), all).size(), 6U + 15U);
  all.given = { { irregular[2], 1 }, { irregular[4], 1 } };
  EXPECT_EQ(FindCornerSets(MakePlanarDomain({ irregular }), all).size(), 4U + 6U);
}

TEST(CornerSets, AreEmptyIfAllCornersAreDecided)
{
  EXPECT_TRUE(FindCornerSets(LShape(), {}).empty());
  EXPECT_TRUE(FindCornerSets(Builtin("disk"), {}).empty());
  const PlanarDomain square = MakePlanarDomain({ RegularPolygon(4) });
  CornerSetOptions options;
  EXPECT_TRUE(FindCornerSets(square, options).empty());
  // The index of a field counts like the smallest rotation.
  options.fieldCorners = { { { 1.0, 0.0 }, 0 } };
  const auto sets = FindCornerSets(square, options);
  ASSERT_EQ(sets.size(), 1U);
  ASSERT_EQ(sets[0].size(), 1U);
  EXPECT_EQ(sets[0][0].quarterIndex, 0);
  // This does not apply if another index is given.
  options.given = { { { 1.0, 0.0 }, 1 } };
  EXPECT_TRUE(FindCornerSets(square, options).empty());
}

TEST(CornerSets, HexagonAlternativesIncludeBestPair)
{
  // Opposite flat corners divide the hexagon into two trapezia; neighbours, which the classifier
  // chooses, make sizes less uniform.
  const PlanarDomain hexagon = MakePlanarDomain({ RegularPolygon(6) });
  ProposalOptions options;
  options.chooseCorners = true;
  options.variations = true;
  const ProposedConfiguration* opposite = nullptr;
  const ProposedConfiguration* neighbours = nullptr;
  const auto proposals = ProposeConfigurations(hexagon, options);
  for (const ProposedConfiguration& proposal : proposals)
  {
    const int given = TotalQuarters(proposal.singularities);
    EXPECT_TRUE(
      CountQuarters(hexagon.loops, given, options.cornerAngle, proposal.corners).Consistent());
    if (proposal.singularities.empty() && proposal.corners.size() == 2)
    {
      const double distance = (proposal.corners[0].position - proposal.corners[1].position).norm();
      opposite = distance > 1.9 ? &proposal : opposite;
      neighbours = distance < 1.1 ? &proposal : neighbours;
    }
  }
  ASSERT_NE(opposite, nullptr);
  ASSERT_NE(neighbours, nullptr);
  EXPECT_LT(opposite->energy, neighbours->energy - 1.0);
  EXPECT_LT(opposite->sizeSpread, 0.7 * neighbours->sizeSpread);
}
}
}
