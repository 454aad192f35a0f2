#include "TextFile.h"

#include "Error.h"

#include <cstdio>
#include <filesystem>
#include <fstream>
#include <unistd.h>

namespace TextFile
{
//------------------------------------------------------------------------------
void Write(const std::string& text, const std::string& file)
{
  std::error_code failed;
  const std::filesystem::file_status status = std::filesystem::status(file, failed);
  const bool isStream = std::filesystem::exists(status) &&
    status.type() !=
      std::filesystem::file_type::regular; // a device or pipe, which cannot be replaced
  const std::string part = isStream ? file : file + ".part" + std::to_string(getpid());
  std::ofstream stream(part, std::ios::binary);
  stream << text;
  stream.close();
  if (!stream || (!isStream && std::rename(part.c_str(), file.c_str()) != 0))
  {
    if (!isStream)
    {
      std::remove(part.c_str());
    }
    throw crossfield::Error(
      "The file '" + file + "' cannot be written; check the folder and the free space.");
  }
}
}
