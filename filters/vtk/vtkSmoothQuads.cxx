#include "vtkSmoothQuads.h"

#include "ColumnWriting.h"
#include "DomainConversion.h"
#include "FilterPorts.h"
#include "FilterRun.h"
#include "InputCheck.h"
#include "QuadAdvice.h"
#include "SmoothMesh.h"
#include "SurfaceConversion.h"
#include "vtkCrossFieldArrayNames.h"

#include "vtkCellData.h"
#include "vtkCellType.h"
#include "vtkDoubleArray.h"
#include "vtkIdList.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointSet.h"
#include "vtkPoints.h"

#include <optional>
#include <vector>

vtkStandardNewMacro(vtkSmoothQuads);

namespace names = vtkCrossFieldArrayNames;

namespace
{
/** Returns the cells that are quads. Throws Error if there are cells but quads, lines and vertices. */
std::vector<vtkIdType> FindQuads(vtkPointSet* mesh)
{
  std::vector<vtkIdType> cells;
  for (vtkIdType cell = 0; cell < mesh->GetNumberOfCells(); ++cell)
  {
    const int type = mesh->GetCellType(cell);
    if (type == VTK_QUAD)
    {
      cells.push_back(cell);
    }
    else if (type != VTK_LINE && type != VTK_POLY_LINE && type != VTK_VERTEX &&
      type != VTK_POLY_VERTEX)
    {
      throw crossfield::Error("The mesh has cells that are not quads; give a mesh of quads alone.");
    }
  }
  return cells;
}

void AddRange(vtkFieldData* data, const char* name, const crossfield::Range& range)
{
  auto array = ColumnWriting::NewArray<vtkDoubleArray>(data, name, 3, 1);
  array->SetTuple3(0, range.min, range.mean, range.max);
}
}

//------------------------------------------------------------------------------
vtkSmoothQuads::vtkSmoothQuads()
{
  this->SetNumberOfInputPorts(2);
}

//------------------------------------------------------------------------------
int vtkSmoothQuads::FillInputPortInformation(int port, vtkInformation* info)
{
  if (port == 1)
  {
    return FilterPorts::AcceptOptionalDomain(info);
  }
  FilterPorts::AcceptMesh(info);
  info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPolyData");
  return 1;
}

//------------------------------------------------------------------------------
int vtkSmoothQuads::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkPointSet* input = vtkPointSet::GetData(inputVector[0]);
  return FilterRun::Run(this, this->ErrorCode, input,
    [&](const crossfield::Progress& progress)
    {
      InputCheck::Require(input);
      const std::vector<vtkIdType> cells = FindQuads(input);
      vtkDataSet* given = vtkDataSet::GetData(inputVector[1]);
      std::optional<crossfield::SurfaceMesh> surface;
      crossfield::DomainPlane plane; // that of x and y
      if (given != nullptr)
      {
        surface = SurfaceConversion::ReadTriangles(given);
      }
      else
      {
        plane = DomainConversion::FindPlane(input);
      }
      crossfield::PlainQuads mesh;
      for (vtkIdType i = 0; i < input->GetNumberOfPoints(); ++i)
      {
        const Eigen::Vector3d place(input->GetPoint(i));
        mesh.points.push_back(surface ? place : crossfield::InSpace(plane.ToPlane(place)));
      }
      vtkNew<vtkIdList> ids;
      std::vector<bool> isUsed(mesh.points.size(), false);
      for (const vtkIdType cell : cells)
      {
        input->GetCellPoints(cell, ids);
        mesh.quads.emplace_back();
        for (std::size_t i = 0; i < 4; ++i)
        {
          const vtkIdType id = ids->GetId(static_cast<vtkIdType>(i));
          mesh.quads.back()[i] = static_cast<int>(id);
          isUsed[id] = true;
        }
      }
      crossfield::MeshSmoothingOptions options;
      options.slides = this->SlideOnBoundary;
      options.cornerAngle = vtkMath::RadiansFromDegrees(this->CornerAngle);
      options.uniform = this->UniformSizes;
      const crossfield::SmoothedMesh smoothed =
        crossfield::SmoothMesh(mesh, options, progress, surface ? &*surface : nullptr);
      if (smoothed.after.inverted > 0)
      {
        vtkWarningMacro(<< crossfield::CountInverted(smoothed.after)
                        << "; divide quads there, or move points of the boundary.");
      }
      vtkPointSet* output = vtkPointSet::GetData(outputVector);
      output->ShallowCopy(input);
      vtkNew<vtkPoints> points;
      points->SetDataTypeToDouble();
      points->SetNumberOfPoints(input->GetNumberOfPoints());
      for (vtkIdType i = 0; i < input->GetNumberOfPoints(); ++i)
      {
        const auto p = static_cast<std::size_t>(i);
        points->SetPoint(i,
          isUsed[p] ? plane.PlaceToSpace(smoothed.points[p]).data()
                    : Eigen::Vector3d(input->GetPoint(i)).data());
      }
      output->SetPoints(points);
      auto jacobians = ColumnWriting::NewArray<vtkDoubleArray>(
        output->GetCellData(), names::ScaledJacobian, 1, input->GetNumberOfCells(), 1.0);
      for (std::size_t q = 0; q < cells.size(); ++q)
      {
        jacobians->SetValue(cells[q], smoothed.after.scaledJacobian[q]);
      }
      AddRange(output->GetFieldData(), names::ScaledJacobianRange, smoothed.after.jacobian);
      AddRange(output->GetFieldData(), names::ScaledJacobianRangeBefore, smoothed.before.jacobian);
      ColumnWriting::AddIntegers(
        output->GetFieldData(), names::Inverted, { smoothed.after.inverted });
    });
}

//------------------------------------------------------------------------------
void vtkSmoothQuads::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "SlideOnBoundary: " << this->SlideOnBoundary << "\n";
  os << indent << "CornerAngle: " << this->CornerAngle << "\n";
  os << indent << "UniformSizes: " << this->UniformSizes << "\n";
}
