#include "LoopTurning.h"

namespace crossfield
{
double TurningAt(const Loop& loop, std::size_t vertex)
{
  const Point& before = loop[(vertex + loop.size() - 1) % loop.size()];
  const Point& after = loop[(vertex + 1) % loop.size()];
  return AngleBetween(loop[vertex] - before, after - loop[vertex]);
}
}
