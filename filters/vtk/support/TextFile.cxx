#include "TextFile.h"

#include "Error.h"

#include <cstdio>
#include <filesystem>
#include <fstream>
#include <unistd.h>

namespace
{
namespace fs = std::filesystem;

/** Returns whether a file is a device or pipe, which cannot be replaced. */
bool IsStream(const std::string& file)
{
  std::error_code failed;
  const fs::file_status status = fs::status(file, failed);
  return fs::exists(status) && status.type() != fs::file_type::regular;
}

std::string PartOf(const std::string& file)
{
  return IsStream(file) ? file : file + ".part" + std::to_string(getpid());
}

bool WritePart(const std::string& file, const std::string& text)
{
  std::ofstream stream(PartOf(file), std::ios::binary);
  stream << text;
  stream.close();
  return static_cast<bool>(stream);
}
}

namespace TextFile
{
//------------------------------------------------------------------------------
void Write(const std::vector<std::pair<std::string, std::string>>& files)
{
  std::string failed;
  for (const auto& [file, text] : files)
  {
    if (failed.empty() && !WritePart(file, text))
    {
      failed = file;
    }
  }
  for (const auto& [file, text] : files)
  {
    const std::string part = PartOf(file);
    if (part == file)
    {
      continue;
    }
    if (failed.empty() && std::rename(part.c_str(), file.c_str()) != 0)
    {
      failed = file;
    }
    if (!failed.empty())
    {
      std::remove(part.c_str());
    }
  }
  if (!failed.empty())
  {
    throw crossfield::Error(
      "The file '" + failed + "' cannot be written; check the folder and the free space.");
  }
}
}
