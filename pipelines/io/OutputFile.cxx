#include "OutputFile.h"

#include "BlockCompressor.h"
#include "OutputTransaction.h"
#include "PipelineRun.h"
#include "vtkCrossFieldArrayNames.h"
#include "vtkQuadMeshWriter.h"

#include "vtkDataArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkStructuredGrid.h"
#include "vtkTimerLog.h"
#include "vtkUnstructuredGrid.h"
#include "vtkXMLPolyDataWriter.h"
#include "vtkXMLStructuredGridWriter.h"
#include "vtkXMLUnstructuredGridWriter.h"

#include <vtksys/SystemTools.hxx>

#include <algorithm>
#include <cstddef>
#include <memory>
#include <set>
#include <sstream>
#include <unistd.h>

namespace
{
using PipelineRun::Error;

/**
 * Throws std::bad_alloc if there is no memory for the text of the data: VTK 9.1 crashes if memory
 * runs out while it writes. The text in base 64 has at most 4/3 of the data's size, and 3 times
 * that while it grows.
 */
void RequireMemoryForText(vtkDataObject* data)
{
  const std::size_t kibibytes = data->GetActualMemorySize();
  const std::unique_ptr<char[]> trial(new char[kibibytes * 4 * 1024]);
  *static_cast<volatile char*>(trial.get()) = 0; // or the compiler may remove the allocation
}

/** Returns the ending in lower case, / for a folder. */
std::string EndingOf(const std::string& file)
{
  if (!file.empty() && file.back() == '/')
  {
    return "/";
  }
  return vtksys::SystemTools::LowerCase(vtksys::SystemTools::GetFilenameLastExtension(file));
}

/** Returns whether quads are written to a file, or standard output, as .vtu. */
bool IsVtu(const std::string& file)
{
  return file == "-" || EndingOf(file) == ".vtu";
}

/** Throws PipelineRun::Error unless a folder can be written, or can be made in one that is there. */
void RequireWritableFolder(const std::string& name)
{
  using vtksys::SystemTools;
  std::string folder = SystemTools::CollapseFullPath(name);
  while (!SystemTools::PathExists(folder))
  {
    folder = SystemTools::GetParentDirectory(folder);
  }
  if (!SystemTools::FileIsDirectory(folder))
  {
    throw Error("'" + folder + "' is a file, and the folder '" + name +
      "' cannot be made; choose another name.");
  }
  if (access(folder.c_str(), W_OK) != 0)
  {
    throw Error("The folder '" + folder + "' cannot be written; choose another.");
  }
}

void RequireWritableFile(const std::string& file, const std::string& endings)
{
  const std::vector<std::string> possible = vtksys::SystemTools::SplitString(endings, ' ');
  if (!endings.empty() &&
    std::find(possible.begin(), possible.end(), EndingOf(file)) == possible.end())
  {
    std::string list = possible[0];
    for (std::size_t i = 1; i < possible.size(); ++i)
    {
      list += (i + 1 == possible.size() ? " or " : ", ") + possible[i];
    }
    throw Error("The output file '" + file + "' must end in " + list + ".");
  }
  if (EndingOf(file) == "/" || (EndingOf(file) == ".foam" && !endings.empty()))
  {
    const std::string folder = file.substr(0, file.rfind('/') + 1); // empty: the working folder
    for (const char* part : { "constant/polyMesh", "system" })
    {
      RequireWritableFolder(folder + part);
    }
    return;
  }
  if (vtksys::SystemTools::FileIsDirectory(file))
  {
    throw Error("The output '" + file + "' is a folder; choose another name.");
  }
  std::string folder =
    vtksys::SystemTools::GetParentDirectory(vtksys::SystemTools::CollapseFullPath(file));
  if (access(folder.c_str(), W_OK) != 0)
  {
    throw Error("The folder '" + folder + "' does not exist or cannot be written; choose another.");
  }
  if (access(file.c_str(), F_OK) == 0 && access(file.c_str(), W_OK) != 0)
  {
    throw Error("The file '" + file + "' is protected against writing; choose another name.");
  }
}
}

namespace OutputFile
{
void RequireWritable(std::initializer_list<Output> outputs)
{
  std::set<std::string> files;
  for (const auto& [file, endings] : outputs)
  {
    if (file.empty())
    {
      continue;
    }
    // A multiblock is an index file and a folder beside it.
    if (file != "-" || endings == ".vtm")
    {
      RequireWritableFile(file, endings);
    }
    if (!files.insert(file).second)
    {
      throw Error("Two outputs cannot both go to '" + file + "'; give two names.");
    }
  }
}

void Write(vtkDataObject* data, const std::string& file, OutputTransaction& outputs)
{
  vtkSmartPointer<vtkXMLWriter> writer;
  if (vtkPolyData::SafeDownCast(data) != nullptr)
  {
    writer = vtkSmartPointer<vtkXMLPolyDataWriter>::New();
  }
  else if (vtkStructuredGrid::SafeDownCast(data) != nullptr)
  {
    writer = vtkSmartPointer<vtkXMLStructuredGridWriter>::New();
  }
  else
  {
    writer = vtkSmartPointer<vtkXMLUnstructuredGridWriter>::New();
  }
  vtkNew<BlockCompressor> compressor;
  compressor->Compress(vtkDataSet::SafeDownCast(data), writer->GetBlockSize());
  writer->SetInputDataObject(data);
  writer->SetDataModeToBinary();
  writer->SetCompressor(compressor);
  writer->WriteToOutputStringOn(); // VTK 9.1 and 9.2 crash when a stream to a file fails
  RequireMemoryForText(data);
  PipelineRun::RequireNoError([&writer] { writer->Write(); });
  outputs.Write(writer->GetOutputString(), file);
}

void RequireOrder(const std::string& file, int order)
{
  const std::string reason = IsVtu(file) ? "" : vtkQuadMeshWriter::ReasonAgainst(file, order);
  if (!reason.empty())
  {
    throw Error(reason);
  }
}

void WriteQuads(vtkUnstructuredGrid* quads, const std::string& file, int mshVersion,
  const std::string& patchTypes, OutputTransaction& outputs)
{
  if (IsVtu(file))
  {
    Write(quads, file, outputs);
    return;
  }
  vtkNew<vtkQuadMeshWriter> writer;
  writer->SetInputDataObject(quads);
  writer->SetFileName(file);
  writer->SetMshVersion(mshVersion);
  writer->SetPatchTypes(patchTypes);
  writer->WriteToOutputStringOn();
  PipelineRun::RequireNoError([&writer] { writer->Write(); });
  for (const auto& [name, text] : writer->GetOutputFiles())
  {
    const std::size_t slash = name.rfind('/');
    if (slash != std::string::npos)
    {
      outputs.MakeFolder(name.substr(0, slash));
    }
    outputs.Write(text, name);
  }
}

double WriteIfNamed(vtkDataObject* data, const std::string& file, OutputTransaction& outputs)
{
  vtkNew<vtkTimerLog> timer;
  timer->StartTimer();
  if (!file.empty())
  {
    Write(data, file, outputs);
  }
  timer->StopTimer();
  return timer->GetElapsedTime();
}

void WriteConfiguration(
  vtkDataSet* singularities, bool hasHeight, const std::string& file, OutputTransaction& outputs)
{
  namespace names = vtkCrossFieldArrayNames;
  vtkDataArray* radii = singularities->GetPointData()->GetArray(names::Radius);
  const bool hasRadii =
    radii != nullptr && singularities->GetNumberOfPoints() > 0 && radii->GetRange()[1] > 0.0;
  std::ostringstream text;
  text.precision(17);
  text << (hasHeight ? "x,y,z" : "x,y") << ",quarter_index" << (hasRadii ? ",radius\n" : "\n");
  for (vtkIdType i = 0; i < singularities->GetNumberOfPoints(); ++i)
  {
    const auto value = [singularities, i](const char* name)
    { return singularities->GetPointData()->GetArray(name)->GetTuple1(i); };
    const double* place = singularities->GetPoint(i);
    text << place[0] << "," << place[1] << ",";
    if (hasHeight)
    {
      text << place[2] << ",";
    }
    text << value(names::QuarterIndex);
    if (hasRadii)
    {
      text << "," << value(names::Radius);
    }
    text << "\n";
  }
  outputs.Write(text.str(), file);
}

void WriteBlocks(const Blocks& blocks, const std::string& file, OutputTransaction& outputs)
{
  using vtksys::SystemTools;
  const std::string name = SystemTools::GetFilenameWithoutLastExtension(file);
  const std::string folder =
    SystemTools::GetParentDirectory(SystemTools::CollapseFullPath(file)) + "/" + name;
  outputs.MakeFolder(folder);
  std::string index = "<?xml version=\"1.0\"?>\n"
                      "<VTKFile type=\"vtkMultiBlockDataSet\" version=\"1.0\">\n"
                      "  <vtkMultiBlockDataSet>\n";
  for (std::size_t i = 0; i < blocks.size(); ++i)
  {
    const auto& [block, data] = blocks[i];
    const std::string piece =
      block + (vtkStructuredGrid::SafeDownCast(data) != nullptr ? ".vts" : ".vtu");
    Write(data, folder + "/" + piece, outputs);
    index += "    <DataSet index=\"" + std::to_string(i) + "\" name=\"" + block + "\" file=\"" +
      name + "/" + piece + "\"/>\n";
  }
  outputs.Write(index + "  </vtkMultiBlockDataSet>\n</VTKFile>\n", file);
}
}
