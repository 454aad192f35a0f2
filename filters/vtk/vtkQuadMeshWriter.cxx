#include "vtkQuadMeshWriter.h"

#include "CgnsLibrary.h"
#include "Error.h"
#include "FilterPorts.h"
#include "FilterRun.h"
#include "FoamCase.h"
#include "MeshFormats.h"
#include "QuadBoundary.h"
#include "SideText.h"
#include "SolverMeshReading.h"
#include "TextFile.h"

#include "vtkErrorCode.h"
#include "vtkInformation.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkUnstructuredGrid.h"
#include "vtkUnstructuredGridWriter.h"

#include <utility>

vtkStandardNewMacro(vtkQuadMeshWriter);

namespace
{
using crossfield::MeshFormat;

/** Returns the bytes of a file of VTK's legacy format. */
std::string LegacyBytes(vtkUnstructuredGrid* mesh)
{
  vtkNew<vtkUnstructuredGridWriter> writer;
  writer->SetInputData(mesh);
  writer->SetFileTypeToBinary(); // in text, numbers have 11 digits only
  writer->WriteToOutputStringOn();
  if (writer->Write() == 0 || writer->GetErrorCode() != vtkErrorCode::NoError)
  {
    throw crossfield::Error("The .vtk file cannot be written by VTK; write a .vtu file.");
  }
  return writer->GetOutputStdString();
}

std::vector<crossfield::FileText> FilesOf(
  vtkUnstructuredGrid* mesh, const std::string& name, int mshVersion, const std::string& patchTypes)
{
  const MeshFormat format = crossfield::MeshFormatOf(name);
  if (format == MeshFormat::Vtk)
  {
    return { { name, LegacyBytes(mesh) } };
  }
  crossfield::SolverMesh read = SolverMeshReading::Read(mesh);
  if (format == MeshFormat::Foam)
  {
    SolverMeshReading::SetPatchTypes(SideText::ReadPatchTypes(patchTypes), read);
  }
  if (format == MeshFormat::Cgns)
  {
    return { { name, CgnsLibrary::Write(std::move(read)) } };
  }
  return crossfield::WriteMeshFiles(std::move(read), name,
    mshVersion == vtkQuadMeshWriter::Msh22 ? crossfield::MshVersion::V22
                                           : crossfield::MshVersion::V41);
}
}

//------------------------------------------------------------------------------
vtkQuadMeshWriter::vtkQuadMeshWriter()
{
  this->SetNumberOfInputPorts(2);
}

//------------------------------------------------------------------------------
int vtkQuadMeshWriter::FillInputPortInformation(int port, vtkInformation* info)
{
  return port == 0 ? FilterPorts::AcceptMesh(info) : FilterPorts::AcceptOptionalBoundary(info);
}

//------------------------------------------------------------------------------
bool vtkQuadMeshWriter::CanWrite(const std::string& fileName)
{
  return crossfield::MeshFormatOf(fileName) != MeshFormat::None;
}

//------------------------------------------------------------------------------
bool vtkQuadMeshWriter::HasPatchTypes(const std::string& fileName)
{
  return crossfield::MeshFormatOf(fileName) == MeshFormat::Foam;
}

//------------------------------------------------------------------------------
std::string vtkQuadMeshWriter::GetEndings()
{
  return crossfield::MeshEndings();
}

//------------------------------------------------------------------------------
std::string vtkQuadMeshWriter::ReasonAgainst(const std::string& fileName, int order)
{
  try
  {
    const MeshFormat format = crossfield::MeshFormatOf(fileName);
    crossfield::RequireOrder(format, order);
    if (format == MeshFormat::Cgns)
    {
      CgnsLibrary::Require();
    }
    if (format == MeshFormat::Foam)
    {
      crossfield::RequireOwnCase(fileName);
    }
    return "";
  }
  catch (const crossfield::Error& error)
  {
    return error.what();
  }
}

//------------------------------------------------------------------------------
void vtkQuadMeshWriter::WriteData()
{
  auto* input = vtkUnstructuredGrid::SafeDownCast(this->GetInput(0));
  this->OutputFiles.clear();
  const FilterRun::Outcome outcome = FilterRun::Try(this,
    [&](const crossfield::Progress& progress)
    {
      vtkNew<vtkUnstructuredGrid> mesh;
      SolverMeshReading::Join(input, QuadBoundary::Find(this), mesh);
      progress.Report(0.1);
      std::vector<crossfield::FileText> files =
        FilesOf(mesh, this->FileName, this->MshVersion, this->PatchTypes);
      progress.Report(0.8);
      for (crossfield::FileText& file : files)
      {
        this->OutputFiles.emplace_back(std::move(file.name), std::move(file.text));
      }
      if (!this->WriteToOutputString)
      {
        const bool isCase = HasPatchTypes(this->FileName);
        if (isCase)
        {
          crossfield::RequireOwnCase(this->FileName);
        }
        TextFile::Write(this->OutputFiles, isCase);
        this->OutputFiles.clear();
      }
    });
  this->SetErrorCode(outcome.errorCode);
}

//------------------------------------------------------------------------------
void vtkQuadMeshWriter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FileName: " << this->FileName << "\n";
  os << indent << "MshVersion: " << this->MshVersion << "\n";
  os << indent << "PatchTypes: " << this->PatchTypes << "\n";
  os << indent << "WriteToOutputString: " << this->WriteToOutputString << "\n";
}
