#include "vtkDrillHoles.h"

#include "BoundarySingularities.h"
#include "ConfigurationConversion.h"
#include "DomainConversion.h"
#include "DrillHoles.h"
#include "DrilledMeshConversion.h"
#include "FilterPorts.h"
#include "FilterRun.h"
#include "SingularityRecord.h"
#include "vtkCrossFieldArrayNames.h"

#include "vtkDataSet.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <iterator>

vtkStandardNewMacro(vtkDrillHoles);

static_assert(static_cast<int>(crossfield::DrillMode::Triangle) == vtkDrillHoles::ModeTriangle,
  "modes are numbered as in the numerics");

//------------------------------------------------------------------------------
vtkDrillHoles::vtkDrillHoles()
{
  this->SetNumberOfInputPorts(2);
}

//------------------------------------------------------------------------------
int vtkDrillHoles::FillInputPortInformation(int port, vtkInformation* info)
{
  return port == 0 ? FilterPorts::AcceptDomain(info) : FilterPorts::AcceptSingularities(info);
}

//------------------------------------------------------------------------------
int vtkDrillHoles::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkDataSet* domain = vtkDataSet::GetData(inputVector[0]);
  vtkUnstructuredGrid* output = vtkUnstructuredGrid::GetData(outputVector);
  return FilterRun::Run(this, this->ErrorCode, domain,
    [&](const crossfield::Progress& progress)
    {
      const DomainConversion::Domain input = DomainConversion::ReadDomain(domain, this);
      const crossfield::Configuration configuration = ConfigurationConversion::ReadConfiguration(
        FilterPorts::RequireSingularities(inputVector[1], "Singularities"), input.plane);
      crossfield::DrillOptions options;
      options.mode = static_cast<crossfield::DrillMode>(this->Mode);
      options.meshSize = this->MeshSize;
      options.minimumHoleEdges = this->MinimumHoleEdges;
      options.gradation = this->Gradation;
      const crossfield::TriangleMesh mesh =
        crossfield::DrillHoles(input.domain, configuration, options, progress);
      DrilledMeshConversion::WriteDrilledMesh(mesh, input.plane, output);
      crossfield::Configuration onBoundary;
      std::copy_if(configuration.begin(), configuration.end(), std::back_inserter(onBoundary),
        [&input](const crossfield::Singularity& singularity)
        { return crossfield::IsOnBoundary(input.domain, singularity.position); });
      if (!onBoundary.empty())
      {
        SingularityRecord::Write(vtkCrossFieldArrayNames::BoundarySingularities, onBoundary,
          input.plane, output->GetFieldData());
      }
    });
}

//------------------------------------------------------------------------------
void vtkDrillHoles::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  const char* const modes[] = { "Perforate", "Imprint", "Triangle" };
  os << indent << "Mode: " << modes[this->Mode] << "\n";
  os << indent << "MeshSize: " << this->MeshSize << "\n";
  os << indent << "MinimumHoleEdges: " << this->MinimumHoleEdges << "\n";
  os << indent << "Gradation: " << this->Gradation << "\n";
}
