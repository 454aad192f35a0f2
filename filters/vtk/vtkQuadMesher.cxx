#include "vtkQuadMesher.h"

#include "ColumnWriting.h"
#include "ConfigurationConversion.h"
#include "CornerConversion.h"
#include "DomainConversion.h"
#include "EnergyConversion.h"
#include "FilterPorts.h"
#include "FilterRun.h"
#include "HolonomyConversion.h"
#include "QuadConversion.h"
#include "QuadWorkflow.h"
#include "SizeConversion.h"
#include "vtkCrossFieldArrayNames.h"

#include "vtkDataSet.h"
#include "vtkFieldData.h"
#include "vtkInformationVector.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <iterator>

vtkStandardNewMacro(vtkQuadMesher);

//------------------------------------------------------------------------------
vtkQuadMesher::vtkQuadMesher()
{
  this->SetNumberOfInputPorts(3);
  this->SetNumberOfOutputPorts(5);
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
  return FilterRun::Run(this, this->ErrorCode, domain,
    [&](const crossfield::Progress& progress)
    {
      const DomainConversion::Domain input = DomainConversion::ReadDomain(domain);
      const crossfield::QuadRequest request =
        this->MakeRequest(domain, singularities, corners, input.plane);
      const crossfield::QuadWorkflowResult result =
        crossfield::MakeQuadMesh(input.domain, request, progress);
      this->ReportWarnings(request, result);
      this->WriteOutputs(result, input.plane, outputVector);
    });
}

//------------------------------------------------------------------------------
crossfield::QuadRequest vtkQuadMesher::MakeRequest(vtkDataSet* domain, vtkDataSet* singularities,
  vtkDataSet* corners, const crossfield::DomainPlane& plane) const
{
  crossfield::QuadRequest request;
  if (singularities != nullptr)
  {
    request.singularities = ConfigurationConversion::ReadConfiguration(singularities, plane);
  }
  request.corners = CornerConversion::ReadCorners(corners, plane);
  request.sizing = SizeConversion::ReadSizing(this->Sizing);
  if (request.sizing == crossfield::Sizing::Field)
  {
    request.prescribedSizes = SizeConversion::ReadSizes(domain, this->SizeArray, plane);
  }
  request.quadSize = this->QuadSize;
  request.quadCount = this->QuadCount;
  request.meshSize = this->MeshSize;
  request.clearance = this->Clearance;
  request.pairs = this->Pairs;
  request.capCorners = this->CapCorners;
  request.repairHolonomy = this->RepairHolonomy;
  request.merge = static_cast<crossfield::BlockMerge>(this->Merge);
  return request;
}

//------------------------------------------------------------------------------
void vtkQuadMesher::ReportWarnings(
  const crossfield::QuadRequest& request, const crossfield::QuadWorkflowResult& result)
{
  if (result.optimum && !result.optimum->converged && !result.optimum->aborted)
  {
    vtkWarningMacro(<< result.optimum->reason);
  }
  if (!crossfield::HasRequestedCount(request, result.quads))
  {
    vtkWarningMacro(<< "No number of quads within 5 % of " << this->QuadCount
                    << " was found for these separatrices; " << result.quads.mesh.quads.size()
                    << " is the nearest; request another number.");
  }
  if (result.flattening && result.flattening->PredictedStretch() > crossfield::NoticeableStretch)
  {
    vtkWarningMacro(<< crossfield::DescribeStretch(*result.flattening)
                    << " Move singularities, or repair the holonomy, to lower it.");
  }
  const crossfield::QuadQuality& quality = result.quads.quality;
  if (quality.inverted > 0)
  {
    vtkWarningMacro(<< quality.inverted << " quads are inverted, the worst near "
                    << crossfield::Describe(quality.where) << "; use a smaller size.");
  }
}

//------------------------------------------------------------------------------
void vtkQuadMesher::WriteOutputs(const crossfield::QuadWorkflowResult& result,
  const crossfield::DomainPlane& plane, vtkInformationVector* outputVector)
{
  vtkUnstructuredGrid* quads = vtkUnstructuredGrid::GetData(outputVector, 0);
  QuadConversion::WriteQuads(result.quads, plane, quads);
  if (result.repair)
  {
    HolonomyConversion::WriteRepair(*result.repair, plane, quads->GetFieldData());
  }
  QuadConversion::WriteBlockCounts(result.blocks, quads->GetFieldData());
  ColumnWriting::AddNumbers(
    quads->GetFieldData(), vtkCrossFieldArrayNames::HolonomyDefect, result.holonomyDefect);
  HolonomyConversion::WriteStretch(result.flattening, quads->GetFieldData());
  EnergyConversion::WriteEvents(result.events, quads);
  QuadConversion::WriteBlocks(result.quads, plane, vtkMultiBlockDataSet::GetData(outputVector, 1));
  QuadConversion::WriteLayout(result.quads, plane, vtkPolyData::GetData(outputVector, 2));

  vtkPolyData* singularities = vtkPolyData::GetData(outputVector, 3);
  ConfigurationConversion::WriteConfiguration(result.singularities, plane, singularities);
  if (result.optimum || !result.events.empty())
  {
    EnergyConversion::WriteEvents(result.events, singularities);
  }
  CornerConversion::WriteChoices(result.corners, plane, vtkPolyData::GetData(outputVector, 4));

  const crossfield::QuadSeconds& seconds = result.seconds;
  const double stages[] = { seconds.mesh, seconds.map, seconds.trace, seconds.integers,
    seconds.layout, seconds.smooth, seconds.choose, seconds.clean };
  std::copy(std::begin(stages), std::end(stages), this->StageSeconds);
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
  os << indent << "Merge: " << this->Merge << "\n";
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
