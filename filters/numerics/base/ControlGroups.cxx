#include "ControlGroups.h"

#include <fstream>

namespace crossfield
{
void ForControlGroups(const SystemFiles& files, const std::string& controller,
  const std::function<void(const std::string& folder, int version)>& function)
{
  std::ifstream groups(files.process + "/self/cgroup");
  for (std::string line; std::getline(groups, line);) // number:controllers:/path
  {
    const auto first = line.find(':');
    const auto second = line.find(':', first + 1);
    if (first == std::string::npos || second == std::string::npos)
    {
      continue;
    }
    const std::string controllers = "," + line.substr(first + 1, second - first - 1) + ",";
    const int version = controllers == ",," ? 2 : 1;
    if (version == 1 && controllers.find("," + controller + ",") == std::string::npos)
    {
      continue;
    }
    const std::string root = files.controlGroups + (version == 1 ? "/" + controller : "");
    std::string path = line.substr(second + 1);
    path.erase(0, path.find('/') == 0 ? 0 : path.size());
    path.erase(path.find_last_not_of('/') + 1);
    for (;;)
    {
      function(root + path, version);
      if (path.empty())
      {
        break;
      }
      path.erase(path.find_last_of('/'));
    }
  }
}

std::optional<double> ReadNumber(const std::string& file)
{
  std::ifstream stream(file);
  double number = 0.0;
  return stream >> number ? std::optional<double>(number) : std::nullopt;
}
}
