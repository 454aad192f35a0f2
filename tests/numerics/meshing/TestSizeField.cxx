#include "SizeField.h"
#include "Support.h"

#include <algorithm>
#include <chrono>
#include <limits>

namespace crossfield::test
{
namespace
{
struct Field
{
  std::vector<SizeSource> sources;
  double maximum = 1.0;
  double gradation = 0.25;
  Point lower;
  Point upper;

  SizeField Make() const
  {
    return SizeField(
      this->sources, this->maximum, this->gradation, Eigen::AlignedBox2d(this->lower, this->upper));
  }
  /// Evaluates the formula of SizeField.h.
  double BruteForce(const Point& point) const
  {
    double size = this->maximum;
    for (const SizeSource& source : this->sources)
    {
      size = std::min(size, source.size + this->gradation * (point - source.position).norm());
    }
    return size;
  }
};

Field RandomField(Random& random, int sourceCount)
{
  Field field;
  field.lower = { random.Uniform(-3.0, 0.0), random.Uniform(-3.0, 0.0) };
  field.upper = field.lower + Point(random.Uniform(0.5, 4.0), random.Uniform(0.5, 4.0));
  field.gradation = random.Uniform(0.05, 1.0);
  field.maximum = std::exp(random.Uniform(std::log(0.02), std::log(2.0)));
  for (int i = 0; i < sourceCount; ++i)
  {
    // Sizes over several orders of magnitude, some above the maximum, some sources outside.
    field.sources.push_back({ { random.Uniform(-4.0, 2.0), random.Uniform(-4.0, 2.0) },
      std::exp(random.Uniform(std::log(1e-4), std::log(3.0))) });
  }
  return field;
}

Point RandomPoint(Random& random, const Field& field)
{
  return { random.Uniform(field.lower.x(), field.upper.x()),
    random.Uniform(field.lower.y(), field.upper.y()) };
}

TEST(SizeField, EqualsTheFormulaAtRandomPoints)
{
  Random random(4);
  for (int trial = 0; trial < 60; ++trial)
  {
    SCOPED_TRACE(trial);
    const Field field = RandomField(random, trial % 3 == 0 ? trial : 5 * trial);
    const SizeField size = field.Make();
    for (int i = 0; i < 500; ++i)
    {
      const Point point = RandomPoint(random, field);
      ASSERT_DOUBLE_EQ(size(point), field.BruteForce(point)) << point.transpose();
    }
    // Test also at the sources, where the leaves are smallest.
    for (const SizeSource& source : field.sources)
    {
      const Point point = source.position.cwiseMax(field.lower).cwiseMin(field.upper);
      ASSERT_DOUBLE_EQ(size(point), field.BruteForce(point));
    }
    for (const Point& corner : { field.lower, field.upper })
    {
      ASSERT_DOUBLE_EQ(size(corner), field.BruteForce(corner));
    }
  }
}

TEST(SizeField, GrowsByNoMoreThanTheGradation)
{
  Random random(5);
  const Field field = RandomField(random, 100);
  const SizeField size = field.Make();
  for (int i = 0; i < 5000; ++i)
  {
    const Point a = RandomPoint(random, field);
    const Point b = RandomPoint(random, field);
    EXPECT_LE(std::abs(size(a) - size(b)), field.gradation * (a - b).norm() + 1e-14);
    EXPECT_LE(size(a), field.maximum);
  }
}

TEST(SizeField, WithoutSourcesIsTheMaximumEverywhere)
{
  Field field;
  field.lower = { -1.0, -1.0 };
  field.upper = { 1.0, 1.0 };
  EXPECT_EQ(field.Make()({ 0.3, -0.2 }), field.maximum);
  field.sources.push_back({ { 0.0, 0.0 }, 2.0 });
  EXPECT_EQ(field.Make()({ 0.0, 0.0 }), field.maximum);
}

TEST(SizeField, LeavesTileTheBoxAndHaveItsValues)
{
  Random random(6);
  for (int trial = 0; trial < 20; ++trial)
  {
    const Field field = RandomField(random, 10 * trial);
    const SizeField size = field.Make();
    double area = 0.0;
    for (const SizeField::Leaf& leaf : size.Leaves())
    {
      area += leaf.box.volume();
      EXPECT_TRUE((leaf.box.min().array() >= field.lower.array() - 1e-12).all());
      EXPECT_TRUE((leaf.box.max().array() <= field.upper.array() + 1e-12).all());
      const Point inside = leaf.box.sample();
      EXPECT_DOUBLE_EQ(leaf.SizeAt(inside), field.BruteForce(inside));
    }
    const double boxArea = (field.upper - field.lower).prod();
    EXPECT_NEAR(area, boxArea, 1e-10 * boxArea);
  }
}

TEST(SizeField, HandlesManyCoincidentSources)
{
  // A thousand coincident sources must not multiply through the tree.
  Field field;
  field.lower = { -1.0, -1.0 };
  field.upper = { 1.0, 1.0 };
  field.sources.assign(1000, { { 0.1, 0.2 }, 1e-6 });
  const auto start = std::chrono::steady_clock::now();
  const SizeField size = field.Make();
  const double seconds =
    std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  EXPECT_LT(seconds, 5.0);
  EXPECT_DOUBLE_EQ(size({ 0.1, 0.2 }), 1e-6);
}

TEST(SizeField, RefusesASizeOrGradationThatIsNotPositive)
{
  for (const double bad : { 0.0, -1.0, std::numeric_limits<double>::quiet_NaN() })
  {
    Field field;
    field.lower = { -1.0, -1.0 };
    field.upper = { 1.0, 1.0 };
    field.maximum = bad;
    EXPECT_TRUE(Refuses([&] { field.Make(); }, { "must be positive" }));
    field.maximum = 1.0;
    field.gradation = bad;
    EXPECT_TRUE(Refuses([&] { field.Make(); }, { "gradation", "must be positive" }));
  }
}
}
}
