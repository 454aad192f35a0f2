#pragma once

#include "Parts.h"
#include "Progress.h"

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <exception>
#include <optional>
#include <thread>
#include <utility>
#include <vector>

namespace crossfield
{
/// Returns how many candidates of a search, each with a number of quads or triangles, are evaluated at
/// the same time: as many as there are threads, but one after the other if they are so large that loops
/// inside of them run in parts, since candidates need memory and some are evaluated in vain. The number
/// changes the time of a search, never its result.
std::size_t CandidateBatch(std::size_t elements);

/// Progress of parts that run at the same time: reports only what the thread that created it reports,
/// and never a smaller fraction than before. After an abort, the parts of all threads end with Aborted
/// at their next report.
class ProgressOfParts
{
public:
  explicit ProgressOfParts(const Progress& progress);
  ProgressOfParts(const ProgressOfParts&) = delete;
  ProgressOfParts& operator=(const ProgressOfParts&) = delete;

  /// Returns the reporter for the parts. This object must outlive it.
  Progress Get();

private:
  const Progress& Whole;
  const std::thread::id Creator = std::this_thread::get_id();
  std::atomic<bool> IsAborted{ false };
  double Last = 0.0;
};

/// Evaluates candidates, which must be independent of each other, in batches, and passes their results
/// to accept(i, result) in their order until it returns true. Returns whether it did.
///
/// Candidates of a batch are evaluated at the same time. With a batch of 1 no candidate after the
/// accepted one is evaluated; with any other the result is the same. An exception of a candidate is
/// rethrown when its turn comes, so one of a candidate after the accepted one is not.
template <typename Evaluate, typename Accept>
bool AcceptFirst(
  std::size_t count, std::size_t batch, const Evaluate& evaluate, const Accept& accept)
{
  using Result = decltype(evaluate(std::size_t()));
  for (std::size_t first = 0; first < count; first += batch)
  {
    const std::size_t size = std::min(batch, count - first);
    std::vector<std::optional<Result>> results(size);
    std::vector<std::exception_ptr> failures(size);
    ForParts(size,
      [&](std::size_t i)
      {
        try
        {
          results[i].emplace(evaluate(first + i));
        }
        catch (...)
        {
          failures[i] = std::current_exception();
        }
      });
    for (std::size_t i = 0; i < size; ++i)
    {
      if (failures[i])
      {
        std::rethrow_exception(failures[i]);
      }
      if (accept(first + i, std::move(*results[i])))
      {
        return true;
      }
    }
  }
  return false;
}
}
