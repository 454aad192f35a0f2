#include "vtkHField.h"

#include "CachedDomain.h"
#include "ConfigurationConversion.h"
#include "CornerConversion.h"
#include "CrossFieldArrays.h"
#include "DomainConversion.h"
#include "DrilledMeshConversion.h"
#include "Error.h"
#include "FilterPorts.h"
#include "FilterRun.h"
#include "HField.h"
#include "MeshForPoints.h"
#include "PoincareHopf.h"
#include "Stopwatch.h"
#include "SurfaceConversion.h"
#include "SurfaceTopology.h"

#include "vtkDataSet.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkUnstructuredGrid.h"

#include <cmath>

vtkStandardNewMacro(vtkHField);

//------------------------------------------------------------------------------
vtkHField::vtkHField()
  : Cache(std::make_unique<CachedDomain>())
{
  this->SetNumberOfInputPorts(3);
}

//------------------------------------------------------------------------------
vtkHField::~vtkHField() = default;

//------------------------------------------------------------------------------
int vtkHField::FillInputPortInformation(int port, vtkInformation* info)
{
  return port == 0 ? FilterPorts::AcceptDomain(info) : FilterPorts::AcceptOptionalPoints(info);
}

//------------------------------------------------------------------------------
int vtkHField::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkDataSet* domain = vtkDataSet::GetData(inputVector[0]);
  vtkDataSet* singularities = vtkDataSet::GetData(inputVector[1]);
  vtkDataSet* corners = vtkDataSet::GetData(inputVector[2]);
  vtkUnstructuredGrid* output = vtkUnstructuredGrid::GetData(outputVector);
  return FilterRun::Run(this, this->ErrorCode, domain,
    [&](const crossfield::Progress& progress)
    {
      crossfield::Stopwatch stopwatch;
      vtkUnstructuredGrid* given = DrilledMeshConversion::AsDrilledMesh(domain);
      if (given == nullptr && SurfaceConversion::IsSurface(domain))
      {
        if ((corners != nullptr && corners->GetNumberOfPoints() > 0) || this->MeshSize > 0.0)
        {
          throw crossfield::Error(
            "The field of a surface in space does not support prescribed corners and MeshSize yet; "
            "leave them out.");
        }
        const crossfield::ConedSurfaces surfaces = SurfaceConversion::Read(domain, singularities);
        const crossfield::ConedSurface& part = SurfaceConversion::Single(surfaces);
        this->StageSeconds[0] = stopwatch.Lap();
        SurfaceConversion::WriteField(
          part, crossfield::SolveSurfaceField(part.topology, part.cones, progress), output);
        this->StageSeconds[1] = 0.0;
        this->StageSeconds[2] = stopwatch.Lap();
        this->StageSeconds[3] = 0.0;
        return;
      }
      crossfield::Configuration configuration;
      DrilledMeshConversion::DrilledMesh cells;
      std::shared_ptr<const crossfield::PotentialSolver> potential;
      if (given != nullptr)
      {
        cells = DrilledMeshConversion::ReadDrilledMesh(given);
        configuration = ConfigurationConversion::ReadConfiguration(singularities, cells.plane);
      }
      else if (this->KeepMesh)
      {
        const DomainConversion::Domain& input = this->Cache->Read(domain);
        configuration = ConfigurationConversion::ReadConfiguration(singularities, input.plane);
        potential = this->Cache->Factor(configuration, this->MeshSize, progress.Part(0.0, 0.4))
                      .GetPotential();
        cells = DrilledMeshConversion::NumberCells(potential->ShareTopology(), input.plane);
      }
      else
      {
        const DomainConversion::Domain input = DomainConversion::ReadDomain(domain, this);
        configuration = ConfigurationConversion::ReadConfiguration(singularities, input.plane);
        cells = DrilledMeshConversion::NumberCells(
          crossfield::ShareTopology(crossfield::MeshForPoints(
            input.domain, configuration, this->MeshSize, progress.Part(0.0, 0.4))),
          input.plane);
      }
      this->StageSeconds[0] = stopwatch.Lap();
      const std::vector<crossfield::CornerChoice> choices =
        CornerConversion::ReadCorners(corners, cells.plane);
      const crossfield::HField field = potential
        ? crossfield::SolveHField(potential, configuration, choices, progress.Part(0.4, 1.0))
        : crossfield::SolveHField(cells.topology, configuration, choices, progress.Part(0.4, 1.0));
      for (std::size_t k = 0; k < field.periods.size(); ++k)
      {
        const double defect = field.field.holonomyDefect[k];
        if (std::abs(defect) > crossfield::NoticeableDefect)
        {
          vtkWarningMacro("H is not single-valued: at inner loop "
            << k + 1 << " the crosses miss by " << crossfield::CrossAngle(defect)
            << ", and H jumps by " << field.periods[k]
            << " along a path to it. Move singularities until they fit.");
        }
      }
      if (given != nullptr)
      {
        output->ShallowCopy(given);
      }
      else
      {
        DrilledMeshConversion::WriteDrilledMesh(cells.topology->mesh, cells.plane, output);
      }
      CrossFieldArrays::AddField(cells, field.field, this->Arrays, output);
      CrossFieldArrays::AddReport(field.field, output);
      CrossFieldArrays::AddH(cells, field, configuration, this->Arrays, output);
      this->StageSeconds[1] = field.field.seconds.assemble;
      this->StageSeconds[2] = field.field.seconds.factor;
      this->StageSeconds[3] = field.field.seconds.solve;
    });
}

//------------------------------------------------------------------------------
void vtkHField::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "MeshSize: " << this->MeshSize << "\n";
  os << indent << "KeepMesh: " << this->KeepMesh << "\n";
  os << indent << "Arrays: " << this->Arrays << "\n";
  os << indent << "StageSeconds: " << this->StageSeconds[0] << " " << this->StageSeconds[1] << " "
     << this->StageSeconds[2] << " " << this->StageSeconds[3] << "\n";
}
