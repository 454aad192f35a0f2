#include "vtkQuadMesher.h"

#include "AutomaticConfiguration.h"
#include "ColumnWriting.h"
#include "ConfigurationConversion.h"
#include "CornerConversion.h"
#include "DomainConversion.h"
#include "EnergyConversion.h"
#include "FilterPorts.h"
#include "FilterRun.h"
#include "HolonomyConversion.h"
#include "MeshForPoints.h"
#include "QuadConversion.h"
#include "SeamlessMapSolve.h"
#include "SizeConversion.h"
#include "SizeSearch.h"
#include "Stopwatch.h"
#include "TMeshPatches.h"
#include "vtkCrossFieldArrayNames.h"

#include "vtkDataSet.h"
#include "vtkFieldData.h"
#include "vtkInformationVector.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"
#include "vtkUnstructuredGrid.h"

#include <cmath>
#include <string>
#include <utility>
#include <vector>

vtkStandardNewMacro(vtkQuadMesher);

//------------------------------------------------------------------------------
vtkQuadMesher::vtkQuadMesher()
{
  this->SetNumberOfInputPorts(3);
  this->SetNumberOfOutputPorts(3);
}

//------------------------------------------------------------------------------
int vtkQuadMesher::FillInputPortInformation(int port, vtkInformation* info)
{
  return port == 0 ? FilterPorts::AcceptDomain(info) : FilterPorts::AcceptOptionalPoints(info);
}

//------------------------------------------------------------------------------
int vtkQuadMesher::FillOutputPortInformation(int port, vtkInformation* info)
{
  return FilterPorts::Produce(info,
    port == 0     ? "vtkUnstructuredGrid"
      : port == 1 ? "vtkMultiBlockDataSet"
                  : "vtkPolyData");
}

//------------------------------------------------------------------------------
int vtkQuadMesher::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkDataSet* domain = vtkDataSet::GetData(inputVector[0]);
  vtkDataSet* singularities = vtkDataSet::GetData(inputVector[1]);
  vtkDataSet* corners = vtkDataSet::GetData(inputVector[2]);
  vtkUnstructuredGrid* quads = vtkUnstructuredGrid::GetData(outputVector, 0);
  vtkMultiBlockDataSet* blocks = vtkMultiBlockDataSet::GetData(outputVector, 1);
  vtkPolyData* layout = vtkPolyData::GetData(outputVector, 2);
  return FilterRun::Run(this, this->ErrorCode, domain,
    [&](const crossfield::Progress& progress)
    {
      crossfield::Stopwatch stopwatch;
      const DomainConversion::Domain input = DomainConversion::ReadDomain(domain);
      crossfield::SeamlessMapOptions mapOptions;
      mapOptions.corners = CornerConversion::ReadCorners(corners, input.plane);
      mapOptions.capCorners = this->CapCorners;
      crossfield::Configuration configuration =
        ConfigurationConversion::ReadConfiguration(singularities, input.plane);
      std::vector<std::string> events;
      if (singularities == nullptr)
      {
        // As vtkConfigurationProposal does with Automatic.
        crossfield::AutomaticOptions automatic;
        automatic.proposal.corners = mapOptions.corners;
        if (this->CapCorners)
        {
          crossfield::CapCorners(input.domain, automatic);
        }
        automatic.optimizer.meshSize = this->MeshSize;
        automatic.optimizer.clearance = this->Clearance;
        SizeConversion::ChooseForQuads(domain, input,
          { this->Sizing, this->SizeArray, this->QuadSize, this->QuadCount, this->Pairs },
          automatic);
        const crossfield::AutomaticConfiguration choice =
          crossfield::ChooseConfiguration(input.domain, automatic, progress.Part(0.0, 0.5));
        configuration = choice.singularities;
        mapOptions.corners = choice.corners;
        events = choice.events;
        const crossfield::OptimizerResult& optimum = choice.optimum;
        if (!optimum.converged && !optimum.aborted)
        {
          vtkWarningMacro(<< optimum.reason);
        }
      }
      const crossfield::Progress rest = progress.Part(singularities == nullptr ? 0.5 : 0.0, 1.0);
      vtkNew<vtkFieldData> repaired;
      if (this->RepairHolonomy)
      {
        configuration = HolonomyConversion::Repair(input, configuration,
          { mapOptions.corners, this->CapCorners, this->MeshSize }, repaired, rest.Part(0.0, 0.1));
      }
      stopwatch.Lap(); // stages are those of the mesh
      const crossfield::SharedTopology topology = crossfield::ShareTopology(
        crossfield::MeshOnPoints(input.domain, configuration, this->MeshSize, rest.Part(0.1, 0.2)));
      this->StageSeconds[0] = stopwatch.Lap();
      const crossfield::SeamlessMap map =
        crossfield::SolveSeamlessMap(topology, configuration, mapOptions, rest.Part(0.2, 0.5));
      this->StageSeconds[1] = stopwatch.Lap();
      crossfield::QuadOptions options;
      options.size = this->QuadSize;
      options.count = this->QuadCount;
      options.sizes.sizing = this->Sizing == SizingUniform ? crossfield::QuadSizing::Uniform
                                                           : crossfield::QuadSizing::Conformal;
      if (this->Sizing == SizingField)
      {
        const SizeConversion::Sizes sizes =
          SizeConversion::ReadSizes(domain, this->SizeArray, input.plane, *topology);
        options.sizes = { crossfield::QuadSizing::Field, sizes.relative };
        options.size *= sizes.mean;
      }
      options.coarse = this->Coarse;
      stopwatch.Lap();
      crossfield::TMesh separatrices =
        crossfield::MakeTMesh(map, crossfield::TraceLines(map, rest.Part(0.5, 0.6)));
      this->StageSeconds[2] = stopwatch.Lap();
      const crossfield::QuadResult result =
        crossfield::MakeQuads(map, std::move(separatrices), options, rest.Part(0.6, 0.95));
      this->StageSeconds[3] = result.counts.seconds;
      this->StageSeconds[4] = result.layoutSeconds;
      this->StageSeconds[5] = result.smoothSeconds;
      const auto count = static_cast<double>(result.mesh.quads.size());
      if (this->QuadSize == 0.0 &&
        std::abs(count / this->QuadCount - 1.0) > crossfield::CountTolerance)
      {
        vtkWarningMacro(<< "No number of quads within 5 % of " << this->QuadCount
                        << " was found for these lines, " << result.mesh.quads.size()
                        << " is the nearest; ask for another number.");
      }
      if (result.quality.inverted > 0)
      {
        vtkWarningMacro(<< result.quality.inverted << " quads are inverted, the worst near "
                        << crossfield::Describe(result.quality.where) << "; use a smaller size.");
      }
      QuadConversion::WriteQuads(result, input.plane, quads);
      for (int i = 0; i < repaired->GetNumberOfArrays(); ++i)
      {
        quads->GetFieldData()->AddArray(repaired->GetAbstractArray(i));
      }
      ColumnWriting::AddNumbers(
        quads->GetFieldData(), vtkCrossFieldArrayNames::HolonomyDefect, map.holonomyDefect);
      EnergyConversion::WriteEvents(events, quads);
      QuadConversion::WriteBlocks(result, input.plane, blocks);
      QuadConversion::WriteLayout(result, input.plane, layout);
    });
}

//------------------------------------------------------------------------------
void vtkQuadMesher::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "QuadSize: " << this->QuadSize << "\n";
  os << indent << "QuadCount: " << this->QuadCount << "\n";
  os << indent << "Sizing: " << this->Sizing << "\n";
  os << indent << "SizeArray: " << this->SizeArray << "\n";
  os << indent << "Pairs: " << this->Pairs << "\n";
  os << indent << "Coarse: " << this->Coarse << "\n";
  os << indent << "MeshSize: " << this->MeshSize << "\n";
  os << indent << "Clearance: " << this->Clearance << "\n";
  os << indent << "CapCorners: " << this->CapCorners << "\n";
  os << indent << "RepairHolonomy: " << this->RepairHolonomy << "\n";
  os << indent << "StageSeconds:";
  for (const double seconds : this->StageSeconds)
  {
    os << " " << seconds;
  }
  os << "\n";
}
