// The order of the meshes of several configurations.

#include "Alternatives.h"

#include <gtest/gtest.h>

namespace crossfield::test
{
namespace
{
Alternative Make(int rank, int nodes, int blocks, double attained, double variation)
{
  Alternative one;
  one.rank = rank;
  one.nodes = nodes;
  one.blocks = blocks;
  one.scaledJacobian = one.attained = attained;
  one.sizeVariation = variation;
  return one;
}

using Order = std::vector<std::size_t>;
}

TEST(Alternatives, PreferencesOrderThem)
{
  const std::vector<Alternative> all = { Make(0, 10, 40, 0.9, 0.12), Make(0, 10, 30, 0.9, 0.15),
    Make(1, 8, 35, 0.9, 0.20), Make(2, 12, 20, 0.9, 0.10) };
  EXPECT_EQ(OrderAlternatives(all, {}), (Order{ 1, 0, 2, 3 }));
  EXPECT_EQ(OrderAlternatives(all, MeshPreference::Nodes)[0], 2U);
  EXPECT_EQ(OrderAlternatives(all, MeshPreference::Blocks)[0], 3U);
  EXPECT_EQ(OrderAlternatives(all, MeshPreference::Uniform), (Order{ 3, 0, 1, 2 }));
}

TEST(Alternatives, MetTargetSizesComeBeforeFewNodes)
{
  std::vector<Alternative> all = { Make(0, 4, 9, 0.85, 0.7), Make(1, 8, 70, 0.84, 0.9),
    Make(2, 8, 40, 0.83, 0.8), Make(3, 10, 30, 0.86, 0.8), Make(4, 6, 20, 0.7, 0.8) };
  for (std::size_t i = 0; i < all.size(); ++i)
  {
    all[i].met = i == 0 ? 0.7 : 1.0;
  }
  // Sizes that vary are what is asked for; the shape of the last one is too poor.
  EXPECT_EQ(OrderAlternatives(all, {}), (Order{ 2, 1, 3, 4, 0 }));
  all[3].met = 0.95;
  EXPECT_EQ(OrderAlternatives(all, {}), (Order{ 2, 1, 4, 3, 0 }));
}

TEST(Alternatives, PoorOnesAreLast)
{
  std::vector<Alternative> all = { Make(0, 4, 9, 0.90, 0.10), Make(1, 8, 30, 0.94, 0.10),
    Make(1, 6, 30, 0.94, 0.25) };
  // worse by more than 0.03 in shape; by more than 0.1 in sizes
  EXPECT_EQ(OrderAlternatives(all, {}), (Order{ 1, 0, 2 }));
  EXPECT_EQ(OrderAlternatives(all, MeshPreference::Uniform), (Order{ 1, 2, 0 }));
  all[1].isValid = false; // it no longer counts as the best either
  EXPECT_EQ(OrderAlternatives(all, MeshPreference::Nodes).back(), 1U);
  EXPECT_EQ(OrderAlternatives({}, {}), Order());
}
}
