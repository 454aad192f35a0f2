#include "OutputTransaction.h"

#include "InterruptGuard.h"
#include "PipelineRun.h"

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <sys/stat.h>
#include <unistd.h>

namespace
{
using PipelineRun::Error;
namespace fs = std::filesystem;

[[noreturn]] void ThrowCannotWrite(const std::string& file)
{
  throw Error("The file '" + file + "' cannot be written; check the folder and the free space.");
}

/** Returns the target of a link, which need not exist; other names are only made absolute. */
std::string FollowLinks(const std::string& file)
{
  std::error_code failed;
  fs::path path = fs::absolute(file, failed);
  constexpr int MaximumLinks = 40; // as in the kernel; more are a cycle
  for (int i = 0; i < MaximumLinks && fs::is_symlink(path, failed); ++i)
  {
    path = path.parent_path() / fs::read_symlink(path, failed);
  }
  const fs::path folder = fs::canonical(path.parent_path(), failed);
  return failed ? path.string() : (folder / path.filename()).string();
}

void RequireNoFolder(const std::string& place, const std::string& file)
{
  std::error_code failed;
  if (fs::is_directory(place, failed))
  {
    throw Error("The output '" + file + "' is a folder; choose another name.");
  }
}

bool IsStream(const std::string& place)
{
  std::error_code failed;
  const fs::file_status status = fs::status(place, failed);
  return fs::exists(status) && !fs::is_regular_file(status) && !fs::is_directory(status);
}
}

OutputTransaction::OutputTransaction()
{
  InterruptGuard::Install();
}

OutputTransaction::~OutputTransaction()
{
  const InterruptGuard guard;
  this->Undo();
  InterruptGuard::RemoveOnSignal({}, {});
}

void OutputTransaction::RegisterForSignals()
{
  std::vector<std::string> parts;
  for (const File& file : this->Files)
  {
    parts.push_back(file.part);
  }
  InterruptGuard::RemoveOnSignal(parts, this->Folders);
}

void OutputTransaction::Write(const std::string& text, const std::string& file)
{
  if (file == "-" || IsStream(file))
  {
    this->Streams.push_back({ file, text });
    return;
  }
  File entry;
  entry.name = file;
  entry.place = FollowLinks(file);
  RequireNoFolder(entry.place, file);
  entry.part = entry.place + ".part" + std::to_string(getpid());
  if (std::any_of(this->Files.begin(), this->Files.end(),
        [&entry](const File& other) { return other.place == entry.place; }))
  {
    throw Error("Two outputs cannot both go to '" + file + "'; give two names.");
  }
  {
    const InterruptGuard guard;
    this->Files.push_back(entry);
    this->RegisterForSignals();
  }
  std::ofstream stream(entry.part, std::ios::binary);
  stream << text;
  stream.close();
  if (!stream)
  {
    ThrowCannotWrite(file);
  }
  struct stat old = {};
  if (stat(entry.place.c_str(), &old) == 0)
  {
    chmod(entry.part.c_str(), old.st_mode & 07777); // keep the permissions
  }
}

void OutputTransaction::MakeFolder(const std::string& folder)
{
  const InterruptGuard guard;
  std::error_code failed;
  fs::path path;
  for (const fs::path& name : fs::absolute(folder, failed).lexically_normal())
  {
    path /= name;
    if (!failed && !name.empty() && fs::create_directory(path, failed))
    {
      this->Folders.push_back(path.string());
      this->RegisterForSignals();
    }
  }
  if (failed)
  {
    throw Error("The folder '" + folder + "' cannot be made; choose another name.");
  }
}

void OutputTransaction::Print() const
{
  for (const Stream& stream : this->Streams)
  {
    if (stream.name == "-")
    {
      std::cout << stream.text;
      continue;
    }
    std::ofstream device(stream.name, std::ios::binary);
    device << stream.text;
    device.close();
    if (!device)
    {
      ThrowCannotWrite(stream.name);
    }
  }
  if (!std::cout.flush())
  {
    throw Error("The report cannot be written to standard output; check where it goes.");
  }
}

void OutputTransaction::Place(File& file)
{
  const std::string before = file.place + ".before" + std::to_string(getpid());
  RequireNoFolder(file.place, file.name); // rename would move a folder like a file
  std::remove(before.c_str());            // left by a killed process with this number
  // A hard link keeps the file in place; some file systems have none.
  if (link(file.place.c_str(), before.c_str()) == 0 ||
    (errno != ENOENT && std::rename(file.place.c_str(), before.c_str()) == 0))
  {
    file.before = before;
  }
  if (std::rename(file.part.c_str(), file.place.c_str()) != 0)
  {
    throw Error("The file '" + file.name + "' cannot be written; choose another place.");
  }
  file.placed = true;
}

void OutputTransaction::Commit()
{
  this->Print();
  const InterruptGuard guard; // delays signals until all files are in place
  for (File& file : this->Files)
  {
    this->Place(file);
  }
  for (const File& file : this->Files)
  {
    if (!file.before.empty())
    {
      std::remove(file.before.c_str());
    }
  }
  this->Files.clear();
  this->Folders.clear();
  this->Streams.clear();
  InterruptGuard::RemoveOnSignal({}, {});
}

void OutputTransaction::Undo()
{
  for (auto file = this->Files.rbegin(); file != this->Files.rend(); ++file)
  {
    std::remove(file->part.c_str());
    if (!file->before.empty())
    {
      std::rename(file->before.c_str(), file->place.c_str());
      // If both names refer to one file, rename keeps both.
      std::remove(file->before.c_str());
    }
    else if (file->placed)
    {
      std::remove(file->place.c_str());
    }
  }
  for (auto folder = this->Folders.rbegin(); folder != this->Folders.rend(); ++folder)
  {
    rmdir(folder->c_str()); // fails if another program has written into it
  }
}
