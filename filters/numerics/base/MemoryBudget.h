#pragma once

#include "ControlGroups.h"

#include <optional>
#include <string>

namespace crossfield
{
/// Returns the number of bytes that this process may still allocate: the minimum of the machine's
/// MemAvailable, of what the limits of its control groups (versions 1 and 2) leave besides page
/// cache, and of what RLIMIT_AS leaves. Swap does not count. Returns nothing if none of them is
/// known, as on systems other than Linux.
std::optional<double> AvailableMemory(const SystemFiles& files = {});

/// Throws Error "<what> would need about … GiB of memory, more than the … GiB available; <remedy>."
/// if `bytes` exceeds the available memory.
///
/// Linux grants more memory than there is and kills the process that uses it, so std::bad_alloc is
/// thrown too late or never. Large stages therefore call this function before they allocate.
void RequireMemory(double bytes, const std::string& what, const std::string& remedy);

/// Message for std::bad_alloc, when memory runs out in spite of these checks.
extern const char* const OutOfMemory;

/// Message for EAGAIN, when a library cannot start a thread: there is no memory for its stack, or
/// the number of threads is limited.
extern const char* const OutOfThreads;
}
