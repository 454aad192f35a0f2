#include "vtkPlanarDomainReader.h"

#include "Error.h"
#include "FilterRun.h"
#include "LoopText.h"
#include "PointTable.h"

#include "vtkCellArray.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <vtksys/SystemTools.hxx>

#include <vector>

vtkStandardNewMacro(vtkPlanarDomainReader);

namespace
{
/** Writes one closed polyline per loop. */
void WriteLines(const std::vector<LoopText::Loop>& loops, vtkPolyData* output)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> lines;
  for (const LoopText::Loop& loop : loops)
  {
    const vtkIdType first = points->GetNumberOfPoints();
    lines->InsertNextCell(static_cast<int>(loop.size()) + 1);
    for (const auto& place : loop)
    {
      lines->InsertCellPoint(points->InsertNextPoint(place.data()));
    }
    lines->InsertCellPoint(first);
  }
  output->SetPoints(points);
  output->SetLines(lines);
}
}

//------------------------------------------------------------------------------
vtkPlanarDomainReader::vtkPlanarDomainReader()
{
  this->SetNumberOfInputPorts(0);
}

//------------------------------------------------------------------------------
int vtkPlanarDomainReader::CanReadFile(const char* fileName)
{
  if (fileName == nullptr || !vtksys::SystemTools::FileExists(fileName, true))
  {
    return 0;
  }
  const std::string text = PointTable::ReadFile(fileName);
  return LoopText::LooksLike(text, LoopText::FindFormat(text, fileName)) ? 1 : 0;
}

//------------------------------------------------------------------------------
int vtkPlanarDomainReader::RequestData(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputVector)
{
  return FilterRun::Run(this, this->ErrorCode,
    [&](const crossfield::Progress&)
    {
      if (!this->ReadFromInputString && !vtksys::SystemTools::FileExists(this->FileName, true))
      {
        throw crossfield::Error(
          "There is no file '" + this->FileName + "'; check the name of the domain.");
      }
      const std::string text =
        this->ReadFromInputString ? this->InputString : PointTable::ReadFile(this->FileName);
      WriteLines(LoopText::Read(text, this->FileName), vtkPolyData::GetData(outputVector));
    });
}

//------------------------------------------------------------------------------
void vtkPlanarDomainReader::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FileName: " << this->FileName << "\n";
  os << indent << "ReadFromInputString: " << (this->ReadFromInputString ? "on" : "off") << "\n";
  os << indent << "InputString: " << this->InputString << "\n";
}
