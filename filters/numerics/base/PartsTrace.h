#pragma once

#include <cstddef>
#include <functional>
#include <vector>

namespace crossfield
{
/// Processor time of a computation by its parts (Parts.h): serial sections, each followed by parts
/// that may run in parallel. Shows how a computation would scale on a machine with more processors
/// than this one has.
class PartsTrace
{
public:
  /// Calls `function` and records it. All parts run in the calling thread, one after the other, so
  /// that their times do not disturb each other. Searches evaluate as many candidates at the same
  /// time as on a machine with this number of processors.
  explicit PartsTrace(const std::function<void()>& function, int processors = 1);
  PartsTrace(const PartsTrace&) = delete;
  PartsTrace& operator=(const PartsTrace&) = delete;

  /// Returns the seconds of all parts together.
  double TotalSeconds() const;
  /// Returns the seconds on an ideal machine with the given number of processors, each of which
  /// takes the next part that is ready: no overhead, and memory as fast for all as for one.
  double SecondsOn(int processors) const;
  /// Returns the seconds outside of all parts.
  double SerialSeconds() const;

  int Processors() const { return this->ProcessorCount; }

  /// Returns the trace of which the calling thread is part, or null.
  static PartsTrace* Active();
  /// Runs and records parts; ForParts calls it.
  void Run(std::size_t parts, const std::function<void(std::size_t)>& function);

private:
  /// A serial section and the parts that follow it; the last section of a part has none.
  struct Work;
  struct Section
  {
    double seconds = 0.0;
    std::vector<Work> parts;
  };
  struct Work
  {
    std::vector<Section> sections;
  };
  struct Schedule;

  /// Ends the present serial section.
  void EndSection();

  int ProcessorCount;
  Work Root;
  Work* Present = &Root;
  double Begin = 0.0; ///< Processor time of this thread at the start of the present section.
};
}
