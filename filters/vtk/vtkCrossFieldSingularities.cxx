#include "vtkCrossFieldSingularities.h"

#include "ConfigurationConversion.h"
#include "CrossFieldArrays.h"
#include "DrilledMeshConversion.h"
#include "FieldSingularities.h"
#include "FilterPorts.h"
#include "FilterRun.h"
#include "SurfaceConversion.h"
#include "SurfaceIndices.h"
#include "vtkCrossFieldArrayNames.h"

#include "vtkInformationVector.h"
#include "vtkIntArray.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkUnstructuredGrid.h"

vtkStandardNewMacro(vtkCrossFieldSingularities);

namespace
{
void WriteSingularities(const std::vector<crossfield::FieldSingularity>& singularities,
  const crossfield::DomainPlane& plane, vtkPolyData* output)
{
  vtkNew<vtkIntArray> kinds;
  kinds->SetName(vtkCrossFieldArrayNames::BoundaryKind);
  vtkNew<vtkIntArray> ids;
  ids->SetName(vtkCrossFieldArrayNames::BoundaryId);
  crossfield::Configuration configuration;
  for (const crossfield::FieldSingularity& singularity : singularities)
  {
    configuration.push_back(singularity);
    kinds->InsertNextValue(static_cast<int>(singularity.place));
    ids->InsertNextValue(singularity.id);
  }
  ConfigurationConversion::WriteConfiguration(configuration, plane, output);
  output->GetPointData()->AddArray(kinds);
  output->GetPointData()->AddArray(ids);
}
}

//------------------------------------------------------------------------------
vtkCrossFieldSingularities::vtkCrossFieldSingularities() = default;

//------------------------------------------------------------------------------
int vtkCrossFieldSingularities::FillInputPortInformation(int, vtkInformation* info)
{
  return FilterPorts::AcceptMesh(info);
}

//------------------------------------------------------------------------------
int vtkCrossFieldSingularities::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkUnstructuredGrid* input = vtkUnstructuredGrid::GetData(inputVector[0]);
  return FilterRun::Run(this, this->ErrorCode, input,
    [&](const crossfield::Progress&)
    {
      if (SurfaceConversion::IsSurface(input))
      {
        const SurfaceConversion::Crosses crosses = SurfaceConversion::ReadCrosses(input);
        SurfaceConversion::WriteSingularities(*crosses.topology,
          crossfield::FindSurfaceSingularities(
            *crosses.topology, crosses.angle, this->IncludeCorners),
          vtkPolyData::GetData(outputVector));
        return;
      }
      const DrilledMeshConversion::DrilledMesh cells =
        DrilledMeshConversion::ReadDrilledMesh(input);
      crossfield::FieldSingularityOptions options;
      options.corners = this->IncludeCorners;
      options.holes = this->IncludeHoles;
      options.cornerAngle = vtkMath::RadiansFromDegrees(this->CornerAngle);
      const auto singularities =
        crossfield::FindFieldSingularities(CrossFieldArrays::ReadField(cells, input), options);
      vtkPolyData* output = vtkPolyData::GetData(outputVector);
      WriteSingularities(singularities, cells.plane, output);
      if (!this->IncludeHoles)
      {
        // Only holes have a radius; vtkDrillHoles refuses a radius of 0.
        output->GetPointData()->RemoveArray(vtkCrossFieldArrayNames::Radius);
      }
    });
}

//------------------------------------------------------------------------------
void vtkCrossFieldSingularities::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "IncludeCorners: " << (this->IncludeCorners ? "on" : "off") << "\n";
  os << indent << "IncludeHoles: " << (this->IncludeHoles ? "on" : "off") << "\n";
  os << indent << "CornerAngle: " << this->CornerAngle << "\n";
}
