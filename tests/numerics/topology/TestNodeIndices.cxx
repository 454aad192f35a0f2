// Quarter indices of regions at their nodes.

#include "NodeIndices.h"

#include "Plane.h"

#include <gtest/gtest.h>

namespace crossfield::test
{
namespace
{
std::vector<int> IndicesAt(const std::vector<double>& degrees, bool isOnBoundary)
{
  NodeCorners node;
  node.isOnBoundary = isOnBoundary;
  for (const double angle : degrees)
  {
    node.corners.push_back(
      { static_cast<int>(node.corners.size()), angle * Pi / 180.0, std::nullopt });
  }
  return ChooseNodeIndices({ node }, std::vector<int>(degrees.size(), 1))[0];
}

TEST(NodeIndices, AreChosenTogether)
{
  EXPECT_EQ(IndicesAt({ 120, 120, 120 }, false), (std::vector<int>{ 1, 1, 1 }));
  EXPECT_EQ(IndexOfNode({ 1, 1, 1 }, false), 1);
  EXPECT_EQ(IndicesAt({ 70, 110, 70, 110 }, false), (std::vector<int>{ 1, 1, 1, 1 }));
  EXPECT_EQ(IndexOfNode({ 1, 1, 1, 1 }, false), 0);
  EXPECT_EQ(IndicesAt({ 60, 120 }, true), (std::vector<int>{ 1, 1 }));
  EXPECT_EQ(IndexOfNode({ 1, 1 }, true), 0);
  EXPECT_EQ(IndicesAt({ 90, 90, 180 }, false), (std::vector<int>{ 1, 1, 0 }));
  EXPECT_EQ(IndicesAt({ 90, 270 }, false), (std::vector<int>{ 1, -1 }));
}

TEST(NodeIndices, SpareIrregularNodes)
{
  // A region without singularities of its own gives the fourth quad; only one of the three does.
  NodeCorners node;
  node.corners = { { 0, 2.0 * Pi / 3.0, std::nullopt }, { 1, 2.0 * Pi / 3.0, std::nullopt },
    { 2, 2.0 * Pi / 3.0, std::nullopt } };
  const std::vector<int> indices = ChooseNodeIndices({ node }, { 1, 0, 1 })[0];
  EXPECT_EQ(indices, (std::vector<int>{ 1, 0, 1 }));
  node.corners[1].prescribed = 1;
  EXPECT_EQ(ChooseNodeIndices({ node }, { 1, 0, 1 })[0], (std::vector<int>{ 1, 1, 1 }));
}
}
}
