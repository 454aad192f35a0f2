// Arcs of drawings whose truth is known are found; profiles have none.

#include "ArcRecognition.h"

#include "Support.h"

#include <algorithm>
#include <cmath>
#include <random>

namespace crossfield::test
{
namespace
{
/// A polygon whose corners are rounded, and the radii of its arcs in order.
struct Drawing
{
  Loop loop;
  std::vector<double> radii;
  std::vector<std::size_t> segments; ///< Per arc.
};

/// Returns a random polygon with corners rounded by arcs of at least 35°.
Drawing RandomDrawing(unsigned int seed)
{
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  const int corners =
    3 + static_cast<int>(7.0 * unit(random)); // up to 9, which turn by 40° on average
  Loop polygon;
  for (int i = 0; i < corners; ++i)
  {
    const double angle = 2.0 * Pi * (i + 0.1 * unit(random)) / corners;
    polygon.emplace_back(std::cos(angle), std::sin(angle));
  }
  Drawing drawing;
  const double shift = 2.0 * Pi * unit(random);
  for (int i = 0; i < corners; ++i)
  {
    const Point& corner = polygon[static_cast<std::size_t>(i)];
    const Point in = (corner - polygon[static_cast<std::size_t>((i + corners - 1) % corners)]);
    const Point out = (polygon[static_cast<std::size_t>((i + 1) % corners)] - corner);
    const double turn = AngleBetween(in, out);
    const double room = 0.45 * std::min(in.norm(), out.norm());
    const double cut = room * (0.1 + 0.9 * unit(random));
    if (turn < Pi * 35.0 / 180.0 || unit(random) < 0.2)
    {
      drawing.loop.push_back(corner); // stays sharp
      continue;
    }
    const double radius = cut / std::tan(0.5 * turn);
    const auto segments = static_cast<std::size_t>(4 + 30.0 * unit(random));
    const Point start = corner - cut * in.normalized();
    const Point centre = start + radius * Point(-in.y(), in.x()).normalized();
    for (std::size_t k = 0; k <= segments; ++k)
    {
      const double angle = turn * static_cast<double>(k) / static_cast<double>(segments);
      const Point offset = start - centre;
      drawing.loop.push_back(centre +
        Point(std::cos(angle) * offset.x() - std::sin(angle) * offset.y(),
          std::sin(angle) * offset.x() + std::cos(angle) * offset.y()));
    }
    drawing.radii.push_back(radius);
    drawing.segments.push_back(segments);
  }
  for (Point& point : drawing.loop)
  {
    point = Point(std::cos(shift) * point.x() - std::sin(shift) * point.y(),
      std::sin(shift) * point.x() + std::cos(shift) * point.y());
  }
  return drawing;
}

/// Returns the points of a NACA profile of four digits, `count` on each side, from the trailing
/// edge over the lower side to the nose and back.
Loop Profile(double camber, double place, double thickness, int count, bool isBlunt)
{
  Loop upper;
  Loop lower;
  for (int i = 0; i <= count; ++i)
  {
    const double x = 0.5 * (1.0 - std::cos(Pi * i / count)); // denser at both ends
    const double half = 5.0 * thickness *
      (0.2969 * std::sqrt(x) - 0.1260 * x - 0.3516 * x * x + 0.2843 * x * x * x -
        (isBlunt ? 0.1015 : 0.1036) * x * x * x * x);
    const bool isFront = x < place;
    const double scale = isFront ? place * place : (1.0 - place) * (1.0 - place);
    const double line = camber == 0.0
      ? 0.0
      : camber / scale * ((isFront ? 0.0 : 1.0 - 2.0 * place) + 2.0 * place * x - x * x);
    const double slope = camber == 0.0 ? 0.0 : 2.0 * camber / scale * (place - x);
    const double angle = std::atan(slope);
    upper.emplace_back(x - half * std::sin(angle), line + half * std::cos(angle));
    lower.emplace_back(x + half * std::sin(angle), line - half * std::cos(angle));
  }
  Loop loop(upper.rbegin(), upper.rend());
  loop.insert(loop.end(), lower.begin() + 1, isBlunt ? lower.end() : lower.end() - 1);
  return loop;
}

TEST(ArcRecognition, FindsTheArcsOfFortyDrawings)
{
  int arcs = 0;
  for (unsigned int seed = 1000; seed < 1040; ++seed)
  {
    const Drawing drawing = RandomDrawing(seed);
    const std::vector<RecognisedArc> found = FindArcs(drawing.loop);
    ASSERT_EQ(found.size(), drawing.radii.size()) << "seed " << seed;
    // The search may begin at any vertex.
    std::vector<std::pair<std::size_t, double>> truth;
    std::vector<std::pair<std::size_t, double>> result;
    for (std::size_t i = 0; i < found.size(); ++i)
    {
      truth.emplace_back(drawing.segments[i], drawing.radii[i]);
      result.emplace_back(found[i].count, found[i].circle.axis.norm());
    }
    std::sort(truth.begin(), truth.end());
    std::sort(result.begin(), result.end());
    for (std::size_t i = 0; i < truth.size(); ++i)
    {
      EXPECT_EQ(result[i].first, truth[i].first) << "seed " << seed;
      EXPECT_NEAR(result[i].second, truth[i].second, 1e-10) << "seed " << seed;
      ++arcs;
    }
  }
  EXPECT_GT(arcs, 100);
}

TEST(ArcRecognition, FindsArcsInSinglePrecision)
{
  for (unsigned int seed = 1100; seed < 1110; ++seed)
  {
    Drawing drawing = RandomDrawing(seed);
    for (Point& point : drawing.loop)
    {
      point = point.cast<float>().cast<double>();
    }
    EXPECT_EQ(FindArcs(drawing.loop).size(), drawing.radii.size()) << "seed " << seed;
  }
}

TEST(ArcRecognition, DoesNotDependOnTheFirstVertex)
{
  Loop slot; // two half circles of sixteen segments
  for (int i = 0; i <= 33; ++i)
  {
    const double angle = Pi * (i - (i < 17 ? 0 : 1)) / 16.0 - 0.5 * Pi;
    slot.emplace_back((i < 17 ? 1.0 : -1.0) + 0.5 * std::cos(angle), 0.5 * std::sin(angle));
  }
  for (std::size_t first = 0; first < slot.size(); ++first)
  {
    const std::vector<RecognisedArc> arcs = FindArcs(slot, DefaultCornerAngle);
    ASSERT_EQ(arcs.size(), 2U) << first;
    EXPECT_EQ(arcs[0].count, 16U) << first;
    EXPECT_EQ(arcs[1].count, 16U) << first;
    std::rotate(slot.begin(), slot.begin() + 1, slot.end());
  }
}

TEST(ArcRecognition, FindsWholeCircles)
{
  Loop loop;
  for (int i = 0; i < 16; ++i)
  {
    loop.emplace_back(std::cos(2.0 * Pi * i / 16), -std::sin(2.0 * Pi * i / 16));
  }
  const std::vector<RecognisedArc> found = FindArcs(loop);
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].count, 16U);
}

TEST(ArcRecognition, InventsNoneOnProfiles)
{
  for (const auto& [camber, place, thickness] : { std::array<double, 3>{ 0.0, 0.4, 0.12 },
         { 0.0, 0.4, 0.06 }, { 0.02, 0.4, 0.12 }, { 0.04, 0.4, 0.15 }, { 0.06, 0.3, 0.09 } })
  {
    for (int count = 15; count <= 250; count += 5) // on each side
    {
      for (const bool isBlunt : { false, true })
      {
        const Loop loop = Profile(camber, place, thickness, count, isBlunt);
        EXPECT_TRUE(FindArcs(loop).empty()) << camber << " " << thickness << " " << count;
      }
    }
  }
}

TEST(ArcRecognition, AnEllipseHasNone)
{
  for (const int count : { 24, 100, 400 })
  {
    Loop loop;
    for (int i = 0; i < count; ++i)
    {
      loop.emplace_back(2.0 * std::cos(2.0 * Pi * i / count), std::sin(2.0 * Pi * i / count));
    }
    EXPECT_TRUE(FindArcs(loop).empty());
  }
}
}
}
