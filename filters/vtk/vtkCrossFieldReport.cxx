#include "vtkCrossFieldReport.h"

#include "Json.h"
#include "UsedPoints.h"
#include "vtkCrossFieldArrayNames.h"

#include "vtkCellType.h"
#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkIdTypeArray.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkStringArray.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <cctype>
#include <set>

namespace names = vtkCrossFieldArrayNames;

vtkStandardNewMacro(vtkCrossFieldReport);

namespace
{
using Json = nlohmann::ordered_json;

/** Arrays of integers that are flags. */
const std::set<std::string> Flags = { names::Cancellable, names::Consistent, names::Converged,
  names::DegreesReached, names::Feasible, names::HoleDegreeReliable, names::IntegerOptimal,
  names::Overridden, names::StartedFromUnitNorm, names::Tied, names::UnitHoles };
/** Arrays of field data with any number of tuples. */
const std::set<std::string> Lists = { names::Annihilation, names::BoundaryRemovedCorners,
  names::BoundarySingularities, names::DefectBefore, names::Events, names::HoleDegree,
  names::HoleDegreeReliable, names::HoleNormRange, names::HolonomyDefect, names::PointSingularities,
  names::Warnings };

/**
 * An array and its key, by default its name after a prefix. If its values have names, they are an object, or entries of
 * their own without a key.
 */
struct Entry
{
  Entry(const char* name)
    : array(name)
  {
  }
  Entry(const char* givenKey, const char* name, const std::vector<std::string>& components = {})
    : array(name)
    , key(givenKey)
    , parts(components)
  {
  }

  std::string array;
  std::string key;
  std::vector<std::string> parts;
};
using Entries = std::vector<Entry>;

/** Returns "hole_degree" for "HoleDegree". */
std::string KeyOf(const std::string& name)
{
  std::string key;
  for (const char character : name)
  {
    const int code = static_cast<unsigned char>(character);
    key += std::isupper(code) != 0 && !key.empty() ? "_" : "";
    key += static_cast<char>(std::tolower(code));
  }
  return key;
}

/** Returns a number, flag or text. */
Json ValueOf(vtkAbstractArray* array, vtkIdType index)
{
  if (auto* texts = vtkStringArray::SafeDownCast(array))
  {
    return texts->GetValue(index);
  }
  const int size = array->GetNumberOfComponents();
  const double value =
    vtkDataArray::SafeDownCast(array)->GetComponent(index / size, static_cast<int>(index % size));
  const std::string name = array->GetName();
  const bool isReal = array->GetDataType() == VTK_DOUBLE || array->GetDataType() == VTK_FLOAT;
  if (isReal && name != names::QuarterIndex) // which is real in some files of users
  {
    return value;
  }
  return Flags.count(name) > 0 ? Json(value != 0.0) : Json(static_cast<long long>(value));
}

/** Returns a value for each tuple, or a list if tuples have several components. */
Json ListOf(vtkAbstractArray* array)
{
  Json list = Json::array();
  const int size = array->GetNumberOfComponents();
  for (vtkIdType i = 0; i < array->GetNumberOfValues(); ++i)
  {
    if (size > 1 && i % size == 0)
    {
      list.push_back(Json::array());
    }
    (size > 1 ? list.back() : list).push_back(ValueOf(array, i));
  }
  return list;
}

constexpr vtkIdType WholeFieldData = -1;

/** Returns the values in a row of those arrays that exist, or the field data. */
Json RowOf(
  vtkFieldData* arrays, vtkIdType row, const Entries& entries, const std::string& prefix = "")
{
  Json values = Json::object();
  for (const Entry& entry : entries)
  {
    vtkAbstractArray* array = arrays->GetAbstractArray(entry.array.c_str());
    if (array == nullptr)
    {
      continue;
    }
    vtkIdType index = std::max<vtkIdType>(row, 0) * array->GetNumberOfComponents();
    if (entry.parts.empty())
    {
      const std::size_t begin = entry.array.rfind(prefix, 0) == 0 ? prefix.size() : 0;
      const bool isList = row == WholeFieldData && Lists.count(entry.array) > 0;
      values[entry.key.empty() ? KeyOf(entry.array.substr(begin)) : entry.key] =
        isList ? ListOf(array) : ValueOf(array, index);
    }
    for (const std::string& part : entry.parts)
    {
      (entry.key.empty() ? values : values[entry.key])[part] = ValueOf(array, index++);
    }
  }
  return values;
}

/** A report while it is made. */
class Report
{
public:
  using Sources = std::map<std::string, vtkSmartPointer<vtkDataObject>>;

  Report(const Sources& sources, const std::vector<double>& seconds,
    const std::vector<std::string>& files)
    : Given(sources)
    , Seconds(seconds)
    , Files(files)
    , Axes(std::any_of(sources.begin(), sources.end(),
             [](const auto& source) { return vtkCrossFieldReport::HasHeight(source.second); })
          ? 3
          : 2)
  {
  }

  void AddCheck()
  {
    this->Values["holonomy_defect"] = Json::array();
    this->Add({ names::EulerCharacteristic, names::Valence, names::TangentTurning,
      names::TotalCurvature, names::RequiredInteriorQuarters, names::GivenInteriorQuarters,
      names::Consistent, names::AmbiguousCorners, names::UnwantedSingularities, names::HoleDegree,
      names::HoleDegreeReliable, names::HolonomyDefect, names::Reason });
    this->AddRows("corners", "corners", { names::Angle, names::QuarterIndex, names::Cancellable });
    this->AddColumns("regions", "Region",
      { { "name", names::RegionMaterial }, names::RegionRequiredInteriorQuarters,
        names::RegionGivenInteriorQuarters });
    this->AddRows("loops", "loops",
      { names::Valence, names::TangentTurning, names::CornerQuarters, names::RequiredPart });
  }

  void AddCorners()
  {
    this->Add({ names::Scenario, names::Energy, names::InteriorQuarters, names::AmbiguousCorners });
    for (Json row :
      this->Rows("scenarios", { names::Scenario, names::Sum, names::Energy, names::Feasible }))
    {
      const std::string name = row.value("scenario", "");
      row.erase("scenario");
      this->Values["scenarios"][name] = row;
    }
    this->AddRows("corners", "data",
      { names::Angle, names::QuarterIndex, names::QuarterIndexScarce, names::QuarterIndexBalanced,
        names::QuarterIndexExcess, names::QuarterIndexConventional, names::CornerEnergy,
        names::Cancellable, names::Tied, names::Overridden });
    this->AddRows("split", "split", { names::QuarterIndex });
  }

  void AddEnergy()
  {
    const Json gradients =
      this->Rows("gradients", { names::Configuration, { "", names::Gradient, { "dx", "dy" } } });
    const Json rows = this->Rows("data",
      { names::Configuration, names::Energy, names::EnergyDegreeOnly, names::EnergyLowerBound,
        names::EnergyUpperBound, names::EnergyDegreeOnlyLowerBound,
        names::EnergyDegreeOnlyUpperBound, names::LogarithmCoefficient, names::RenormalizedEnergy,
        names::CoreRadius, names::EnergyAtCoreRadius, names::HolonomyDefect, names::Consistent });
    for (Json row : rows)
    {
      row["gradient"] = Json::array();
      for (Json gradient : gradients)
      {
        if (gradient["configuration"] == row["configuration"])
        {
          gradient.erase("configuration");
          gradient.erase("z");
          row["gradient"].push_back(gradient);
        }
      }
      const auto number = row.value("configuration", std::size_t(0));
      if (number < this->Files.size())
      {
        row = row["consistent"] == true ? row : Json{ { "consistent", false } };
        row.erase("configuration");
        row["file"] = this->Files[number];
      }
      this->Values["configurations"].push_back(row);
    }
  }

  void AddField()
  {
    this->Add({ names::BoundarySingularities, names::Energy, names::Iterations, names::Residual,
      names::Converged, names::StartedFromUnitNorm, names::UnitHoles, names::HoleDegree,
      names::HoleDegreeReliable, names::HoleNormRange, names::DegreesReached,
      names::UnwantedSingularities, names::EulerCharacteristic, names::Valence,
      names::TangentTurning, names::RequiredInteriorQuarters, names::GivenInteriorQuarters,
      names::Consistent, names::Epsilon, names::GradientEnergy, names::PenaltyEnergy,
      names::ConvexifiedSteps, names::HolonomyDefect, names::RenormalizedEnergy,
      names::PointSingularities });
    vtkNew<vtkIdTypeArray> triangles;
    if (auto* mesh = vtkUnstructuredGrid::SafeDownCast(this->Source("data")))
    {
      mesh->GetIdsOfCellsOfType(VTK_TRIANGLE, triangles);
    }
    this->Values["triangles"] = triangles->GetNumberOfTuples();
    this->AddSeconds({ "assemble", "factor", "mesh", "solve", "write" });
  }

  void AddOptimize()
  {
    this->Add({ names::RenormalizedEnergyBefore, names::RenormalizedEnergyAfter,
      names::SizeSpreadBefore, names::SizeSpreadAfter, names::Iterations, names::Converged,
      names::HolonomyDefect, names::Annihilation, names::Reason, names::Events });
    this->AddColumns("front", "Front",
      { names::FrontSingularities, names::FrontSizeSpread, names::FrontRenormalizedEnergy,
        names::FrontHolonomyDefect });
  }

  void AddQuads()
  {
    this->Add({ names::Quads, names::Blocks, names::Parts,
      { "scaled_jacobian", names::ScaledJacobianRange, { "min", "mean" } },
      { "eta", names::EtaRange, { "min", "mean" } },
      { "sizes", names::SizeRange, { "min", "mean", "max" } }, names::SizeVariation,
      { "surface_distance", names::SurfaceDistance, { "mean", "max" } }, names::Symmetries,
      names::ZeroArcs, names::Inverted, names::AmbiguousCorners, names::Warnings, names::Moved });
    this->Add({ names::ScaledJacobianBound, names::ScaledJacobianBySurface }, "scaled_jacobian",
      "ScaledJacobian");
    this->AddCounts("irregular", names::IrregularObtained);
    this->AddCounts("asked", names::IrregularRequested);
    this->Add({ { "none", names::BlocksUnmerged }, names::BlocksClean, names::BlocksCoarse },
      "blocks_by_merge", "Blocks");
    this->Add(
      { names::IntegerVariables, names::IntegerOptimal, names::IntegerGap }, "integers", "Integer");
    this->AddColumns("attempts", "Attempts", { { "", names::Attempts, { "what", "outcome" } } });
    this->AddColumns("regions", "Region",
      { { "name", names::RegionMaterial }, names::RegionQuads,
        names::RegionRequiredInteriorQuarters, names::RegionGivenInteriorQuarters });
    this->AddColumns("interfaces", "Interface",
      { names::InterfaceName, names::InterfaceEdges,
        { "size_ratio", names::InterfaceSizeRatio, { "max", "median" } } });
    this->AddColumns("alternatives", "Alternative",
      { names::AlternativeNodes, names::AlternativeBlocks, names::AlternativeScaledJacobian,
        names::AlternativeSizeVariation });
    this->Add(
      { names::SizeTargetAreaShare, names::SizeTargetQuadShare, names::SizeTargetFineMedian,
        names::SizeTargetLargestJump, names::SizeTargetNodesAdded, names::SizeTargetFactor },
      "size_target", "SizeTarget");
    const Json sized =
      this->Columns("SizeTargetSide", { names::SizeTargetSideName, names::SizeTargetSideMedian });
    if (!sized.is_null())
    {
      this->Values["size_target"]["sides"] = sized;
    }
    this->AddColumns("sides", "Side",
      { { "name", names::SideNames }, names::SideEdges, { "length", names::SideLengths } });
    this->AddColumns("layers", "Layer",
      { names::LayerSide, names::LayerReplaced, names::LayerRows, names::LayerFirst,
        names::LayerThickness, { "heights", names::LayerHeightRange, { "min", "max" } },
        names::LayerInBounds, names::LayerGrowth, names::LayerRatio,
        { "ratio_99", names::LayerRatio99 } });
    this->AddColumns("periodic", "Periodic",
      { { "", names::PeriodicSides, { "first", "second" } }, names::PeriodicKind,
        { "vector", names::PeriodicVector, { "x", "y", "z" } },
        { "centre", names::PeriodicCentre, { "x", "y", "z" } }, names::PeriodicAngle,
        names::PeriodicEdges, names::PeriodicMismatch });
    std::vector<std::string> axes = { "x", "y", "z" };
    axes.resize(static_cast<std::size_t>(this->Axes));
    this->AddColumns("moves", "Move",
      { names::MoveSingularity, { "", names::MoveFrom, axes }, { "to", names::MoveTo, axes },
        names::MoveDistance });
    this->AddColumns("curves", "Curve",
      { names::CurveKind, names::CurveSides, names::CurveEdges, names::CurveMoved,
        names::CurveSagitta });
    this->Add({ names::Order, { "jacobian_ratio", names::JacobianRatioMin },
                { "inverted", names::CurvedInverted }, names::CurvedRows },
      "higher_order");
    this->Add({ names::Hexahedra, names::SweepLayers }, "sweep", "Sweep");
    this->AddMap("data");
    this->AddSeconds({ "mesh", "map", "trace", "integers", "layout", "smooth", "choose", "clean" });
    if (!this->Seconds.empty())
    {
      this->Values["integers"]["seconds"] = this->Values["seconds"]["integers"];
    }
  }

  void AddSeparatrices()
  {
    this->Add({ names::Lines, names::Faces, names::Arcs, names::ExtraLines, names::HeadOn,
      names::Flips, names::Longest, names::Mismatch });
    this->Add({ names::MapResidual }, "", "", "map");
    this->AddMap("map");
    this->AddSeconds({ "mesh", "map", "trace" });
  }

  /** Adds what every report has. */
  void AddCommon()
  {
    this->AddRows("singularities", "singularities", { names::QuarterIndex });
    this->Add({ names::Events }, "", "", "singularities");
    this->Add({ names::DrawingUnit, names::LargestGap }, "drawing", "Drawing", "domain");
    this->Add({ { "", names::BoundaryPoints, { "points_before", "points" } }, names::BoundaryMoved,
                names::BoundaryRemovedCorners },
      "boundary", "Boundary", "domain");
  }

  std::string Text() const
  {
    return this->Values.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
  }

private:
  vtkDataObject* Source(const std::string& name) const
  {
    const auto source = this->Given.find(name);
    return source == this->Given.end() ? nullptr : source->second.Get();
  }

  vtkFieldData* FieldData(const std::string& source) const
  {
    vtkDataObject* data = this->Source(source);
    return data == nullptr ? this->Nothing.Get() : data->GetFieldData();
  }

  /** Adds values of field data, or an object of them. */
  void Add(const Entries& entries, const std::string& key = "", const std::string& prefix = "",
    const std::string& source = "data")
  {
    const Json values = RowOf(this->FieldData(source), WholeFieldData, entries, prefix);
    if (!values.empty())
    {
      (key.empty() ? this->Values : this->Values[key]).update(values);
    }
  }

  /** Returns the rows of a table, or the points of a data set with their places. */
  Json Rows(const std::string& source, const Entries& entries) const
  {
    Json rows = Json::array();
    vtkDataObject* data = this->Source(source);
    auto* points = vtkDataSet::SafeDownCast(data);
    const int kind = points != nullptr ? vtkDataObject::POINT : vtkDataObject::ROW;
    for (vtkIdType i = 0; data != nullptr && i < data->GetNumberOfElements(kind); ++i)
    {
      Json row = Json::object();
      for (int axis = 0; points != nullptr && axis < this->Axes; ++axis)
      {
        row[std::string(1, "xyz"[axis])] = points->GetPoint(i)[axis];
      }
      row.update(RowOf(data->GetAttributesAsFieldData(kind), i, entries));
      rows.push_back(row);
    }
    return rows;
  }

  void AddRows(const std::string& key, const std::string& source, const Entries& entries)
  {
    if (this->Source(source) != nullptr)
    {
      this->Values[key] = this->Rows(source, entries);
    }
  }

  /** Returns an object for each tuple of arrays in the field data; null without the first one. */
  Json Columns(const std::string& prefix, const Entries& entries) const
  {
    vtkFieldData* arrays = this->FieldData("data");
    vtkAbstractArray* first = arrays->GetAbstractArray(entries.front().array.c_str());
    Json rows = first == nullptr ? Json() : Json::array();
    for (vtkIdType i = 0; first != nullptr && i < first->GetNumberOfTuples(); ++i)
    {
      rows.push_back(RowOf(arrays, i, entries, prefix));
    }
    return rows;
  }

  void AddColumns(const std::string& key, const std::string& prefix, const Entries& entries)
  {
    const Json rows = this->Columns(prefix, entries);
    if (!rows.is_null())
    {
      this->Values[key] = rows;
    }
  }

  /** Adds the positive numbers of irregular nodes by their valence. */
  void AddCounts(const std::string& key, const char* name)
  {
    this->Values[key] = Json::object();
    for (Json row :
      this->Columns("", { { "valence", names::IrregularValence }, { "count", name } }))
    {
      if (row["count"] > 0)
      {
        this->Values[key][row["valence"].dump()] = row["count"];
      }
    }
  }

  /** Adds what was done so that a seamless map exists. */
  void AddMap(const std::string& source)
  {
    this->Add({ { "predicted", names::PredictedStretch }, { "reason", names::StretchReason } },
      "stretch", "", source);
    this->Add({ names::RepairDistance, names::DefectBefore }, "repair", "Repair", source);
  }

  void AddSeconds(const std::vector<std::string>& stages)
  {
    for (std::size_t i = 0; i < std::min(stages.size(), this->Seconds.size()); ++i)
    {
      this->Values["seconds"][stages[i]] = this->Seconds[i];
    }
  }

  const Sources& Given;
  const std::vector<double>& Seconds;
  const std::vector<std::string>& Files;
  int Axes;
  vtkNew<vtkFieldData> Nothing;
  Json Values = Json::object();
};
}

//------------------------------------------------------------------------------
bool vtkCrossFieldReport::HasHeight(vtkDataObject* object)
{
  auto* data = vtkDataSet::SafeDownCast(object);
  if (data == nullptr)
  {
    return false;
  }
  double bounds[6];
  data->GetBounds(bounds);
  if (!(bounds[4] < bounds[5]))
  {
    return false; // all points have the same z, so those of cells do
  }
  const UsedPoints used(data);
  return std::any_of(used.GetIds().begin(), used.GetIds().end(),
    [&](vtkIdType point)
    { return data->GetPoint(point)[2] != data->GetPoint(used.GetIds().front())[2]; });
}

//------------------------------------------------------------------------------
std::string vtkCrossFieldReport::Write(const std::string& name)
{
  static const std::map<std::string, void (Report::*)()> Kinds = { { "check", &Report::AddCheck },
    { "corners", &Report::AddCorners }, { "energy", &Report::AddEnergy },
    { "field", &Report::AddField }, { "optimize", &Report::AddOptimize },
    { "quads", &Report::AddQuads }, { "separatrices", &Report::AddSeparatrices } };
  Report report(this->Sources, this->Seconds, this->Files);
  const auto kind = Kinds.find(name);
  if (kind != Kinds.end())
  {
    (report.*kind->second)();
  }
  report.AddCommon();
  return report.Text();
}

//------------------------------------------------------------------------------
void vtkCrossFieldReport::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Sources: " << this->Sources.size() << "\n";
  os << indent << "Seconds: " << this->Seconds.size() << "\n";
  os << indent << "Files: " << this->Files.size() << "\n";
}
