#pragma once

#include <functional>
#include <optional>
#include <string>

namespace crossfield
{
/// Folders from which the limits of this process are read; tests use other ones.
struct SystemFiles
{
  std::string process = "/proc";
  std::string controlGroups = "/sys/fs/cgroup";
};

/// Calls function(folder, version) for the control groups of this process that have a controller
/// ("memory", "cpu"), and for their ancestors. Version is 1 or 2. In a container the path of the
/// group is often not visible, but its root is, so folders need not exist.
void ForControlGroups(const SystemFiles& files, const std::string& controller,
  const std::function<void(const std::string& folder, int version)>& function);

/// Returns the number at the beginning of a file; nothing if the file does not exist or begins with
/// "max", the kernel's word for no limit.
std::optional<double> ReadNumber(const std::string& file);
}
