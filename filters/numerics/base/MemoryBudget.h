#pragma once

#include <optional>
#include <string>

namespace crossfield
{
/// Where the limits of memory are read; other folders are for tests.
struct MemoryLimitFiles
{
  std::string process = "/proc";
  std::string controlGroups = "/sys/fs/cgroup";
};

/// Bytes that this process may still take: the least of MemAvailable of the machine, of what the
/// limits of its control groups (versions 1 and 2) leave beside page cache, and of what RLIMIT_AS
/// leaves. Swap does not count. Nothing where none of them is known, as on other systems than Linux.
std::optional<double> AvailableMemory(const MemoryLimitFiles& files = {});

/// Throws Error "<what> would need about … GiB of memory, more than the … GiB available; <mend>."
/// when so many bytes are more than those available. Linux grants more memory than there is and
/// kills whoever uses it: std::bad_alloc comes too late or never, so large stages ask beforehand.
void RequireMemory(double bytes, const std::string& what, const std::string& mend);

/// What is said when memory runs out nevertheless (std::bad_alloc).
extern const char* const OutOfMemory;

/// What is said when the system refuses a thread that a library asks for (EAGAIN): its stack finds no
/// memory, or the number of threads is limited.
extern const char* const OutOfThreads;
}
