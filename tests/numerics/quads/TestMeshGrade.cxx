// Which of two meshes of a request is better, and which mesh with fewer blocks may replace another one.

#include "MeshGrade.h"

#include <gtest/gtest.h>

namespace crossfield::test
{
namespace
{
QuadResult WithQuality(std::size_t blocks, double minimum, double mean, double variation)
{
  QuadResult result;
  result.blocks.blocks.resize(blocks);
  result.mesh.quads.resize(1000);
  result.quality.jacobian.min = minimum;
  result.quality.jacobian.mean = mean;
  result.quality.variation = variation;
  return result;
}

TEST(MeshGrade, ComparesInvertedThenCountThenShapeThenSizesThenBlocks)
{
  const auto grade = [](int inverted, double count, double shape, double variation,
                       std::size_t blocks) {
    return MeshGrade{ inverted, count, 0.0, shape, variation, blocks };
  };
  const MeshGrade best = grade(0, 0.0, 0.0, 0.0, 5);
  EXPECT_TRUE(best.IsGood());
  const MeshGrade others[] = { grade(0, 0.0, 0.0, 0.0, 6), grade(0, 0.0, 0.0, 0.1, 1),
    grade(0, 0.0, 0.1, 0.0, 1), grade(0, 0.1, 0.0, 0.0, 1), grade(1, 0.0, 0.0, 0.0, 1) };
  const MeshGrade* last = &best;
  for (const MeshGrade& other : others)
  {
    EXPECT_TRUE(*last < other);
    EXPECT_FALSE(other < *last);
    last = &other;
  }
  EXPECT_FALSE(best < best);
  const MeshGrade withoutArea{ 0, 0.0, 0.1, 0.0, 0.0, 1 };
  EXPECT_TRUE(others[2] < withoutArea);
  EXPECT_TRUE(withoutArea < others[3]);
  EXPECT_FALSE(withoutArea.IsGood());
  EXPECT_FALSE(others[1].IsGood());
  EXPECT_FALSE(others[2].IsGood());
  EXPECT_FALSE(others[4].IsGood());
}

TEST(MeshGrade, MeasuresWhatAMeshLacks)
{
  QuadResult quads = WithQuality(7, 0.54, 0.9, 0.2);
  quads.quality.bound = 0.9;
  const MeshGrade grade = GradeOf(quads, 0.0, 1250);
  EXPECT_NEAR(grade.count, 0.15, 1e-15); // 20 % less, 5 % are allowed
  EXPECT_NEAR(grade.shape, 0.2, 1e-15);
  EXPECT_NEAR(grade.variation, 0.08, 1e-15);
  EXPECT_EQ(grade.blocks, 7U);
  // A mesh that could be better lacks more; one that attains less has no merit.
  EXPECT_NEAR(GradeOf(quads, 0.0, 1250, 1.0).shape, 0.26, 1e-15);
  EXPECT_EQ(GradeOf(quads, 0.0, 1250, 0.5).shape, grade.shape);
  // A size prescribes no number, and 5 % are within the tolerance.
  EXPECT_EQ(CountExcess(quads, 0.1, 1250), 0.0);
  EXPECT_EQ(CountExcess(quads, 0.0, 1049), 0.0);
  EXPECT_GT(CountExcess(quads, 0.0, 1055), 0.0);
}

TEST(MeshGrade, AcceptsFewerBlocksWithinTheLimits)
{
  const QuadResult start = WithQuality(10, 0.9, 0.99, 0.2);
  const auto isAsClean = [](const QuadResult& quads, const QuadResult& other)
  { return IsAsClean(quads, other, 0.0, 1000); };
  EXPECT_TRUE(isAsClean(WithQuality(9, 0.881, 0.9881, 0.269), start));
  EXPECT_FALSE(isAsClean(WithQuality(9, 0.879, 0.99, 0.2), start));
  EXPECT_FALSE(isAsClean(WithQuality(9, 0.9, 0.9879, 0.2), start));
  EXPECT_FALSE(isAsClean(WithQuality(9, 0.9, 0.99, 0.271), start));
  // Uniform sizes may get 0.05 worse.
  EXPECT_TRUE(isAsClean(WithQuality(9, 0.9, 0.99, 0.059), WithQuality(10, 0.9, 0.99, 0.01)));
  QuadResult inverted = WithQuality(9, 0.9, 0.99, 0.2);
  inverted.quality.inverted = 1;
  EXPECT_FALSE(isAsClean(inverted, start));
  EXPECT_FALSE(IsAsGood(inverted.quality, start.quality, CoarseTolerance));
  QuadResult fewer = WithQuality(9, 0.9, 0.99, 0.2);
  fewer.mesh.quads.resize(900);
  EXPECT_FALSE(isAsClean(fewer, start));
  EXPECT_TRUE(IsAsClean(fewer, start, 0.1, 1000));
  // Merging on request may cost half of the worst quad, and nothing else counts.
  EXPECT_TRUE(IsAsGood(WithQuality(1, 0.451, 0.6, 3.0).quality, start.quality, CoarseTolerance));
  EXPECT_FALSE(IsAsGood(WithQuality(1, 0.449, 0.99, 0.2).quality, start.quality, CoarseTolerance));
}

TEST(MeshGrade, PrefersFewerBlocksThenTheBetterWorstQuad)
{
  const QuadResult start = WithQuality(10, 0.9, 0.99, 0.2);
  EXPECT_TRUE(IsCoarser(WithQuality(9, 0.5, 0.9, 0.2), start));
  EXPECT_TRUE(IsCoarser(WithQuality(10, 0.91, 0.9, 0.2), start));
  EXPECT_FALSE(IsCoarser(start, start));
  EXPECT_FALSE(IsCoarser(WithQuality(11, 1.0, 1.0, 0.0), start));
}
}
}
