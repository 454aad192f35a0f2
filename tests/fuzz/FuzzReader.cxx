/**
 * Writes the bytes of the fuzzer to a file, reads it as a domain or as singularities, and runs a
 * filter that converts and checks it. The result is an output or an error of one sentence.
 *
 *   fuzzReader --format=vtp     (domains: vtp vtu vtk stl obj ply csv dat dxf svg geojson msh poly off; singularities: points.vtp points.csv)
 */
#include "DomainReader.h"
#include "PipelineRun.h"
#include "vtkDrillHoles.h"
#include "vtkPlanarDomainSource.h"
#include "vtkPoincareHopfCheck.h"

#include "vtkLogger.h"
#include "vtkNew.h"

#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <sstream>
#include <string>
#include <unistd.h>

namespace
{
std::string Format = "vtp";
std::string Folder;

/** Reads a domain and runs the check of the Poincaré-Hopf theorem, which accepts fields as well. */
void ReadDomain(const std::string& file)
{
  const auto domain = DomainReader::Open(file, 0.0);
  vtkNew<vtkPoincareHopfCheck> check;
  check->SetInputConnection(domain->GetOutputPort());
  PipelineRun::Update(check, "checking");
}

/** Reads singularities and makes a mesh with holes at them. */
void ReadPoints(const std::string& file)
{
  vtkNew<vtkPlanarDomainSource> domain;
  domain->SetEdgeLength(0.5);
  const auto points = DomainReader::OpenPoints(file);
  vtkNew<vtkDrillHoles> drill;
  drill->SetInputConnection(domain->GetOutputPort());
  drill->SetSingularitiesConnection(points->GetOutputPort());
  drill->SetMeshSize(0.5);
  PipelineRun::Update(drill, "drilling");
}
}

extern "C" int LLVMFuzzerInitialize(int* count, char*** arguments)
{
  const std::string option = "--format=";
  for (int i = 1; i < *count; ++i)
  {
    const std::string argument = (*arguments)[i];
    if (argument.compare(0, option.size(), option) == 0)
    {
      Format = argument.substr(option.size());
    }
  }
  vtkLogger::SetStderrVerbosity(vtkLogger::VERBOSITY_OFF); // as in the program
  Folder = std::filesystem::temp_directory_path() / ("crossfield-fuzz-" + std::to_string(getpid()));
  std::filesystem::create_directories(Folder);
  std::atexit([] { std::filesystem::remove_all(Folder); });
  return 0;
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  const std::string file = Folder + "/file." + Format;
  std::ofstream(file, std::ios::binary)
    .write(reinterpret_cast<const char*>(data), static_cast<std::streamsize>(size));
  try
  {
    Format.compare(0, 6, "points") == 0 ? ReadPoints(file) : ReadDomain(file);
  }
  catch (const PipelineRun::Error& error)
  {
    const std::string sentence = error.what();
    if (sentence.size() < 20 || sentence.back() != '.' || sentence.find('\n') != std::string::npos)
    {
      std::fprintf(stderr, "not one sentence: %s\n", sentence.c_str());
      std::abort();
    }
  }
  return 0;
}
