#include "vtkPoincareHopfCheck.h"

#include "BoundarySingularities.h"
#include "ColumnWriting.h"
#include "ConfigurationConversion.h"
#include "ConfigurationPlacement.h"
#include "CornerConversion.h"
#include "CrossFieldArrays.h"
#include "DomainConversion.h"
#include "DomainQueries.h"
#include "DrilledMeshConversion.h"
#include "FieldCheck.h"
#include "FilterPorts.h"
#include "FilterRun.h"
#include "HolonomyCheck.h"
#include "MaterialCheck.h"
#include "RegionConversion.h"
#include "RegionRequests.h"
#include "SingularityRecord.h"
#include "ViewText.h"
#include "vtkCrossFieldArrayNames.h"

#include "vtkCellData.h"
#include "vtkDataSet.h"
#include "vtkFieldData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"
#include "vtkTable.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <string>

vtkStandardNewMacro(vtkPoincareHopfCheck);

namespace
{
namespace names = vtkCrossFieldArrayNames;
using ColumnWriting::AddIntegers;
using ColumnWriting::AddNumbers;

/** Results of checking a configuration or a field. */
struct Findings
{
  crossfield::PoincareHopfCount count;
  bool consistent = false;
  std::string reason;
  std::vector<double> holonomyDefects;
  bool isField = false;
  std::vector<int> holeDegrees;
  std::vector<int> holeDegreesReliable;
  int unwantedSingularities = 0;
  std::vector<crossfield::RegionReport> regions; ///< With several materials.
  crossfield::DomainPlane plane;
};

vtkUnstructuredGrid* AsField(vtkDataSet* domain)
{
  vtkUnstructuredGrid* grid = DrilledMeshConversion::AsDrilledMesh(domain);
  return grid != nullptr && grid->GetCellData()->GetArray(names::CrossFieldCR) != nullptr ? grid
                                                                                          : nullptr;
}

/** Returns a sentence about corners that were capped; `uncapped` is the required sum without this. */
std::string DescribeCaps(std::size_t corners, int uncapped)
{
  return std::to_string(corners) +
    (corners == 1 ? " very sharp corner counts as an ordinary one"
                  : " very sharp corners count as ordinary ones") +
    ", with one quad; without this the sum is " + std::to_string(uncapped) +
    " (CapCorners, --no-cap-corners).";
}

/** How configurations are checked. */
struct CheckOptions
{
  double cornerAngle = 0.0;
  bool cap = false;
  bool holonomy = true;
};

/** Checks a configuration on a domain with chosen indices of corners. */
Findings CheckDomain(const crossfield::PlanarDomain& domain,
  const crossfield::Configuration& configuration, std::vector<crossfield::CornerChoice> choices,
  const CheckOptions& options, const crossfield::Progress& progress)
{
  Findings result;
  const std::size_t given = choices.size();
  const crossfield::PoincareHopfCount uncapped =
    crossfield::CountQuarters(domain.loops, 0, options.cornerAngle, choices);
  if (options.cap)
  {
    choices = crossfield::CapCorners(uncapped, choices);
  }
  progress.Report(0.1);
  crossfield::RequireInside(domain, configuration);
  std::vector<crossfield::CornerChoice> chosen = choices;
  int interior = crossfield::TotalQuarters(configuration);
  for (const crossfield::CornerChoice& choice : crossfield::BoundaryChoices(domain, configuration))
  {
    chosen.push_back(choice);
    interior -= choice.quarterIndex;
  }
  result.count =
    crossfield::CountQuarters(crossfield::InsertBoundarySingularities(domain, configuration).loops,
      interior, options.cornerAngle, chosen);
  result.consistent = result.count.Consistent();
  if (result.consistent && options.holonomy)
  {
    result.holonomyDefects =
      crossfield::HolonomyDefects(domain, configuration, choices, progress.Part(0.1, 1.0));
  }
  result.reason = crossfield::ConsistencyReason(result.count, result.holonomyDefects);
  if (choices.size() > given)
  {
    result.reason += " " + DescribeCaps(choices.size() - given, uncapped.requiredInteriorQuarters);
  }
  return result;
}

/** Adds up the counts of regions. */
void Add(const crossfield::PoincareHopfCount& part, crossfield::PoincareHopfCount& sum)
{
  sum.eulerCharacteristic += part.eulerCharacteristic;
  sum.valence += part.valence;
  sum.tangentTurning += part.tangentTurning;
  sum.requiredInteriorQuarters += part.requiredInteriorQuarters;
  sum.givenInteriorQuarters += part.givenInteriorQuarters;
  sum.corners.insert(sum.corners.end(), part.corners.begin(), part.corners.end());
}

/** Returns a sentence about the nodes of regions that are irregular nodes of the mesh. */
std::string DescribeNodes(
  const crossfield::RegionSet& set, const crossfield::RegionRequests& requests)
{
  std::string places;
  int count = 0;
  for (std::size_t n = 0; n < set.nodes.size(); ++n)
  {
    const int index = crossfield::IndexAt(set.nodes[n], requests.nodeCorners[n]);
    if (index != 0 && !set.nodes[n].isOnBoundary)
    {
      places += (count++ > 0 ? ", " : "") + crossfield::Describe(set.nodes[n].place) + " (" +
        std::to_string(4 - index) + " quads)";
    }
  }
  return count == 0 ? std::string()
    : count == 1    ? " The node of regions at " + places + " is an irregular node of the mesh."
                    : " The nodes of regions at " + places + " are irregular nodes of the mesh.";
}

/** Checks a configuration in each region of a domain of several materials. */
Findings CheckRegions(const RegionConversion::Regions& regions,
  const crossfield::Configuration& configuration,
  const std::vector<crossfield::CornerChoice>& choices, const CheckOptions& options,
  const crossfield::Progress& progress)
{
  const crossfield::RegionSet& set = regions.set;
  std::vector<crossfield::DomainPart> parts;
  for (const crossfield::Region& region : set.regions)
  {
    parts.push_back({ region.domain, {}, {} });
  }
  crossfield::QuadRequest request;
  request.singularities = configuration;
  request.corners = choices;
  const crossfield::RegionRequests requests = crossfield::SplitForRegions(set, parts, request);
  Findings result;
  result.plane = regions.plane;
  result.consistent = true;
  for (std::size_t r = 0; r < parts.size(); ++r)
  {
    const crossfield::QuadRequest& own = requests.ofRegions[r].request;
    const auto size = static_cast<double>(parts.size());
    const auto number = static_cast<double>(r);
    const Findings found =
      CheckDomain(parts[r].domain, own.singularities.value_or(crossfield::Configuration()),
        own.corners, options, progress.Part(number / size, (number + 1.0) / size));
    Add(found.count, result.count);
    result.holonomyDefects.insert(
      result.holonomyDefects.end(), found.holonomyDefects.begin(), found.holonomyDefects.end());
    result.regions.push_back({ set.regions[r].material, found.count.requiredInteriorQuarters,
      found.count.givenInteriorQuarters, 0 });
    if (!found.consistent)
    {
      result.reason += (result.consistent ? "Material '" : " Material '") +
        set.materials[static_cast<std::size_t>(set.regions[r].material)] + "' near " +
        crossfield::Describe(parts[r].domain.loops[0][0]) + ": " + found.reason;
      result.consistent = false;
    }
  }
  if (result.consistent)
  {
    result.reason = "The quarter indices in each of the " + std::to_string(parts.size()) +
      " regions add up to the sum that its corners require.";
  }
  result.reason += DescribeNodes(set, requests);
  return result;
}

Findings CheckField(
  vtkUnstructuredGrid* input, vtkDataSet* corners, const crossfield::Progress& progress)
{
  Findings result;
  const DrilledMeshConversion::DrilledMesh cells = DrilledMeshConversion::ReadDrilledMesh(input);
  progress.Report(0.5);
  std::vector<crossfield::CornerChoice> choices =
    CornerConversion::ReadCorners(corners, cells.plane);
  // Singularities prescribed in vtkHField or vtkDrillHoles. Singularities on the boundary are
  // prescribed corners.
  vtkFieldData* data = input->GetFieldData();
  crossfield::Configuration points =
    SingularityRecord::Read(names::PointSingularities, cells.plane, data);
  for (const crossfield::Singularity& singularity :
    SingularityRecord::Read(names::BoundarySingularities, cells.plane, data))
  {
    points.push_back(singularity);
  }
  if (!points.empty())
  {
    crossfield::PlacedConfiguration placed =
      crossfield::PlaceConfiguration(*cells.topology, points, choices);
    points = std::move(placed.interior);
    choices = std::move(placed.corners);
  }
  // Only vtkGinzburgLandauCrossField writes this array; its singularities are not prescribed.
  const bool isUnconstrained = data->GetArray(names::ConvexifiedSteps) != nullptr;
  const crossfield::FieldCheck check = crossfield::CheckField(
    CrossFieldArrays::ReadField(cells, input), choices, points, isUnconstrained);
  result.count = check.count;
  result.consistent = check.asPrescribed;
  result.reason = check.reason;
  result.isField = true;
  for (const crossfield::HoleReading& hole : check.holes)
  {
    result.holeDegrees.push_back(hole.degree);
    result.holeDegreesReliable.push_back(hole.Reliable() ? 1 : 0);
  }
  result.unwantedSingularities = check.unwantedSingularities;
  result.plane = cells.plane;
  return result;
}

void WriteFindings(const Findings& findings, vtkFieldData* data)
{
  const crossfield::PoincareHopfCount& count = findings.count;
  AddIntegers(data, names::EulerCharacteristic, { count.eulerCharacteristic });
  AddNumbers(data, names::Valence, { count.valence });
  AddNumbers(data, names::TangentTurning, { count.tangentTurning });
  AddIntegers(data, names::RequiredInteriorQuarters, { count.requiredInteriorQuarters });
  AddIntegers(data, names::GivenInteriorQuarters, { count.givenInteriorQuarters });
  AddIntegers(data, names::Consistent, { findings.consistent ? 1 : 0 });
  CornerConversion::WriteAmbiguous(crossfield::CountAmbiguous(count), data);
  if (findings.isField)
  {
    AddIntegers(data, names::HoleDegree, findings.holeDegrees);
    AddIntegers(data, names::HoleDegreeReliable, findings.holeDegreesReliable);
    AddIntegers(data, names::UnwantedSingularities, { findings.unwantedSingularities });
  }
  else
  {
    // An array of the input belongs to another configuration.
    data->RemoveArray(names::HolonomyDefect);
  }
  if (!findings.holonomyDefects.empty())
  {
    AddNumbers(data, names::HolonomyDefect, findings.holonomyDefects);
  }
  ColumnWriting::AddText(data, names::Reason, findings.reason);
}

/** Writes a heading and, below it, the reason. */
void WriteSummary(const char* heading, const std::string& reason, bool isAlarm, vtkTable* table)
{
  ViewText::Write(
    names::Summary, std::string(heading) + "\n" + ViewText::WrapLines(reason), isAlarm, table);
}
}

//------------------------------------------------------------------------------
vtkPoincareHopfCheck::vtkPoincareHopfCheck()
{
  this->SetNumberOfInputPorts(3);
  this->SetNumberOfOutputPorts(4);
}

//------------------------------------------------------------------------------
int vtkPoincareHopfCheck::FillInputPortInformation(int port, vtkInformation* info)
{
  return port == 0 ? FilterPorts::AcceptDomain(info) : FilterPorts::AcceptOptionalPoints(info);
}

//------------------------------------------------------------------------------
int vtkPoincareHopfCheck::FillOutputPortInformation(int port, vtkInformation* info)
{
  const char* const types[4] = { "vtkDataSet", "vtkTable", "vtkPolyData", "vtkTable" };
  return FilterPorts::Produce(info, types[port]);
}

//------------------------------------------------------------------------------
int vtkPoincareHopfCheck::RequestDataObject(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkDataSet* input = vtkDataSet::GetData(inputVector[0]);
  if (input == nullptr)
  {
    return 0;
  }
  const auto provide = [outputVector](int port, const char* type, auto create)
  {
    vtkInformation* info = outputVector->GetInformationObject(port);
    vtkDataObject* output = info->Get(vtkDataObject::DATA_OBJECT());
    if (output == nullptr || !output->IsA(type))
    {
      info->Set(vtkDataObject::DATA_OBJECT(), create());
    }
  };
  provide(0, input->GetClassName(),
    [input] { return vtkSmartPointer<vtkDataObject>::Take(input->NewInstance()); });
  provide(1, "vtkTable", [] { return vtkSmartPointer<vtkTable>::New(); });
  provide(3, "vtkTable", [] { return vtkSmartPointer<vtkTable>::New(); });
  provide(2, "vtkPolyData", [] { return vtkSmartPointer<vtkPolyData>::New(); });
  return 1;
}

//------------------------------------------------------------------------------
int vtkPoincareHopfCheck::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkDataSet* domain = vtkDataSet::GetData(inputVector[0]);
  vtkDataSet* singularities = vtkDataSet::GetData(inputVector[1]);
  vtkDataSet* corners = vtkDataSet::GetData(inputVector[2]);
  vtkTable* summary = vtkTable::GetData(outputVector, 3);
  const auto check = [&](const crossfield::Progress& progress)
  {
    vtkUnstructuredGrid* field = AsField(domain);
    const CheckOptions options = { vtkMath::RadiansFromDegrees(this->CornerAngle), this->CapCorners,
      this->Holonomy };
    const std::string materials =
      field != nullptr ? std::string() : MaterialCheck::FindArray(domain, this->MaterialArray);
    Findings findings;
    std::vector<std::string> names;
    if (field != nullptr)
    {
      findings = CheckField(field, corners, progress);
    }
    else if (!materials.empty())
    {
      const RegionConversion::Regions regions = RegionConversion::Read(domain, materials);
      names = regions.set.materials;
      findings = CheckRegions(regions,
        ConfigurationConversion::ReadConfiguration(singularities, regions.plane),
        CornerConversion::ReadCorners(corners, regions.plane), options, progress);
    }
    else
    {
      const auto [outline, plane] = DomainConversion::ReadDomain(domain, this);
      findings =
        CheckDomain(outline, ConfigurationConversion::ReadConfiguration(singularities, plane),
          CornerConversion::ReadCorners(corners, plane), options, progress);
      findings.plane = plane;
    }
    vtkDataSet* output = vtkDataSet::GetData(outputVector, 0);
    output->ShallowCopy(domain);
    WriteFindings(findings, output->GetFieldData());
    if (!findings.regions.empty())
    {
      RegionConversion::WriteCounts(findings.regions, names, output->GetFieldData());
    }
    CornerConversion::WriteLoopTable(
      findings.count, findings.holonomyDefects, vtkTable::GetData(outputVector, 1));
    CornerConversion::WriteCountedCorners(
      findings.count.corners, findings.plane, vtkPolyData::GetData(outputVector, 2));
    WriteSummary(findings.consistent ? "Consistent" : "Inconsistent", findings.reason,
      !findings.consistent, summary);
  };
  FilterRun::Run(this, this->ErrorCode, domain, check,
    [summary](const char* sentence) { WriteSummary("Not checked", sentence, true, summary); });
  // Returning 0 after an error would keep a view from redrawing, and it would still show the last
  // result.
  return 1;
}

//------------------------------------------------------------------------------
void vtkPoincareHopfCheck::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "CornerAngle: " << this->CornerAngle << "\n";
  os << indent << "CapCorners: " << (this->CapCorners ? "on" : "off") << "\n";
  os << indent << "Holonomy: " << (this->Holonomy ? "on" : "off") << "\n";
  os << indent << "MaterialArray: " << this->MaterialArray << "\n";
}
