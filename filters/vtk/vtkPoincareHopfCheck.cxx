#include "vtkPoincareHopfCheck.h"

#include "ColumnWriting.h"
#include "ConfigurationCheck.h"
#include "ConfigurationConversion.h"
#include "ConfigurationPlacement.h"
#include "CornerConversion.h"
#include "CrossFieldArrays.h"
#include "DomainConversion.h"
#include "DrilledMeshConversion.h"
#include "FieldCheck.h"
#include "FilterPorts.h"
#include "FilterRun.h"
#include "MaterialCheck.h"
#include "NamedSurface.h"
#include "RegionConversion.h"
#include "SideText.h"
#include "SingularityRecord.h"
#include "SurfaceConversion.h"
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
struct Findings : crossfield::ConfigurationCheck
{
  bool isField = false;
  std::vector<int> holeDegrees;
  std::vector<int> holeDegreesReliable;
  int unwantedSingularities = 0;
  std::vector<std::string> materials; ///< With several of them, their names.
  crossfield::DomainPlane plane;
};

vtkUnstructuredGrid* AsField(vtkDataSet* domain)
{
  vtkUnstructuredGrid* grid = DrilledMeshConversion::AsDrilledMesh(domain);
  return grid != nullptr && grid->GetCellData()->GetArray(names::CrossFieldCR) != nullptr ? grid
                                                                                          : nullptr;
}

Findings CheckConfiguration(vtkObject* self, vtkDataSet* input, const std::string& materials,
  const std::string& lineNames, vtkDataSet* singularities, vtkDataSet* corners,
  const crossfield::CheckOptions& options, const crossfield::Progress& progress)
{
  Findings result;
  const LineConversion::Lines lines =
    LineConversion::Find(input, "", SideText::ReadNames(lineNames), {});
  if (materials.empty() && lines.names.empty())
  {
    const auto [domain, plane] = DomainConversion::ReadDomain(input, self);
    static_cast<crossfield::ConfigurationCheck&>(result) = crossfield::CheckConfiguration(domain,
      ConfigurationConversion::ReadConfiguration(singularities, plane),
      CornerConversion::ReadCorners(corners, plane), options, progress);
    result.plane = plane;
    return result;
  }
  const RegionConversion::Regions regions = RegionConversion::Read(input, materials, lines, self);
  static_cast<crossfield::ConfigurationCheck&>(result) = crossfield::CheckRegions(regions.set,
    ConfigurationConversion::ReadConfiguration(singularities, regions.plane),
    CornerConversion::ReadCorners(corners, regions.plane), options, progress);
  result.materials = regions.set.materials;
  result.plane = regions.plane;
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

/** Checks singularities of a surface in space, and writes what is known of it. */
crossfield::SurfaceCheck CheckSurface(vtkDataSet* input, const std::string& materials,
  vtkDataSet* singularities, vtkDataSet* corners, double featureAngle, vtkDataSet* output,
  vtkPolyData* cornerOutput)
{
  if (corners != nullptr)
  {
    throw crossfield::Error(
      "The check of a surface in space does not support prescribed corners yet; leave them out.");
  }
  const crossfield::SurfaceCheck check =
    crossfield::CheckSurface(crossfield::PlaceCones(NamedSurface::Read(input, materials).mesh,
      SurfaceConversion::ReadSingularities(singularities), featureAngle));
  SurfaceConversion::WriteCorners(check.corners, cornerOutput);
  output->ShallowCopy(input);
  vtkFieldData* data = output->GetFieldData();
  AddIntegers(data, names::EulerCharacteristic, { check.eulerCharacteristic });
  AddNumbers(data, names::TotalCurvature, { check.totalCurvature });
  AddNumbers(data, names::TangentTurning, { check.tangentTurning });
  AddIntegers(data, names::RequiredInteriorQuarters, { check.requiredQuarters });
  AddIntegers(data, names::GivenInteriorQuarters, { check.givenQuarters });
  AddIntegers(data, names::Consistent, { check.consistent ? 1 : 0 });
  data->RemoveArray(names::HolonomyDefect);
  if (!check.holonomyDefect.empty())
  {
    AddNumbers(data, names::HolonomyDefect, check.holonomyDefect);
  }
  ColumnWriting::AddText(data, names::Reason, check.reason);
  return check;
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
    if (field == nullptr && SurfaceConversion::IsSurface(domain))
    {
      const crossfield::SurfaceCheck result = CheckSurface(domain, this->MaterialArray,
        singularities, corners, vtkMath::RadiansFromDegrees(this->FeatureAngle),
        vtkDataSet::GetData(outputVector, 0), vtkPolyData::GetData(outputVector, 2));
      WriteSummary(result.consistent ? "Consistent" : "Inconsistent", result.reason,
        !result.consistent, summary);
      return;
    }
    const crossfield::CheckOptions options = { vtkMath::RadiansFromDegrees(this->CornerAngle),
      this->CapCorners, this->Holonomy };
    const Findings findings = field != nullptr
      ? CheckField(field, corners, progress)
      : CheckConfiguration(this, domain, MaterialCheck::FindArray(domain, this->MaterialArray),
          this->Lines, singularities, corners, options, progress);
    vtkDataSet* output = vtkDataSet::GetData(outputVector, 0);
    output->ShallowCopy(domain);
    WriteFindings(findings, output->GetFieldData());
    if (!findings.regions.empty())
    {
      RegionConversion::WriteCounts(findings.regions, findings.materials, output->GetFieldData());
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
  os << indent << "FeatureAngle: " << this->FeatureAngle << "\n";
  os << indent << "CapCorners: " << (this->CapCorners ? "on" : "off") << "\n";
  os << indent << "Holonomy: " << (this->Holonomy ? "on" : "off") << "\n";
  os << indent << "MaterialArray: " << this->MaterialArray << "\n";
  os << indent << "Lines: " << this->Lines << "\n";
}
