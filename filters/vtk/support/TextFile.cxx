#include "TextFile.h"

#include "Error.h"

#include <filesystem>
#include <fstream>
#include <unistd.h>

namespace
{
namespace fs = std::filesystem;

/** A file and where its new contents are until all are written. */
struct Target
{
  fs::path place; ///< After links are followed.
  fs::path part;  ///< The place itself for a device or pipe, which cannot be replaced.
};

Target TargetOf(const std::string& file)
{
  std::error_code failed;
  const fs::file_status status = fs::status(file, failed);
  const fs::path place = fs::exists(status) ? fs::canonical(file, failed) : fs::path(file);
  const bool isStream = fs::exists(status) && status.type() != fs::file_type::regular;
  return { place,
    isStream ? place : fs::path(place.string() + ".part" + std::to_string(getpid())) };
}

/** Makes the folder of a file and its parents if they are missing, and adds those that it made. */
void MakeFolder(const std::string& file, std::vector<fs::path>& made)
{
  std::error_code failed;
  fs::path path;
  for (const fs::path& name : fs::absolute(file, failed).parent_path())
  {
    path /= name;
    if (!failed && fs::create_directory(path, failed))
    {
      made.push_back(path);
    }
  }
}

bool WritePart(const Target& target, const std::string& text)
{
  std::ofstream stream(target.part, std::ios::binary);
  stream << text;
  stream.close();
  std::error_code failed;
  const fs::file_status old = fs::status(target.place, failed);
  if (stream && target.part != target.place && fs::exists(old))
  {
    fs::permissions(target.part, old.permissions(), failed);
  }
  return static_cast<bool>(stream);
}
}

namespace TextFile
{
//------------------------------------------------------------------------------
void Write(const std::vector<std::pair<std::string, std::string>>& files, bool makeFolders)
{
  std::string failed;
  std::vector<Target> targets;
  std::vector<fs::path> made;
  for (const auto& [file, text] : files)
  {
    if (makeFolders)
    {
      MakeFolder(file, made);
    }
    targets.push_back(TargetOf(file));
    if (failed.empty() && !WritePart(targets.back(), text))
    {
      failed = file;
    }
  }
  for (std::size_t i = 0; i < files.size(); ++i)
  {
    const Target& target = targets[i];
    std::error_code error;
    if (failed.empty() && target.part != target.place)
    {
      fs::rename(target.part, target.place, error);
      failed = error ? files[i].first : failed;
    }
    if (!failed.empty() && target.part != target.place)
    {
      fs::remove(target.part, error);
    }
  }
  if (!failed.empty())
  {
    for (auto folder = made.rbegin(); folder != made.rend(); ++folder)
    {
      std::error_code ignored; // it stays if something is in it
      fs::remove(*folder, ignored);
    }
    throw crossfield::Error(
      "The file '" + failed + "' cannot be written; check the folder and the free space.");
  }
}
}
