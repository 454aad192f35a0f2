#include "vtkQuadMeshWriter.h"

#include "Error.h"
#include "ExportConversion.h"
#include "FilterPorts.h"
#include "FilterRun.h"
#include "HigherOrderConversion.h"
#include "MeshFormats.h"
#include "TextFile.h"

#include "vtkInformation.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"
#include "vtkUnstructuredGrid.h"

vtkStandardNewMacro(vtkQuadMeshWriter);

//------------------------------------------------------------------------------
vtkQuadMeshWriter::vtkQuadMeshWriter()
{
  this->SetNumberOfInputPorts(2);
}

//------------------------------------------------------------------------------
int vtkQuadMeshWriter::FillInputPortInformation(int port, vtkInformation* info)
{
  if (port == 0)
  {
    info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkUnstructuredGrid");
    return 1;
  }
  info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), 1);
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPolyData");
  return 1;
}

//------------------------------------------------------------------------------
std::string vtkQuadMeshWriter::ReasonAgainst(const std::string& fileName, int order)
{
  try
  {
    crossfield::RequireOrder(crossfield::MeshFormatOf(fileName), order);
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
  auto* boundary = vtkPolyData::SafeDownCast(
    this->GetNumberOfInputConnections(1) > 0 ? this->GetInput(1) : nullptr);
  this->OutputFiles.clear();
  const FilterRun::Outcome outcome = FilterRun::Try(this,
    [&](const crossfield::Progress& progress)
    {
      vtkNew<vtkUnstructuredGrid> mesh;
      HigherOrderConversion::Join(input, boundary, mesh);
      const auto version =
        this->MshVersion == Msh22 ? crossfield::MshVersion::V22 : crossfield::MshVersion::V41;
      progress.Report(0.1);
      std::vector<crossfield::FileText> files =
        crossfield::WriteMeshFiles(ExportConversion::ReadMesh(mesh).mesh, this->FileName, version);
      progress.Report(0.8);
      for (crossfield::FileText& file : files)
      {
        this->OutputFiles.emplace_back(std::move(file.name), std::move(file.text));
      }
      if (!this->WriteToOutputString)
      {
        TextFile::Write(this->OutputFiles);
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
  os << indent << "WriteToOutputString: " << this->WriteToOutputString << "\n";
}
