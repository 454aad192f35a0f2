/**
 * crossfield: all-quad meshes and cross fields of planar parts, with chosen irregular nodes. Each
 * subcommand has a file of its own.
 *
 *   crossfield quads builtin:disk -o quads.vtu
 *
 * Exit status: 0 done; 1 done but the answer is no; 2 bad usage or bad input, with one sentence on
 * standard error and no file written.
 */
#include "CommandLine.h"
#include "PipelineRun.h"

#include "vtkLogger.h"

#include <CLI/CLI.hpp>

#include <vtksys/SystemTools.hxx>

#include <sys/resource.h>

#include <cstdio>
#include <cstdlib>
#include <iostream>
#include <new>

#ifdef __GLIBC__
#include <malloc.h>
#endif

namespace
{
/** Returns whether the address space of the program is limited (ulimit -v). */
bool HasAddressLimit()
{
  rlimit limit = {};
  return getrlimit(RLIMIT_AS, &limit) == 0 && limit.rlim_cur != RLIM_INFINITY;
}

/**
 * Ends the program. Under a limit on the address space (ulimit -v) a thread of OpenBLAS may retry
 * an allocation for ever, and exit() would wait for it.
 */
int End(int status)
{
  if (HasAddressLimit())
  {
    std::cout.flush();
    std::fflush(nullptr);
    std::_Exit(status);
  }
  return status;
}

void PrintPaths(const char* program)
{
  std::string path;
  std::string error;
  vtksys::SystemTools::FindProgramPath(program, path, error);
  const std::string folder =
    vtksys::SystemTools::GetFilenamePath(vtksys::SystemTools::GetRealPath(path));
  const auto beside = [&folder](const std::string& relative)
  { return relative.empty() ? "" : vtksys::SystemTools::CollapseFullPath(relative, folder); };
  std::cout << "program: " << path << "\n"
            << "plugin: " << beside(CROSSFIELD_PLUGIN_PATH) << "\n"
            << "python: " << beside(CROSSFIELD_PYTHON_PATH) << "\n";
}

int Run(int argc, char** argv)
{
  vtkLogger::SetStderrVerbosity(vtkLogger::VERBOSITY_OFF); // PipelineRun reports errors
  CLI::App app(
    "All-quad meshes and cross fields of planar parts, with the irregular nodes you choose.",
    "crossfield");
  app.set_version_flag("--version", CROSSFIELD_VERSION);
  bool paths = false;
  app.add_flag("--paths", paths, "print where the program, the plugin and the Python package are");
  app.require_subcommand(0, 1);
  int status = Done;
  AddDomainCommand(app, status);
  AddCheckCommand(app, status);
  AddCornersCommand(app, status);
  AddDrillCommand(app, status);
  AddQuadsCommand(app, status);
  AddSeparatricesCommand(app, status);
  AddSolveCommand(app, status);
  AddCompareCommand(app, status);
  AddHFieldCommand(app, status);
  AddEnergyCommand(app, status);
  AddOptimizeCommand(app, status);
  AddFiguresCommand(app, status);
  try
  {
    app.parse(argc, argv);
    if (paths)
    {
      PrintPaths(argv[0]);
    }
    else if (app.get_subcommands().empty())
    {
      throw std::runtime_error("No subcommand was given; see `crossfield --help`.");
    }
  }
  catch (const CLI::ParseError& error)
  {
    if (error.get_exit_code() == static_cast<int>(CLI::ExitCodes::Success))
    {
      return app.exit(error); // help and version
    }
    std::cerr << "crossfield: " << error.what() << "; see `crossfield --help`.\n";
    return BadInput;
  }
  catch (const PipelineRun::Error& error)
  {
    std::cerr << "crossfield: " << error.what() << "\n";
    return error.GetStatus();
  }
  catch (const std::bad_alloc&)
  {
    std::cerr
      << "crossfield: There is not enough memory for an input or a mesh of this size; use a "
         "larger mesh size.\n";
    return BadInput;
  }
  catch (const std::exception& error)
  {
    std::cerr << "crossfield: " << error.what() << "\n";
    return BadInput;
  }
  return status;
}
}

int main(int argc, char** argv)
{
#ifdef __GLIBC__
  // By default glibc returns every large block to the system, and the next stage waits until its
  // pages are cleared again: a tenth of the processor time of a field on a million triangles.
  // Blocks of larger problems are still returned, because free memory is checked before each stage.
  if (!HasAddressLimit())
  {
    mallopt(M_MMAP_THRESHOLD, 64 << 20);
    mallopt(M_TRIM_THRESHOLD, 256 << 20);
  }
#endif
  return End(Run(argc, argv));
}
