#include "vtkBoundarySimplifier.h"

#include "BoundaryCorners.h"
#include "ColumnWriting.h"
#include "CurveConversion.h"
#include "DomainConversion.h"
#include "DrilledMeshConversion.h"
#include "Error.h"
#include "FilterPorts.h"
#include "FilterRun.h"
#include "InputCheck.h"
#include "MaterialCheck.h"
#include "PartSelection.h"
#include "SegmentCurveConversion.h"
#include "SideConversion.h"
#include "SideText.h"
#include "SmoothBoundary.h"
#include "ThinBoundary.h"
#include "UsedPoints.h"
#include "vtkCrossFieldArrayNames.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkCellType.h"
#include "vtkDataSet.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkStaticPointLocator.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>

vtkStandardNewMacro(vtkBoundarySimplifier);

namespace
{
/** A part of a domain, with its sides and curves, before and after simplification. */
struct SimplePart
{
  DomainConversion::Domain given;
  DomainConversion::Domain simple;
  crossfield::BoundarySides sides;
  crossfield::CurvedBoundary boundary;
  double moved = 0.0;

  bool IsChanged() const { return this->simple.domain.loops != this->given.domain.loops; }
};

/** Properties of the filter. */
struct Options
{
  double meshSize = 0.0;
  double thinning = -1.0;
  double smoothing = 0.0;
  double cornerAngle = 0.0; ///< In radians.
  std::vector<std::pair<std::string, double>> sideSizes;
  std::vector<std::string> keptSides;
};

int CountPoints(const crossfield::PlanarDomain& domain)
{
  int count = 0;
  for (const crossfield::Loop& loop : domain.loops)
  {
    count += static_cast<int>(loop.size());
  }
  return count;
}

/** Returns whether lines can be written to data of this type. */
bool CanHaveLines(vtkDataSet* data)
{
  return vtkPolyData::SafeDownCast(data) != nullptr ||
    vtkUnstructuredGrid::SafeDownCast(data) != nullptr;
}

bool HasSurfaceWithArrays(vtkDataSet* input)
{
  bool hasSurface = false;
  for (vtkIdType cell = 0; !hasSurface && cell < input->GetNumberOfCells(); ++cell)
  {
    const int type = input->GetCellType(cell);
    hasSurface = type != VTK_LINE && type != VTK_POLY_LINE && type != VTK_VERTEX &&
      type != VTK_POLY_VERTEX && type != VTK_EMPTY_CELL;
  }
  return hasSurface && input->GetPointData()->GetNumberOfArrays() > 0;
}

/** Copies the input to the output, without the field data of an earlier simplification. */
void PassThrough(vtkDataSet* input, vtkDataSet* output)
{
  output->ShallowCopy(input);
  output->GetFieldData()->RemoveArray(vtkCrossFieldArrayNames::BoundaryRemovedCorners);
  output->GetFieldData()->RemoveArray(vtkCrossFieldArrayNames::BoundaryMoved);
  output->GetFieldData()->RemoveArray(vtkCrossFieldArrayNames::BoundaryPoints);
}

/**
 * Copies the point arrays of the input to `points`, each from the nearest point that a cell uses.
 */
void CopyNearestArrays(vtkDataSet* input, vtkPoints* points, vtkPointData* arrays)
{
  if (input->GetPointData()->GetNumberOfArrays() == 0)
  {
    return;
  }
  const UsedPoints used(input);
  vtkNew<vtkPoints> places;
  places->SetDataTypeToDouble();
  for (const vtkIdType id : used.GetIds())
  {
    places->InsertNextPoint(input->GetPoint(id));
  }
  vtkNew<vtkPolyData> nearby;
  nearby->SetPoints(places);
  vtkNew<vtkStaticPointLocator> locator;
  locator->SetDataSet(nearby);
  locator->BuildLocator();
  arrays->CopyAllocate(input->GetPointData(), points->GetNumberOfPoints());
  for (vtkIdType i = 0; i < points->GetNumberOfPoints(); ++i)
  {
    const vtkIdType nearest = locator->FindClosestPoint(points->GetPoint(i));
    arrays->CopyData(input->GetPointData(), used.GetIds()[nearest], i);
  }
}

/** Returns points to keep with the vertices on curves, which smoothing must not move. */
std::vector<crossfield::Point> WithPointsOf(const crossfield::CurvedBoundary& boundary,
  const crossfield::PlanarDomain& domain, std::vector<crossfield::Point> kept)
{
  const std::vector<crossfield::LoopArc> arcs(domain.loops.begin(), domain.loops.end());
  const crossfield::CurvesAlong along(boundary, arcs);
  for (std::size_t l = 0; l < arcs.size(); ++l)
  {
    const std::size_t count = domain.loops[l].size();
    for (std::size_t i = 0; i < count; ++i)
    {
      if (along.At(l, 0.5 * (arcs[l].Start(i) + arcs[l].Start(i + 1))) >= 0)
      {
        kept.push_back(domain.loops[l][i]);
        kept.push_back(domain.loops[l][(i + 1) % count]);
      }
    }
  }
  return kept;
}

/**
 * Returns the curves that are declared for sides of a part. Throws crossfield::Error if no part has
 * one of the sides.
 */
crossfield::CurveRequest RequestFor(std::size_t part,
  const std::vector<crossfield::BoundarySides>& sides, crossfield::CurveRequest request)
{
  std::vector<std::string> names;
  for (const crossfield::BoundarySides& ofPart : sides)
  {
    names.insert(names.end(), ofPart.names.begin(), ofPart.names.end());
  }
  std::vector<crossfield::CurveDeclaration> here;
  for (const crossfield::CurveDeclaration& declaration : request.declared)
  {
    crossfield::RequireSide(names, declaration.side, " for a curve");
    if (sides[part].Find(declaration.side) >= 0)
    {
      here.push_back(declaration);
    }
  }
  request.declared = std::move(here);
  return request;
}

/** Bounds the lengths of thinning of loops by the sizes at their sides. */
void ShortenFor(const std::vector<std::pair<std::string, double>>& sizes,
  const crossfield::BoundarySides& sides, const crossfield::PlanarDomain& domain,
  std::vector<double>& lengths)
{
  const crossfield::SidesAlong along(sides, { domain.loops.begin(), domain.loops.end() });
  for (const auto& [name, size] : sizes)
  {
    const int side = sides.Find(name);
    for (std::size_t loop = 0; loop < lengths.size(); ++loop)
    {
      const std::vector<crossfield::LoopSide>& starts = along.On(loop);
      if (std::any_of(starts.begin(), starts.end(),
            [side](const crossfield::LoopSide& start) { return start.side == side; }))
      {
        lengths[loop] = std::min(lengths[loop], crossfield::ThinningFor(size));
      }
    }
  }
}

/** Returns all points of sides. */
std::vector<crossfield::Point> PointsOf(const std::vector<std::string>& names,
  const crossfield::BoundarySides& sides, const crossfield::PlanarDomain& domain)
{
  const std::vector<crossfield::LoopArc> arcs(domain.loops.begin(), domain.loops.end());
  const crossfield::SidesAlong along(sides, arcs);
  std::vector<crossfield::Point> points;
  for (std::size_t l = 0; l < arcs.size(); ++l)
  {
    const std::size_t count = domain.loops[l].size();
    for (std::size_t i = 0; i < count; ++i)
    {
      const int side = along.At(l, 0.5 * (arcs[l].Start(i) + arcs[l].Start(i + 1)));
      if (std::find(names.begin(), names.end(), sides.names[side]) != names.end())
      {
        points.push_back(domain.loops[l][i]);
        points.push_back(domain.loops[l][(i + 1) % count]);
      }
    }
  }
  return points;
}

/** Returns the points of the input at which the boundary is kept. */
std::vector<crossfield::Point> KeptPoints(
  vtkInformationVector* inputs, const crossfield::DomainPlane& plane)
{
  std::vector<crossfield::Point> kept;
  for (int i = 0; i < inputs->GetNumberOfInformationObjects(); ++i)
  {
    vtkDataSet* points = vtkDataSet::GetData(inputs, i);
    for (vtkIdType p = 0; points != nullptr && p < points->GetNumberOfPoints(); ++p)
    {
      InputCheck::RequireFinite(points->GetPoint(p), p);
      kept.push_back(plane.ToPlane(Eigen::Vector3d(points->GetPoint(p))));
    }
  }
  return kept;
}

/** Thins and smooths a part, except at points to keep, ends of sides and curves. */
void Simplify(const Options& options, std::vector<crossfield::Point> kept, SimplePart& part)
{
  const crossfield::PlanarDomain& given = part.given.domain;
  for (const std::vector<crossfield::Point>& more :
    { part.sides.FixedPlaces(), PointsOf(options.keptSides, part.sides, given) })
  {
    kept.insert(kept.end(), more.begin(), more.end());
  }
  for (const crossfield::CurveStart& start : part.boundary.starts)
  {
    kept.push_back(start.place);
  }
  const double thinning = options.thinning >= 0.0
    ? options.thinning
    : crossfield::DefaultThinning(given, options.meshSize);
  if (thinning > 0.0)
  {
    std::vector<double> lengths(given.loops.size(), thinning);
    if (options.thinning < 0.0 && !options.sideSizes.empty())
    {
      ShortenFor(options.sideSizes, part.sides, given, lengths);
    }
    crossfield::SimplifiedBoundary thin =
      crossfield::ThinLoops(given, lengths, kept, options.cornerAngle);
    part.simple.domain = thin.domain;
    part.moved += thin.moved;
  }
  if (options.smoothing > 0.0)
  {
    crossfield::SimplifiedBoundary smooth =
      crossfield::SmoothBoundary(part.simple.domain, options.smoothing,
        WithPointsOf(part.boundary, part.simple.domain, kept), options.cornerAngle);
    part.simple.domain = smooth.domain;
    part.moved += smooth.moved;
  }
}

/**
 * Adds one polyline per loop of a part, or per piece of a side or a curve. `names` is absent if
 * sides have no names.
 */
void AddLoops(const SimplePart& part, vtkPoints* points, vtkCellArray* lines, vtkStringArray* names,
  CurveConversion::CellCurves& cellCurves)
{
  const std::vector<crossfield::Loop>& loops = part.simple.domain.loops;
  const std::vector<crossfield::LoopArc> arcs(loops.begin(), loops.end());
  const crossfield::SidesAlong along(part.sides, arcs);
  const auto middle = [&](std::size_t loop, std::size_t segment)
  { return 0.5 * (arcs[loop].Start(segment) + arcs[loop].Start(segment + 1)); };
  const auto nameAt = [&](std::size_t loop, std::size_t segment)
  {
    const int side = along.At(loop, middle(loop, segment));
    return side < part.sides.given ? part.sides.names[side] : std::string();
  };
  const crossfield::CurvesAlong curvesAlong(part.boundary, arcs);
  const auto first = static_cast<int>(cellCurves.curves.size());
  const auto curveAt = [&](std::size_t loop, std::size_t segment)
  {
    const int curve = curvesAlong.At(loop, middle(loop, segment));
    return curve < 0 ? -1 : first + curve;
  };
  cellCurves.curves.insert(
    cellCurves.curves.end(), part.boundary.curves.begin(), part.boundary.curves.end());
  for (std::size_t l = 0; l < arcs.size(); ++l)
  {
    const vtkIdType start = points->GetNumberOfPoints();
    std::vector<vtkIdType> piece;
    for (std::size_t i = 0; i < loops[l].size(); ++i)
    {
      piece.push_back(points->InsertNextPoint(part.simple.plane.ToSpace(loops[l][i]).data()));
      const bool isLast = i + 1 == loops[l].size();
      if (isLast || (names != nullptr && nameAt(l, i) != nameAt(l, i + 1)) ||
        curveAt(l, i) != curveAt(l, i + 1))
      {
        piece.push_back(isLast ? start : points->GetNumberOfPoints());
        lines->InsertNextCell(static_cast<vtkIdType>(piece.size()), piece.data());
        if (names != nullptr)
        {
          names->InsertNextValue(nameAt(l, i));
        }
        cellCurves.ofCell.push_back(curveAt(l, i));
        piece.clear();
      }
    }
  }
}

/**
 * Writes the loops of all parts with the arrays of the nearest points of the input, and the array
 * of the names of sides unless that has no name.
 */
void WriteLoops(const std::vector<SimplePart>& parts, const std::string& array, vtkDataSet* input,
  vtkDataSet* output)
{
  vtkNew<vtkStringArray> sideNames;
  sideNames->SetName(array.c_str());
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> lines;
  CurveConversion::CellCurves cellCurves;
  for (const SimplePart& part : parts)
  {
    AddLoops(part, points, lines, array.empty() ? nullptr : sideNames.Get(), cellCurves);
  }
  if (auto* curves = vtkPolyData::SafeDownCast(output))
  {
    curves->SetPoints(points);
    curves->SetLines(lines);
  }
  else if (auto* grid = vtkUnstructuredGrid::SafeDownCast(output))
  {
    grid->SetPoints(points);
    grid->SetCells(VTK_POLY_LINE, lines);
  }
  CopyNearestArrays(input, points, output->GetPointData());
  if (!array.empty())
  {
    output->GetCellData()->AddArray(sideNames);
  }
  SegmentCurveConversion::RemoveCurves(output);
  if (std::any_of(
        cellCurves.ofCell.begin(), cellCurves.ofCell.end(), [](int curve) { return curve >= 0; }))
  {
    CurveConversion::AddCurves(cellCurves, output);
  }
}

/**
 * Writes how far points moved, the numbers of points, and the positions of the corners that the new
 * boundary does not have.
 */
void WriteChanges(const std::vector<SimplePart>& parts, double cornerAngle, vtkDataSet* output)
{
  namespace names = vtkCrossFieldArrayNames;
  double moved = 0.0;
  std::vector<int> counts(2);
  vtkNew<vtkDoubleArray> removed;
  removed->SetName(names::BoundaryRemovedCorners);
  removed->SetNumberOfComponents(3);
  for (const SimplePart& part : parts)
  {
    moved = std::max(moved, part.moved);
    counts[0] += CountPoints(part.given.domain);
    counts[1] += CountPoints(part.simple.domain);
    const double rounding = 1e-9 * part.given.domain.Diagonal();
    const std::vector<crossfield::Corner> after =
      crossfield::FindCorners(part.simple.domain.loops, cornerAngle);
    for (const crossfield::Corner& corner :
      crossfield::FindCorners(part.given.domain.loops, cornerAngle))
    {
      if (std::none_of(after.begin(), after.end(),
            [&](const crossfield::Corner& other)
            { return (other.position - corner.position).norm() <= rounding; }))
      {
        removed->InsertNextTuple(part.given.plane.ToSpace(corner.position).data());
      }
    }
  }
  ColumnWriting::AddNumbers(output->GetFieldData(), names::BoundaryMoved, { moved });
  ColumnWriting::AddIntegers(output->GetFieldData(), names::BoundaryPoints, counts);
  if (removed->GetNumberOfTuples() > 0)
  {
    output->GetFieldData()->AddArray(removed);
  }
}
}

//------------------------------------------------------------------------------
vtkBoundarySimplifier::vtkBoundarySimplifier()
{
  this->SetNumberOfInputPorts(2);
}

//------------------------------------------------------------------------------
int vtkBoundarySimplifier::FillInputPortInformation(int port, vtkInformation* info)
{
  if (port == 0)
  {
    return FilterPorts::AcceptDomain(info);
  }
  info->Set(vtkAlgorithm::INPUT_IS_REPEATABLE(), 1);
  return FilterPorts::AcceptOptionalPoints(info);
}

//------------------------------------------------------------------------------
int vtkBoundarySimplifier::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkDataSet* whole = vtkDataSet::GetData(inputVector[0]);
  vtkDataSet* output = vtkDataSet::GetData(outputVector);
  return FilterRun::Run(this, this->ErrorCode, whole,
    [&](const crossfield::Progress& progress)
    {
      InputCheck::Require(whole);
      const bool isRequested = this->ThinningLength > 0.0 || this->SmoothingLength > 0.0;
      if ((isRequested || !this->Part.empty()) && !CanHaveLines(whole))
      {
        throw crossfield::Error(
          "The boundary of structured data has no lines to simplify or select; use Extract Surface first.");
      }
      const vtkSmartPointer<vtkDataSet> part =
        PartSelection::Select(whole, this->Part, this->SideNameArray);
      vtkDataSet* input = part;
      const crossfield::CurveRequest request = SideText::ReadCurves(this->Curves);
      if (DrilledMeshConversion::AsDrilledMesh(input) != nullptr ||
        (!isRequested &&
          ((this->ThinningLength == 0.0 && request.IsEmpty()) || HasSurfaceWithArrays(input) ||
            !CanHaveLines(input))))
      {
        PassThrough(input, output);
        return;
      }
      const std::vector<DomainConversion::Domain> given = DomainConversion::ReadParts(input, this);
      const std::string array = SideConversion::FindArray(input, this->SideNameArray);
      const std::vector<crossfield::BoundarySides> sides =
        SideConversion::ReadSides(input, this->SideNameArray, given);
      std::vector<SimplePart> parts;
      for (std::size_t p = 0; p < given.size(); ++p)
      {
        parts.push_back({ given[p], given[p], sides[p], {}, 0.0 });
        const crossfield::CurvesOfSegments curves = crossfield::FindCurves(given[p].domain,
          sides[p], RequestFor(p, sides, request), SegmentCurveConversion::Read(input, given[p]));
        parts.back().boundary = crossfield::PiecesOf(given[p].domain, curves);
      }
      progress.Report(0.5);
      const Options options{ this->MeshSize, this->ThinningLength, this->SmoothingLength,
        vtkMath::RadiansFromDegrees(this->CornerAngle), this->SideSizes, this->KeptSides };
      const std::vector<crossfield::Point> kept = KeptPoints(inputVector[1], given[0].plane);
      bool isChanged = false;
      bool hasCurves = false;
      for (SimplePart& one : parts)
      {
        Simplify(options, kept, one);
        isChanged = isChanged || one.IsChanged();
        hasCurves = hasCurves || !one.boundary.IsEmpty();
      }
      if (!isChanged && (request.IsEmpty() || !hasCurves))
      {
        PassThrough(input, output);
        return;
      }
      const std::string warning =
        MaterialCheck::Warning(input); // the output has no cells that show it
      if (!warning.empty())
      {
        vtkWarningMacro(<< warning);
      }
      WriteLoops(parts, array, input, output);
      if (isChanged)
      {
        WriteChanges(parts, options.cornerAngle, output);
      }
    });
}

//------------------------------------------------------------------------------
void vtkBoundarySimplifier::AddSideSize(const std::string& name, double size)
{
  this->SideSizes.emplace_back(name, size);
  this->Modified();
}

//------------------------------------------------------------------------------
void vtkBoundarySimplifier::ClearSideSizes()
{
  this->SideSizes.clear();
  this->Modified();
}

//------------------------------------------------------------------------------
void vtkBoundarySimplifier::AddKeptSide(const std::string& name)
{
  this->KeptSides.push_back(name);
  this->Modified();
}

//------------------------------------------------------------------------------
void vtkBoundarySimplifier::ClearKeptSides()
{
  this->KeptSides.clear();
  this->Modified();
}

//------------------------------------------------------------------------------
void vtkBoundarySimplifier::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Part: " << this->Part << "\n";
  os << indent << "MeshSize: " << this->MeshSize << "\n";
  os << indent << "ThinningLength: " << this->ThinningLength << "\n";
  os << indent << "SmoothingLength: " << this->SmoothingLength << "\n";
  os << indent << "CornerAngle: " << this->CornerAngle << "\n";
  os << indent << "SideNameArray: " << this->SideNameArray << "\n";
  os << indent << "SideSizes: " << this->SideSizes.size() << "\n";
  os << indent << "KeptSides: " << this->KeptSides.size() << "\n";
  os << indent << "Curves: " << this->Curves << "\n";
}
