#include "OutputFile.h"

#include "AheadCompressor.h"
#include "PipelineRun.h"

#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkXMLPolyDataWriter.h"
#include "vtkXMLUnstructuredGridWriter.h"

#include <vtksys/SystemTools.hxx>

#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <unistd.h>

namespace
{
using PipelineRun::Error;

/** The file's name while it is incomplete: in the same folder, so that it can be renamed. */
std::string PartName(const std::string& file)
{
  return file + ".part" + std::to_string(getpid());
}

void MoveIntoPlace(const std::string& part, const std::string& file)
{
  if (std::rename(part.c_str(), file.c_str()) != 0)
  {
    std::remove(part.c_str());
    throw Error("The file '" + file + "' cannot be written; choose another place.");
  }
}
}

namespace OutputFile
{
void RequireWritable(const std::string& file, const std::string& ending)
{
  if (!ending.empty() &&
    vtksys::SystemTools::LowerCase(vtksys::SystemTools::GetFilenameLastExtension(file)) != ending)
  {
    throw Error("The output file '" + file + "' must end in " + ending + ".");
  }
  if (vtksys::SystemTools::FileIsDirectory(file))
  {
    throw Error("The output '" + file + "' is a folder; choose another name.");
  }
  std::string folder = vtksys::SystemTools::GetParentDirectory(
    vtksys::SystemTools::CollapseFullPath(file));
  if (access(folder.c_str(), W_OK) != 0)
  {
    throw Error("The folder '" + folder + "' does not exist or cannot be written; choose another.");
  }
}

void Write(vtkDataObject* data, const std::string& file)
{
  vtkSmartPointer<vtkXMLUnstructuredDataWriter> writer;
  if (vtkPolyData::SafeDownCast(data) != nullptr)
  {
    writer = vtkSmartPointer<vtkXMLPolyDataWriter>::New();
  }
  else
  {
    writer = vtkSmartPointer<vtkXMLUnstructuredGridWriter>::New();
  }
  vtkNew<AheadCompressor> compressor;
  compressor->SetCompressionLevel(1); // twice as fast as the default, and a few per cent larger
  compressor->Compress(vtkDataSet::SafeDownCast(data), writer->GetBlockSize());
  writer->SetInputDataObject(data);
  writer->SetDataModeToBinary();
  writer->SetCompressor(compressor);
  writer->WriteToOutputStringOn(); // VTK 9.1 and 9.2 crash when a stream to a file fails
  PipelineRun::RequireNoError([&writer] { writer->Write(); });
  WriteText(writer->GetOutputString(), file);
}

void WriteBlocks(const Blocks& blocks, const std::string& file)
{
  using vtksys::SystemTools;
  const std::string name = SystemTools::GetFilenameWithoutLastExtension(file);
  const std::string folder =
    SystemTools::GetParentDirectory(SystemTools::CollapseFullPath(file)) + "/" + name;
  std::error_code failed;
  std::filesystem::create_directories(folder, failed);
  if (failed)
  {
    throw Error("The folder '" + folder + "' cannot be made; choose another name.");
  }
  std::string index = "<?xml version=\"1.0\"?>\n"
                      "<VTKFile type=\"vtkMultiBlockDataSet\" version=\"1.0\">\n"
                      "  <vtkMultiBlockDataSet>\n";
  for (std::size_t i = 0; i < blocks.size(); ++i)
  {
    const auto& [block, data] = blocks[i];
    Write(data, folder + "/" + block + ".vtu");
    index += "    <DataSet index=\"" + std::to_string(i) + "\" name=\"" + block + "\" file=\"" +
      name + "/" + block + ".vtu\"/>\n";
  }
  WriteText(index + "  </vtkMultiBlockDataSet>\n</VTKFile>\n", file);
}

void WriteText(const std::string& text, const std::string& file)
{
  if (file == "-")
  {
    std::cout << text << std::flush;
    if (!std::cout)
    {
      throw Error("The report cannot be written to standard output; check where it goes.");
    }
    return;
  }
  const std::string part = PartName(file);
  std::ofstream stream(part);
  stream << text;
  stream.close();
  if (!stream)
  {
    std::remove(part.c_str());
    throw Error("The file '" + file + "' cannot be written; check the folder and the free space.");
  }
  MoveIntoPlace(part, file);
}
}
