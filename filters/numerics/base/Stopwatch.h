#pragma once

#include <chrono>

namespace crossfield
{
/// Stopwatch for wall-clock time. Lap() returns the seconds since the previous call or the
/// construction.
class Stopwatch
{
public:
  double Lap()
  {
    const auto now = std::chrono::steady_clock::now();
    const double seconds = std::chrono::duration<double>(now - this->Last).count();
    this->Last = now;
    return seconds;
  }

private:
  std::chrono::steady_clock::time_point Last = std::chrono::steady_clock::now();
};
}
