#include "SeparatrixTies.h"

#include <algorithm>
#include <cmath>

namespace crossfield
{
namespace
{
/// A position on a separatrix; for two that meet head-on, on the first of them.
struct PathPosition
{
  int line = 0;
  double at = 0.0;
};

PathPosition PositionOnPath(const TraceGraph& graph, int line, double at)
{
  const TracedSeparatrix& separatrix = graph.separatrices[line];
  return separatrix.end == SeparatrixEnd::HeadOn && separatrix.other < line
    ? PathPosition{ separatrix.other, separatrix.headOnLength - at }
    : PathPosition{ line, at };
}
}

std::vector<SeparatrixTie> FindTies(const TraceGraph& graph, double reach)
{
  struct Stop
  {
    int line = 0;
    PathPosition place; ///< On the path at which it stops.
  };
  std::vector<Stop> stops;
  for (std::size_t i = 0; i < graph.separatrices.size(); ++i)
  {
    const TracedSeparatrix& line = graph.separatrices[i];
    if (line.end == SeparatrixEnd::Line && std::abs(line.length - line.otherLength) <= reach)
    {
      stops.push_back({ static_cast<int>(i), PositionOnPath(graph, line.other, line.otherLength) });
    }
  }
  std::vector<SeparatrixTie> ties;
  for (const Stop& stop : stops)
  {
    const TracedSeparatrix& line = graph.separatrices[stop.line];
    const TracedSeparatrix& other = graph.separatrices[line.other];
    const bool isAtMeeting = other.end == SeparatrixEnd::HeadOn &&
      std::abs(line.otherLength - 0.5 * other.headOnLength) <= reach;
    const auto there = std::count_if(stops.begin(), stops.end(),
      [&](const Stop& another)
      {
        return another.place.line == stop.place.line &&
          std::abs(another.place.at - stop.place.at) <= reach;
      });
    if (there == 1 && !isAtMeeting)
    {
      ties.push_back({ { stop.line, line.other }, { line.length, line.otherLength }, {} });
    }
  }
  return ties;
}
}
