#include "vtkQuadMesher.h"

#include "ColumnWriting.h"
#include "CompositeInput.h"
#include "ConfigurationConversion.h"
#include "CornerConversion.h"
#include "DomainConversion.h"
#include "EnergyConversion.h"
#include "FilterPorts.h"
#include "FilterRun.h"
#include "HolonomyConversion.h"
#include "JoinedParts.h"
#include "MaterialCheck.h"
#include "NamedSurface.h"
#include "PeriodicConversion.h"
#include "QuadBoundary.h"
#include "QuadConversion.h"
#include "QuadReport.h"
#include "RegionConversion.h"
#include "RegionQuads.h"
#include "RegionRequests.h"
#include "SegmentCurveConversion.h"
#include "SideConversion.h"
#include "SideText.h"
#include "SizeConversion.h"
#include "SurfaceConversion.h"
#include "ViewText.h"
#include "vtkCrossFieldArrayNames.h"

#include "vtkDataSet.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkInformationVector.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"
#include "vtkStringArray.h"
#include "vtkTable.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <iterator>
#include <optional>
#include <utility>

vtkStandardNewMacro(vtkQuadMesher);

namespace
{
constexpr int SidePort = 3; // of the inputs
constexpr int BoundaryPort = 5;
constexpr int SummaryPort = 8;
}

//------------------------------------------------------------------------------
vtkQuadMesher::vtkQuadMesher()
{
  this->SetNumberOfInputPorts(4);
  this->SetNumberOfOutputPorts(9);
  this->SidePlaces->SetNumberOfComponents(3);
}

//------------------------------------------------------------------------------
vtkStringArray* vtkQuadMesher::GetSideNames()
{
  return this->SideNames;
}

//------------------------------------------------------------------------------
vtkDoubleArray* vtkQuadMesher::GetSidePlaces()
{
  return this->SidePlaces;
}

//------------------------------------------------------------------------------
int vtkQuadMesher::FillInputPortInformation(int port, vtkInformation* info)
{
  return port == 0     ? FilterPorts::AcceptDomains(info)
    : port == SidePort ? FilterPorts::AcceptOptionalTable(info)
                       : FilterPorts::AcceptOptionalPoints(info);
}

//------------------------------------------------------------------------------
int vtkQuadMesher::FillOutputPortInformation(int port, vtkInformation* info)
{
  if (port == 0)
  {
    QuadBoundary::Declare(info, BoundaryPort);
  }
  return FilterPorts::Produce(info,
    port == 0               ? "vtkUnstructuredGrid"
      : port == 1           ? "vtkMultiBlockDataSet"
      : port == SummaryPort ? "vtkTable"
                            : "vtkPolyData");
}

//------------------------------------------------------------------------------
int vtkQuadMesher::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  const vtkSmartPointer<vtkDataSet> domain = CompositeInput::Append(inputVector[0]);
  vtkDataSet* singularities = vtkDataSet::GetData(inputVector[1]);
  vtkDataSet* corners = vtkDataSet::GetData(inputVector[2]);
  return FilterRun::Run(
    this, this->ErrorCode, domain,
    [&](const crossfield::Progress& progress)
    {
      if (SurfaceConversion::IsSurface(domain))
      {
        this->RequireOptionsOfSurfaces(inputVector);
        const NamedSurface surface =
          NamedSurface::Read(domain, this->MaterialArray, this->SideNameArray);
        const crossfield::QuadWorkflowResult result = crossfield::MakeQuadsOfSurface(surface.mesh,
          this->MakeSurfaceRequest(
            domain, singularities, vtkTable::GetData(inputVector[SidePort]), surface),
          progress);
        this->Warn(result);
        this->WriteOutputs(result, crossfield::DomainPlane(), outputVector);
        this->WriteRegions(surface.regions, result, outputVector);
        // Numerics of the plane have no singularities in space; the irregular nodes are those.
        vtkPolyData* used = vtkPolyData::GetData(outputVector, 3);
        used->ShallowCopy(vtkPolyData::GetData(outputVector, 6));
        if (!result.events.empty())
        {
          EnergyConversion::WriteEvents(result.events, used);
        }
        return;
      }
      if (this->ChordError > 0.0)
      {
        throw crossfield::Error("A domain in a plane has no chord error; leave it out (ChordError, "
                                "--chord-error), or give sizes.");
      }
      const std::string materialArray = MaterialCheck::FindArray(domain, this->MaterialArray);
      const std::vector<std::string> open = SideText::ReadNames(this->OpenLines);
      const LineConversion::Lines lines =
        LineConversion::Find(domain, this->SideNameArray, SideText::ReadNames(this->Lines), open);
      std::optional<RegionConversion::Regions> regions;
      if (!materialArray.empty() || !lines.names.empty())
      {
        regions = RegionConversion::Read(domain, materialArray, lines, this);
      }
      const std::vector<DomainConversion::Domain> input =
        regions ? regions->Domains() : DomainConversion::ReadParts(domain, this);
      const crossfield::DomainPlane& plane = input[0].plane;
      const std::vector<crossfield::BoundarySides> sides = SideConversion::ReadSides(
        domain, this->SideNameArray, input, regions ? &regions->set : nullptr);
      crossfield::RegionSet none;
      crossfield::OpenInterfaces(open, regions ? regions->set : none);
      std::vector<crossfield::DomainPart> parts;
      for (std::size_t p = 0; p < input.size(); ++p)
      {
        parts.push_back(
          { input[p].domain, sides[p], SegmentCurveConversion::Read(domain, input[p]) });
      }
      crossfield::QuadRequest request = this->MakeRequest(domain, singularities, corners, plane);
      this->PrescribeSides(vtkTable::GetData(inputVector[SidePort]), plane, request);
      crossfield::QuadWorkflowResult result = regions
        ? crossfield::MakeQuadsOfRegions(regions->set, parts, request, progress)
        : crossfield::MakeQuadsOfParts(parts, request, progress);
      const std::string materials = regions ? std::string() : MaterialCheck::Warning(domain);
      if (!materials.empty() && this->MaterialArray.empty())
      {
        result.warnings.push_back(materials);
      }
      this->Warn(result);
      this->WriteOutputs(result, plane, outputVector);
      this->WriteRegions(regions ? regions->values : RegionValues(), result, outputVector);
    },
    [&](const char* message)
    {
      this->SidePlaces->SetNumberOfTuples(0); // names stay, to choose the right one
      ViewText::Write(vtkCrossFieldArrayNames::Summary, ViewText::WrapLines(message), true,
        vtkTable::GetData(outputVector, SummaryPort));
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
  for (const auto& [x, y, z] : this->Nodes)
  {
    request.nodes.push_back(plane.RequireInPlane({ x, y, z }, "The position of a node"));
  }
  for (const crossfield::Singularity& one :
    request.singularities.value_or(crossfield::Configuration()))
  {
    if (one.quarterIndex == 0)
    {
      request.nodes.push_back(one.position);
    }
  }
  request.corners = CornerConversion::ReadCorners(corners, plane);
  if (this->Sizing != SizingAutomatic)
  {
    request.sizing = SizeConversion::ReadSizing(this->Sizing);
  }
  if (request.sizing == crossfield::Sizing::Field)
  {
    request.prescribedSizes = SizeConversion::ReadSizes(domain, this->SizeArray, plane);
  }
  request.quadSize = this->QuadSize;
  request.quadCount = this->QuadCount;
  request.minimumSize = this->MinimumSize;
  request.maximumSize = this->MaximumSize;
  request.growth = this->Growth;
  for (const auto& [x, y, z, size, radius] : this->SizesNear)
  {
    request.sizesNear.push_back(
      { plane.RequireInPlane({ x, y, z }, "The position of a size"), size, radius });
  }
  request.meshSize = this->MeshSize;
  request.clearance = this->Clearance;
  request.pairs = this->Pairs;
  request.capCorners = this->CapCorners;
  request.hold = this->HoldSingularities;
  request.repairHolonomy = this->RepairHolonomy;
  request.repairPart = this->RepairPart;
  request.split = this->SplitSingularities;
  request.merge = static_cast<crossfield::BlockMerge>(this->Merge);
  if (this->Prefer != PreferEnergy)
  {
    request.preference = static_cast<crossfield::MeshPreference>(this->Prefer - PreferNodes);
  }
  request.alternative = this->Alternative;
  return request;
}

//------------------------------------------------------------------------------
crossfield::SurfaceRequest vtkQuadMesher::MakeSurfaceRequest(
  vtkDataSet* domain, vtkDataSet* singularities, vtkTable* table, const NamedSurface& surface) const
{
  crossfield::SurfaceRequest request;
  if (singularities != nullptr)
  {
    request.singularities = SurfaceConversion::ReadSingularities(singularities);
  }
  request.quadSize = this->QuadSize;
  request.quadCount = this->QuadCount;
  request.hold = this->HoldSingularities;
  request.coarse = this->Merge == MergeCoarse;
  request.featureAngle = vtkMath::RadiansFromDegrees(this->FeatureAngle);
  request.names = surface.names;
  crossfield::SurfaceSizes& sizes = request.sizes;
  sizes.isUniform = this->Sizing == SizingUniform;
  sizes.chordError = this->ChordError;
  for (const auto& [x, y, z, size, radius] : this->SizesNear)
  {
    sizes.near.push_back({ { x, y, z }, size, radius });
  }
  if (this->Sizing == SizingField)
  {
    sizes.length = SizeConversion::ReadSizesOnSurface(domain, this->SizeArray);
  }
  sizes.minimum = this->MinimumSize;
  sizes.maximum = this->MaximumSize;
  sizes.growth = this->Growth;
  crossfield::QuadRequest sides;
  for (const SideText::Row& row : this->RowsOfSides(table))
  {
    SideText::Prescribe(row, crossfield::DomainPlane(), sides);
  }
  for (const crossfield::SideRequest& one : sides.sideRequests)
  {
    if (one.progression || one.curve || one.layer || one.inside > 0.0 || !one.partner.empty())
    {
      throw crossfield::Error("Of the side '" + one.side +
        "' of a surface in space only the number of edges and their size can be prescribed yet; leave the rest out.");
    }
    request.sides.push_back({ one.side, one.count, one.size });
  }
  return request;
}

//------------------------------------------------------------------------------
std::vector<SideText::Row> vtkQuadMesher::RowsOfSides(vtkTable* table) const
{
  std::vector<SideText::Row> rows;
  if (table != nullptr)
  {
    rows = SideConversion::ReadTable(table);
  }
  for (const std::array<std::string, 4>& texts : this->Sides)
  {
    rows.emplace_back();
    rows.back().side = texts[0];
    rows.back().count = texts[1];
    rows.back().progression = texts[2];
    rows.back().size = texts[3];
  }
  return rows;
}

//------------------------------------------------------------------------------
/** Adds what the table and the properties prescribe for sides. */
void vtkQuadMesher::PrescribeSides(
  vtkTable* table, const crossfield::DomainPlane& plane, crossfield::QuadRequest& request) const
{
  std::vector<SideText::Row> rows = this->RowsOfSides(table);
  for (const std::array<std::string, 2>& texts : this->SizesInside)
  {
    rows.emplace_back();
    rows.back().side = texts[0];
    rows.back().sizeInside = texts[1];
  }
  for (const std::vector<SideText::Row>& more : { SideText::ReadLayers(this->Layers),
         SideText::ReadPartners(this->Periodic), SideText::ReadCornerRows(this->CornerRows) })
  {
    rows.insert(rows.end(), more.begin(), more.end());
  }
  for (const SideText::Row& row : rows)
  {
    SideText::Prescribe(row, plane, request);
  }
  const crossfield::CurveRequest curves = SideText::ReadCurves(this->Curves);
  for (const crossfield::CurveDeclaration& declaration : curves.declared)
  {
    request.sideRequests.emplace_back();
    request.sideRequests.back().side = declaration.side;
    request.sideRequests.back().curve = declaration.kind;
  }
  request.findsArcs = curves.findsArcs;
}

//------------------------------------------------------------------------------
void vtkQuadMesher::Warn(const crossfield::QuadWorkflowResult& result)
{
  for (const std::string& warning : result.warnings)
  {
    vtkWarningMacro(<< warning);
  }
}

//------------------------------------------------------------------------------
void vtkQuadMesher::RequireOptionsOfSurfaces(vtkInformationVector** inputVector) const
{
  const std::pair<bool, const char*> options[] = {
    { vtkDataSet::GetData(inputVector[2]) != nullptr, "prescribed corners" },
    { !this->SizesInside.empty(), "sizes inside of closed sides" },
    { !this->Nodes.empty(), "nodes at positions" },
    { !this->Layers.empty(), "boundary layers" },
    { !this->Periodic.empty(), "periodic sides" },
    { !this->Curves.empty(), "curves of the boundary" },
    { !this->CornerRows.empty(), "rules for rows at corners" },
    { !this->Lines.empty() || !this->OpenLines.empty(), "lines inside" },
    { this->MeshSize > 0.0, "a mesh size" },
    { this->Merge == MergeClean, "fewer blocks by moving singularities" },
    { this->Prefer != PreferEnergy || this->Alternative != 0 || this->Pairs != 0 ||
        this->Clearance > 0.0,
      "choosing singularities" },
    { this->RepairHolonomy || this->SplitSingularities, "moving or splitting singularities" },
  };
  for (const auto& [isSet, what] : options)
  {
    if (isSet)
    {
      throw crossfield::Error("Quads of a surface in space do not support " + std::string(what) +
        " yet; leave this option out.");
    }
  }
}

//------------------------------------------------------------------------------
void vtkQuadMesher::WriteRegions(const RegionValues& regions,
  const crossfield::QuadWorkflowResult& result, vtkInformationVector* outputVector)
{
  if (!result.regions.empty())
  {
    RegionConversion::Write(regions, result, vtkUnstructuredGrid::GetData(outputVector, 0),
      vtkMultiBlockDataSet::GetData(outputVector, 1),
      vtkPolyData::GetData(outputVector, BoundaryPort),
      vtkTable::GetData(outputVector, SummaryPort)->GetFieldData());
  }
}

//------------------------------------------------------------------------------
void vtkQuadMesher::WriteOutputs(const crossfield::QuadWorkflowResult& result,
  const crossfield::DomainPlane& plane, vtkInformationVector* outputVector)
{
  const crossfield::QuadMesh& mesh = result.quads.mesh;
  QuadConversion::WriteQuads(result.quads, plane, vtkUnstructuredGrid::GetData(outputVector, 0));
  QuadConversion::WriteBlocks(result.quads, plane, vtkMultiBlockDataSet::GetData(outputVector, 1));
  QuadConversion::WriteParts(result, vtkUnstructuredGrid::GetData(outputVector, 0),
    vtkMultiBlockDataSet::GetData(outputVector, 1));
  QuadConversion::WriteLayout(result.quads, plane, vtkPolyData::GetData(outputVector, 2));

  vtkPolyData* singularities = vtkPolyData::GetData(outputVector, 3);
  ConfigurationConversion::WriteConfiguration(result.singularities, plane, singularities);
  if (result.optimum || !result.events.empty())
  {
    EnergyConversion::WriteEvents(result.events, singularities);
  }
  CornerConversion::WriteChoices(result.corners, plane, vtkPolyData::GetData(outputVector, 4));
  QuadConversion::WriteBoundary(
    mesh, result.boundary, plane, vtkPolyData::GetData(outputVector, BoundaryPort));
  PeriodicConversion::Write(
    mesh, plane, vtkPolyData::GetData(outputVector, BoundaryPort)->GetFieldData());
  QuadConversion::WriteIrregularNodes(mesh, plane, vtkPolyData::GetData(outputVector, 6));
  QuadConversion::WriteSeparatrices(result.quads, plane, vtkPolyData::GetData(outputVector, 7));
  SideConversion::WritePlaces(mesh, plane, this->SideNames, this->SidePlaces);
  this->WriteSummary(result, plane, vtkTable::GetData(outputVector, SummaryPort));

  const crossfield::QuadSeconds& seconds = result.seconds;
  const double stages[] = { seconds.mesh, seconds.map, seconds.trace, seconds.integers,
    seconds.layout, seconds.smooth, seconds.choose, seconds.clean };
  std::copy(std::begin(stages), std::end(stages), this->StageSeconds);
}

//------------------------------------------------------------------------------
void vtkQuadMesher::WriteSummary(const crossfield::QuadWorkflowResult& result,
  const crossfield::DomainPlane& plane, vtkTable* summary) const
{
  vtkFieldData* report = summary->GetFieldData();
  QuadReport::Write(result.quads, plane, report);
  if (result.repair)
  {
    HolonomyConversion::WriteRepair(*result.repair, plane, report);
  }
  ColumnWriting::AddIntegers(report, vtkCrossFieldArrayNames::Parts, { result.PartCount() });
  QuadReport::WriteBlockCounts(result.blocks, report);
  QuadReport::WriteLayers(result.layers, report);
  QuadReport::WriteCurves(result, report);
  QuadReport::WriteMoves(result, plane, report);
  PeriodicConversion::WriteReport(result.quads.mesh, plane, report);
  ColumnWriting::AddNumbers(report, vtkCrossFieldArrayNames::HolonomyDefect, result.holonomyDefect);
  ColumnWriting::AddNumbers(report, vtkCrossFieldArrayNames::Moved, { result.moved });
  HolonomyConversion::WriteStretch(result.flattening, report);
  CornerConversion::WriteAmbiguous(result.ambiguousCorners, report);
  EnergyConversion::WriteEvents(result.events, summary);
  EnergyConversion::WriteWarnings(result.warnings, summary);
  QuadReport::WriteAttempts(result.attempts, report);
  QuadReport::WriteAlternatives(result.alternatives, report);
  QuadReport::WriteSizes(result.sizes, report);
  ViewText::Write(vtkCrossFieldArrayNames::Summary,
    ViewText::WrapLines(QuadReport::Summary(result)),
    result.quads.quality.inverted > 0 || !result.warnings.empty(), summary);
}

//------------------------------------------------------------------------------
void vtkQuadMesher::CopyMesh(vtkUnstructuredGrid* mesh)
{
  QuadConversion::Combine(
    this->GetOutput(), vtkPolyData::SafeDownCast(this->GetOutputDataObject(BoundaryPort)), mesh);
  mesh->GetFieldData()->DeepCopy(this->GetOutputDataObject(SummaryPort)->GetFieldData());
  mesh->GetFieldData()->RemoveArray(vtkCrossFieldArrayNames::Alarm);
  SegmentCurveConversion::CopyCurves(
    vtkPolyData::SafeDownCast(this->GetOutputDataObject(BoundaryPort)), mesh);
}

//------------------------------------------------------------------------------
void vtkQuadMesher::AddSide(const std::string& name, const std::string& count,
  const std::string& progression, const std::string& size)
{
  this->Sides.push_back({ name, count, progression, size });
  this->Modified();
}

//------------------------------------------------------------------------------
void vtkQuadMesher::AddSide(
  const char* name, const char* count, const char* progression, const char* size)
{
  const auto text = [](const char* given) { return std::string(given ? given : ""); };
  if (!text(name).empty())
  {
    this->AddSide(text(name), text(count), text(progression), text(size));
  }
}

//------------------------------------------------------------------------------
void vtkQuadMesher::ClearSides()
{
  if (!this->Sides.empty())
  {
    this->Sides.clear();
    this->Modified();
  }
}

//------------------------------------------------------------------------------
void vtkQuadMesher::AddSizeInside(const std::string& name, const std::string& size)
{
  this->SizesInside.push_back({ name, size });
  this->Modified();
}

//------------------------------------------------------------------------------
void vtkQuadMesher::AddSizeInside(const char* name, const char* size)
{
  if (name != nullptr && *name != '\0')
  {
    this->AddSizeInside(std::string(name), std::string(size ? size : ""));
  }
}

//------------------------------------------------------------------------------
void vtkQuadMesher::ClearSizesInside()
{
  if (!this->SizesInside.empty())
  {
    this->SizesInside.clear();
    this->Modified();
  }
}

//------------------------------------------------------------------------------
void vtkQuadMesher::AddSizeNear(double x, double y, double z, double size, double radius)
{
  this->SizesNear.push_back({ x, y, z, size, radius });
  this->Modified();
}

//------------------------------------------------------------------------------
void vtkQuadMesher::ClearSizesNear()
{
  if (!this->SizesNear.empty())
  {
    this->SizesNear.clear();
    this->Modified();
  }
}

//------------------------------------------------------------------------------
void vtkQuadMesher::AddNode(double x, double y, double z)
{
  this->Nodes.push_back({ x, y, z });
  this->Modified();
}

//------------------------------------------------------------------------------
void vtkQuadMesher::ClearNodes()
{
  if (!this->Nodes.empty())
  {
    this->Nodes.clear();
    this->Modified();
  }
}

//------------------------------------------------------------------------------
void vtkQuadMesher::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "QuadSize: " << this->QuadSize << "\n";
  os << indent << "QuadCount: " << this->QuadCount << "\n";
  os << indent << "Sizing: " << this->Sizing << "\n";
  os << indent << "SizeArray: " << this->SizeArray << "\n";
  os << indent << "SideNameArray: " << this->SideNameArray << "\n";
  os << indent << "MaterialArray: " << this->MaterialArray << "\n";
  os << indent << "Lines: " << this->Lines << "\n";
  os << indent << "OpenLines: " << this->OpenLines << "\n";
  os << indent << "Nodes: " << this->Nodes.size() << "\n";
  os << indent << "Sides: " << this->Sides.size() << "\n";
  os << indent << "SizesInside: " << this->SizesInside.size() << "\n";
  os << indent << "SizesNear: " << this->SizesNear.size() << "\n";
  os << indent << "Growth: " << this->Growth << "\n";
  os << indent << "MinimumSize: " << this->MinimumSize << "\n";
  os << indent << "MaximumSize: " << this->MaximumSize << "\n";
  os << indent << "Pairs: " << this->Pairs << "\n";
  os << indent << "Merge: " << this->Merge << "\n";
  os << indent << "Prefer: " << this->Prefer << "\n";
  os << indent << "Alternative: " << this->Alternative << "\n";
  os << indent << "MeshSize: " << this->MeshSize << "\n";
  os << indent << "Clearance: " << this->Clearance << "\n";
  os << indent << "CapCorners: " << this->CapCorners << "\n";
  os << indent << "HoldSingularities: " << this->HoldSingularities << "\n";
  os << indent << "FeatureAngle: " << this->FeatureAngle << "\n";
  os << indent << "ChordError: " << this->ChordError << "\n";
  os << indent << "RepairHolonomy: " << this->RepairHolonomy << "\n";
  os << indent << "RepairPart: " << this->RepairPart << "\n";
  os << indent << "SplitSingularities: " << this->SplitSingularities << "\n";
  os << indent << "Layers: " << this->Layers << "\n";
  os << indent << "Periodic: " << this->Periodic << "\n";
  os << indent << "CornerRows: " << this->CornerRows << "\n";
  os << indent << "Curves: " << this->Curves << "\n";
  os << indent << "StageSeconds:";
  for (const double seconds : this->StageSeconds)
  {
    os << " " << seconds;
  }
  os << "\n";
}
