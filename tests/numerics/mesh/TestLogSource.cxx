#include "LogSource.h"

#include "Support.h"

#include <cmath>
#include <limits>

namespace crossfield::test
{
namespace
{
/// Returns sources within a square, some much closer to its centre than others.
std::vector<LogSource> RandomSources(Random& random, int count, double size)
{
  std::vector<LogSource> logs;
  for (int i = 0; i < count; ++i)
  {
    const double reach = i % 3 == 0 ? 1e-6 * size : size;
    const int strength = random.Integer(1, 6) * (random.Integer(0, 1) == 0 ? 1 : -1);
    logs.push_back({ reach * Point(random.Uniform(-1.0, 1.0), random.Uniform(-1.0, 1.0)),
      static_cast<double>(strength), 2.0 * Pi });
  }
  return logs;
}

TEST(LogSource, SumOfLogsEqualsSingleLogarithmsAtAllExtents)
{
  for (const double size : { 1e-60, 1e-40, 1e-20, 1.0, 1e20, 1e40, 1e60 })
  {
    SCOPED_TRACE(size);
    Random random(5);
    for (const int count : { 1, 2, 5, 40 })
    {
      std::vector<LogSource> logs = RandomSources(random, count, size);
      double sum = 0.0;
      double largest = 0.0;
      std::complex<double> turns = 1.0;
      for (const LogSource& log : logs)
      {
        sum += log.Value(Point::Zero());
        largest += std::abs(log.Value(Point::Zero()));
        turns *= std::polar(1.0, log.strength * std::atan2(-log.position.y(), -log.position.x()));
      }
      EXPECT_LT(std::abs(UnitOfTurns(logs, logs.size(), Point::Zero()) - turns), 1e-12);
      EXPECT_NEAR(SumOfLogs(logs, Point::Zero()), sum, 1e-14 * largest);
      logs.push_back({ Point(size, size), 0.37, 0.5 * Pi }); // a source at a corner
      EXPECT_NEAR(
        SumOfLogs(logs, Point::Zero()), sum + logs.back().Value(Point::Zero()), 1e-14 * largest);
    }
  }
}

TEST(LogSource, SumOfTurnsEqualsSingleTurnsAtAllExtents)
{
  for (const double size : { 1e-60, 1e-40, 1e-20, 1.0, 1e20, 1e40, 1e60 })
  {
    SCOPED_TRACE(size);
    Random random(6);
    for (const int count : { 0, 1, 2, 5, 40, 300 })
    {
      std::vector<LogSource> logs = RandomSources(random, count, size);
      logs.push_back({ Point(size, size), 0.37, 0.5 * Pi }); // a source at a corner
      for (const double step : { 1e-8, 0.1, 1.0 }) // seen under small and under obtuse angles
      {
        const auto place = [&]
        { return Point(random.Uniform(-1.0, 1.0), random.Uniform(-1.0, 1.0)); };
        const Point from = size * place();
        const Point to = from + step * size * place();
        double sum = 0.0;
        double most = 1.0;
        for (const LogSource& log : logs)
        {
          sum += log.strength * log.Turn(from, to);
          most += std::abs(log.strength);
        }
        EXPECT_NEAR(
          SumOfTurns(logs.data(), logs.data() + logs.size(), from, to), sum, 1e-14 * most);
      }
    }
  }
}

TEST(LogSource, SumOfLogsIsInfiniteAtASourceThatTurnsIgnore)
{
  const std::vector<LogSource> logs = { { { 0.3, 0.4 }, 2.0, 2.0 * Pi },
    { { 0.0, 0.0 }, 1.0, 2.0 * Pi }, { { -1.0, 0.5 }, 1.0, 2.0 * Pi } };
  EXPECT_EQ(SumOfLogs(logs, Point::Zero()), -std::numeric_limits<double>::infinity());
  const std::complex<double> turns = UnitOfTurns(logs, 3, Point::Zero());
  EXPECT_LT(
    std::abs(turns - std::polar(1.0, 2.0 * std::atan2(-0.4, -0.3) + std::atan2(-0.5, 1.0))), 1e-14);
}
}
}
