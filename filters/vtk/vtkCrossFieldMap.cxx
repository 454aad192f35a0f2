#include "vtkCrossFieldMap.h"

#include "CachedDomain.h"
#include "ConfigurationConversion.h"
#include "CornerConversion.h"
#include "DomainConversion.h"
#include "DrilledMeshConversion.h"
#include "Error.h"
#include "FilterPorts.h"
#include "FilterRun.h"
#include "HolonomyConversion.h"
#include "MapConversion.h"
#include "MeshForPoints.h"
#include "PoincareHopf.h"
#include "RequestedSingularities.h"
#include "SeamlessMapSolve.h"
#include "Stopwatch.h"
#include "SurfaceConversion.h"
#include "SurfaceMap.h"
#include "SurfaceTopology.h"

#include "vtkDataSet.h"
#include "vtkFieldData.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkUnstructuredGrid.h"

#include <cmath>

vtkStandardNewMacro(vtkCrossFieldMap);

//------------------------------------------------------------------------------
vtkCrossFieldMap::vtkCrossFieldMap()
  : Cache(std::make_unique<CachedDomain>())
{
  this->SetNumberOfInputPorts(3);
}

//------------------------------------------------------------------------------
vtkCrossFieldMap::~vtkCrossFieldMap() = default;

//------------------------------------------------------------------------------
int vtkCrossFieldMap::FillInputPortInformation(int port, vtkInformation* info)
{
  return port == 0 ? FilterPorts::AcceptDomain(info) : FilterPorts::AcceptOptionalPoints(info);
}

//------------------------------------------------------------------------------
int vtkCrossFieldMap::RequestData(
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
      MapConversion::Map result;
      if (given == nullptr && SurfaceConversion::IsSurface(domain))
      {
        if (this->RepairHolonomy || (corners != nullptr && corners->GetNumberOfPoints() > 0) ||
          this->MeshSize > 0.0)
        {
          throw crossfield::Error(
            "The map of a surface in space does not support RepairHolonomy, prescribed corners and "
            "MeshSize yet; leave them out.");
        }
        const crossfield::ConedSurfaces surfaces = SurfaceConversion::Read(domain, singularities);
        this->StageSeconds[0] = stopwatch.Lap();
        result.map = crossfield::SolveSurfaceMap(SurfaceConversion::Single(surfaces).topology,
          SurfaceConversion::Single(surfaces).cones, progress);
        this->StageSeconds[1] = stopwatch.Lap();
        MapConversion::WriteMap(result, output);
        return;
      }
      crossfield::SharedPlanarTopology topology;
      crossfield::Configuration configuration;
      crossfield::SeamlessMapOptions options;
      options.capCorners = this->CapCorners;
      vtkFieldData* field = output->GetFieldData();
      if (given != nullptr)
      {
        if (this->RepairHolonomy)
        {
          throw crossfield::Error(
            "Singularities at vertices of a mesh cannot be moved to repair the "
            "holonomy; give the domain instead.");
        }
        const DrilledMeshConversion::DrilledMesh cells =
          DrilledMeshConversion::ReadDrilledMesh(given);
        result.plane = cells.plane;
        topology = cells.topology;
        configuration = ConfigurationConversion::ReadConfiguration(singularities, result.plane);
        options.corners = CornerConversion::ReadCorners(corners, result.plane);
      }
      else
      {
        const DomainConversion::Domain& input = this->Cache->Read(domain);
        result.plane = input.plane;
        configuration = ConfigurationConversion::ReadConfiguration(singularities, result.plane);
        options.corners = CornerConversion::ReadCorners(corners, result.plane);
        if (this->RepairHolonomy)
        {
          const crossfield::HolonomyRepair repair = crossfield::RepairForMap(
            input.domain, configuration, options, this->MeshSize, progress.Part(0.0, 0.2));
          HolonomyConversion::WriteRepair(repair, input.plane, field);
          configuration = repair.singularities;
        }
        topology = crossfield::ShareTopology(this->KeepMesh
            ? this->Cache->Factor(configuration, this->MeshSize, progress.Part(0.2, 0.3))
                .MeshOn(configuration)
            : crossfield::MeshThroughPoints(
                input.domain, configuration, this->MeshSize, progress.Part(0.2, 0.3)));
      }
      this->StageSeconds[0] = stopwatch.Lap();
      result.map =
        crossfield::SolveSeamlessMap(topology, configuration, options, progress.Part(0.3, 1.0));
      this->StageSeconds[1] = stopwatch.Lap();
      const auto& flattening = result.map.flattening;
      if (flattening && flattening->PredictedStretch() > crossfield::NoticeableStretch)
      {
        vtkWarningMacro(<< crossfield::DescribeStretch(*flattening));
      }
      for (std::size_t k = 0; !flattening && k < result.map.holonomyDefect.size(); ++k)
      {
        const double defect = result.map.holonomyDefect[k];
        if (std::abs(defect) > crossfield::NoticeableDefect)
        {
          vtkWarningMacro("The map is not conformal: the grid lines around inner loop "
            << k + 1 << " do not close up by " << crossfield::CrossAngle(defect)
            << ". Move singularities until they do.");
        }
      }
      MapConversion::WriteMap(result, output);
    });
}

//------------------------------------------------------------------------------
void vtkCrossFieldMap::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "MeshSize: " << this->MeshSize << "\n";
  os << indent << "KeepMesh: " << this->KeepMesh << "\n";
  os << indent << "CapCorners: " << this->CapCorners << "\n";
  os << indent << "RepairHolonomy: " << this->RepairHolonomy << "\n";
  os << indent << "StageSeconds: " << this->StageSeconds[0] << " " << this->StageSeconds[1] << "\n";
}
