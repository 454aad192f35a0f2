#include "MemoryBudget.h"

#include "Error.h"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <sstream>

#if __has_include(<sys/resource.h>) && __has_include(<unistd.h>)
#include <sys/resource.h>
#include <unistd.h>
#endif

namespace crossfield
{
namespace
{
constexpr double GiB = 1024.0 * 1024.0 * 1024.0;

/// Bytes for which RequireMemory does not read the limits, which takes as long as a small problem: a
/// search solves thousands of these. The libraries of a process take more.
constexpr double AlwaysAvailable = 16.0 * 1024.0 * 1024.0;

void Lower(std::optional<double>& minimum, double bytes)
{
  minimum = std::max(0.0, minimum.has_value() ? std::min(*minimum, bytes) : bytes);
}

/// Returns the number that follows a key at the beginning of a line.
std::optional<double> ReadValue(const std::string& file, const std::string& key)
{
  std::ifstream stream(file);
  for (std::string line; std::getline(stream, line);)
  {
    std::istringstream words(line);
    std::string word;
    double number = 0.0;
    if (words >> word >> number && word == key)
    {
      return number;
    }
  }
  return std::nullopt;
}

/// Applies the limit of one control group. Page cache does not count as used, because the kernel
/// reclaims it when memory is needed.
void LowerToGroup(std::optional<double>& minimum, const std::string& folder,
  const std::string& limit, const std::string& usage, const std::string& cachePrefix)
{
  const std::optional<double> limitBytes = ReadNumber(folder + "/" + limit);
  const std::optional<double> used = ReadNumber(folder + "/" + usage);
  if (limitBytes.has_value() && used.has_value())
  {
    const auto cache = [&](const char* key)
    { return ReadValue(folder + "/memory.stat", cachePrefix + key).value_or(0.0); };
    Lower(minimum, *limitBytes - (*used - cache("inactive_file") - cache("active_file")));
  }
}

void LowerToControlGroups(std::optional<double>& minimum, const SystemFiles& files)
{
  ForControlGroups(files, "memory",
    [&minimum](const std::string& folder, int version)
    {
      if (version == 2)
      {
        LowerToGroup(minimum, folder, "memory.max", "memory.current", "");
      }
      else
      {
        LowerToGroup(minimum, folder, "memory.limit_in_bytes", "memory.usage_in_bytes", "total_");
      }
    });
}

/// Address space reserved for OpenBLAS, which allocates a buffer for each thread that calls it and
/// retries for ever when a limit on the address space denies it, and for stacks of the default size:
/// for the thread that computes, the only one with such a limit (ThreadLimit.h), and one of the host.
constexpr double ThreadReserve = 2.0 * (128.0 + 8.0) * 1024.0 * 1024.0;

void LowerToAddressSpace(std::optional<double>& minimum, const SystemFiles& files)
{
#ifdef RLIMIT_AS
  rlimit limit = {};
  const std::optional<double> pages = ReadNumber(files.process + "/self/statm");
  if (pages.has_value() && getrlimit(RLIMIT_AS, &limit) == 0 && limit.rlim_cur != RLIM_INFINITY)
  {
    Lower(minimum,
      static_cast<double>(limit.rlim_cur) - *pages * static_cast<double>(sysconf(_SC_PAGESIZE)) -
        ThreadReserve);
  }
#else
  (void)minimum;
  (void)files;
#endif
}
}

const char* const OutOfMemory =
  "There is not enough memory for this mesh; use a larger mesh size or fewer holes.";

const char* const OutOfThreads =
  "A thread could not be started: there is not enough memory for it, or their number is limited; "
  "use a larger mesh size, or raise the limit.";

std::optional<double> AvailableMemory(const SystemFiles& files)
{
  std::optional<double> minimum;
  if (const auto kilobytes = ReadValue(files.process + "/meminfo", "MemAvailable:"))
  {
    Lower(minimum, *kilobytes * 1024.0);
  }
  LowerToControlGroups(minimum, files);
  LowerToAddressSpace(minimum, files);
  return minimum;
}

void RequireMemory(double bytes, const std::string& what, const std::string& remedy)
{
  if (bytes <= AlwaysAvailable)
  {
    return;
  }
  const std::optional<double> available = AvailableMemory();
  if (available.has_value() && !(bytes <= *available))
  {
    std::ostringstream text;
    text.precision(3);
    text << what << " would need about " << bytes / GiB << " GiB of memory, more than the "
         << *available / GiB << " GiB available; " << remedy << ".";
    throw Error(text.str());
  }
}
}
