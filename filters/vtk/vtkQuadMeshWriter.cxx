#include "vtkQuadMeshWriter.h"

#include "CgnsLibrary.h"
#include "ColumnWriting.h"
#include "Error.h"
#include "FilterPorts.h"
#include "FilterRun.h"
#include "FoamCase.h"
#include "MeshFormats.h"
#include "QuadBoundary.h"
#include "SideText.h"
#include "SolverMeshReading.h"
#include "TextFile.h"
#include "vtkCrossFieldArrayNames.h"

#include "vtkCellData.h"
#include "vtkErrorCode.h"
#include "vtkFieldData.h"
#include "vtkInformation.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkStringArray.h"
#include "vtkUnstructuredGrid.h"
#include "vtkUnstructuredGridWriter.h"

#include <map>
#include <utility>
#include <vector>

vtkStandardNewMacro(vtkQuadMeshWriter);

namespace
{
using crossfield::MeshFormat;

/**
 * Returns for each cell the number of its side: in the order of `SideNames`, then of the cells; −1
 * for none.
 */
std::vector<int> NumbersOfSides(vtkUnstructuredGrid* mesh, vtkStringArray* sides)
{
  std::map<std::string, int> numbers = { { "", -1 } };
  const auto numberOf = [&numbers](const std::string& name)
  { return numbers.emplace(name, static_cast<int>(numbers.size()) - 1).first->second; };
  auto* all = vtkStringArray::SafeDownCast(
    mesh->GetFieldData()->GetAbstractArray(vtkCrossFieldArrayNames::SideNames));
  for (vtkIdType i = 0; all != nullptr && i < all->GetNumberOfValues(); ++i)
  {
    numberOf(all->GetValue(i));
  }
  std::vector<int> result;
  for (vtkIdType cell = 0; cell < sides->GetNumberOfValues(); ++cell)
  {
    result.push_back(numberOf(sides->GetValue(cell)));
  }
  return result;
}

/** Replaces the names of sides by their numbers, and removes other texts and empty arrays. */
void ReplaceTexts(vtkUnstructuredGrid* mesh)
{
  const vtkSmartPointer<vtkStringArray> sides = vtkStringArray::SafeDownCast(
    mesh->GetCellData()->GetAbstractArray(vtkCrossFieldArrayNames::Side));
  std::vector<int> numbers;
  if (sides != nullptr)
  {
    numbers = NumbersOfSides(mesh, sides);
  }
  for (vtkFieldData* data : { static_cast<vtkFieldData*>(mesh->GetCellData()),
         static_cast<vtkFieldData*>(mesh->GetPointData()), mesh->GetFieldData() })
  {
    for (int i = data->GetNumberOfArrays() - 1; i >= 0; --i)
    {
      vtkAbstractArray* array = data->GetAbstractArray(i);
      if (vtkStringArray::SafeDownCast(array) != nullptr || array->GetNumberOfValues() == 0)
      {
        data->RemoveArray(i);
      }
    }
  }
  if (sides != nullptr)
  {
    ColumnWriting::AddIntegers(mesh->GetCellData(), vtkCrossFieldArrayNames::Side, numbers);
  }
}

/**
 * Returns the bytes of a file of VTK's legacy format that other programs read: version 4.2 without
 * texts.
 */
std::string LegacyBytes(vtkUnstructuredGrid* mesh)
{
  vtkNew<vtkUnstructuredGrid> plain;
  plain->ShallowCopy(mesh);
  ReplaceTexts(plain);
  vtkNew<vtkUnstructuredGridWriter> writer;
  writer->SetInputData(plain);
  writer->SetFileVersion(vtkDataWriter::VTK_LEGACY_READER_VERSION_4_2);
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
