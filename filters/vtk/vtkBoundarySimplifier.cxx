#include "vtkBoundarySimplifier.h"

#include "BoundaryCorners.h"
#include "ColumnWriting.h"
#include "CurveConversion.h"
#include "DomainConversion.h"
#include "DrilledMeshConversion.h"
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
int CountPoints(const crossfield::PlanarDomain& domain)
{
  int count = 0;
  for (const crossfield::Loop& loop : domain.loops)
  {
    count += static_cast<int>(loop.size());
  }
  return count;
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

/** Writes the positions of the corners that the new boundary does not have. */
void WriteRemovedCorners(const DomainConversion::Domain& given,
  const DomainConversion::Domain& simple, double cornerAngle, vtkDataSet* output)
{
  const double rounding = 1e-9 * given.domain.Diagonal();
  const std::vector<crossfield::Corner> after =
    crossfield::FindCorners(simple.domain.loops, cornerAngle);
  vtkNew<vtkDoubleArray> removed;
  removed->SetName(vtkCrossFieldArrayNames::BoundaryRemovedCorners);
  removed->SetNumberOfComponents(3);
  for (const crossfield::Corner& corner : crossfield::FindCorners(given.domain.loops, cornerAngle))
  {
    if (std::none_of(after.begin(), after.end(),
          [&](const crossfield::Corner& other)
          { return (other.position - corner.position).norm() <= rounding; }))
    {
      removed->InsertNextTuple(given.plane.ToSpace(corner.position).data());
    }
  }
  if (removed->GetNumberOfTuples() > 0)
  {
    output->GetFieldData()->AddArray(removed);
  }
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

/** Names of the sides of a boundary and the array that they were read from. */
struct NamedSides
{
  std::string array; ///< Empty: the boundary has no names.
  crossfield::BoundarySides sides;
};

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

/**
 * Writes one polyline per loop, or per piece of a side or a curve, with the arrays of the nearest
 * points of the input.
 */
void WriteLoops(const DomainConversion::Domain& domain, const NamedSides& named,
  const crossfield::CurvedBoundary& boundary, vtkDataSet* input, vtkDataSet* output)
{
  std::vector<crossfield::LoopArc> arcs;
  for (const crossfield::Loop& loop : domain.domain.loops)
  {
    arcs.emplace_back(loop);
  }
  const crossfield::SidesAlong along(named.sides, arcs);
  const auto nameAt = [&](std::size_t loop, std::size_t segment)
  {
    const int side =
      along.At(loop, 0.5 * (arcs[loop].Start(segment) + arcs[loop].Start(segment + 1)));
    return side < named.sides.given ? named.sides.names[side] : std::string();
  };
  const crossfield::CurvesAlong curvesAlong(boundary, arcs);
  const auto curveAt = [&](std::size_t loop, std::size_t segment) {
    return curvesAlong.At(loop, 0.5 * (arcs[loop].Start(segment) + arcs[loop].Start(segment + 1)));
  };
  CurveConversion::CellCurves cellCurves{ boundary.curves, {} };
  vtkNew<vtkStringArray> sideNames;
  sideNames->SetName(named.array.c_str());
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> lines;
  for (std::size_t l = 0; l < arcs.size(); ++l)
  {
    const crossfield::Loop& loop = domain.domain.loops[l];
    const vtkIdType first = points->GetNumberOfPoints();
    std::vector<vtkIdType> piece;
    for (std::size_t i = 0; i < loop.size(); ++i)
    {
      piece.push_back(points->InsertNextPoint(domain.plane.ToSpace(loop[i]).data()));
      const bool isLast = i + 1 == loop.size();
      if (isLast || (!named.array.empty() && nameAt(l, i) != nameAt(l, i + 1)) ||
        curveAt(l, i) != curveAt(l, i + 1))
      {
        piece.push_back(isLast ? first : points->GetNumberOfPoints());
        lines->InsertNextCell(static_cast<vtkIdType>(piece.size()), piece.data());
        if (!named.array.empty())
        {
          sideNames->InsertNextValue(nameAt(l, i));
        }
        cellCurves.ofCell.push_back(curveAt(l, i));
        piece.clear();
      }
    }
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
  if (!named.array.empty())
  {
    output->GetCellData()->AddArray(sideNames);
  }
  SegmentCurveConversion::RemoveCurves(output);
  if (!boundary.IsEmpty())
  {
    CurveConversion::AddCurves(cellCurves, output);
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
      const vtkSmartPointer<vtkDataSet> part =
        PartSelection::Select(whole, this->Part, this->SideNameArray);
      vtkDataSet* input = part;
      const crossfield::CurveRequest request = SideText::ReadCurves(this->Curves);
      const bool isRequested = this->ThinningLength > 0.0 || this->SmoothingLength > 0.0;
      if (DrilledMeshConversion::AsDrilledMesh(input) != nullptr ||
        (!isRequested &&
          ((this->ThinningLength == 0.0 && request.IsEmpty()) || HasSurfaceWithArrays(input))))
      {
        PassThrough(input, output);
        return;
      }
      const DomainConversion::Domain given = DomainConversion::ReadDomain(input);
      std::vector<crossfield::Point> kept;
      for (int i = 0; i < this->GetNumberOfInputConnections(1); ++i)
      {
        vtkDataSet* points = vtkDataSet::GetData(inputVector[1], i);
        for (vtkIdType p = 0; points != nullptr && p < points->GetNumberOfPoints(); ++p)
        {
          InputCheck::RequireFinite(points->GetPoint(p), p);
          kept.push_back(given.plane.ToPlane(Eigen::Vector3d(points->GetPoint(p))));
        }
      }
      NamedSides named;
      named.array = SideConversion::FindArray(input, this->SideNameArray);
      if (!named.array.empty())
      {
        named.sides = SideConversion::ReadSides(input, this->SideNameArray, given);
        const std::vector<crossfield::Point> ends = named.sides.FixedPlaces();
        kept.insert(kept.end(), ends.begin(), ends.end());
      }
      const crossfield::BoundarySides sides =
        named.array.empty() ? crossfield::NameSides(given.domain) : named.sides;
      if (!this->KeptSides.empty())
      {
        const std::vector<crossfield::Point> points =
          PointsOf(this->KeptSides, sides, given.domain);
        kept.insert(kept.end(), points.begin(), points.end());
      }
      const crossfield::CurvesOfSegments curves = crossfield::FindCurves(
        given.domain, sides, request, SegmentCurveConversion::Read(input, given));
      const crossfield::CurvedBoundary boundary = crossfield::PiecesOf(given.domain, curves);
      for (const crossfield::CurveStart& start : boundary.starts)
      {
        kept.push_back(start.place);
      }
      progress.Report(0.5);
      const double thinning = this->ThinningLength >= 0.0
        ? this->ThinningLength
        : crossfield::DefaultThinning(given.domain, this->MeshSize);
      const double cornerAngle = vtkMath::RadiansFromDegrees(this->CornerAngle);
      DomainConversion::Domain simple = given;
      double moved = 0.0;
      if (thinning > 0.0)
      {
        std::vector<double> lengths(given.domain.loops.size(), thinning);
        if (this->ThinningLength < 0.0 && !this->SideSizes.empty())
        {
          ShortenFor(this->SideSizes, sides, given.domain, lengths);
        }
        crossfield::SimplifiedBoundary thin =
          crossfield::ThinLoops(simple.domain, lengths, kept, cornerAngle);
        simple.domain = thin.domain;
        moved += thin.moved;
      }
      if (this->SmoothingLength > 0.0)
      {
        crossfield::SimplifiedBoundary smooth = crossfield::SmoothBoundary(simple.domain,
          this->SmoothingLength, WithPointsOf(boundary, simple.domain, kept), cornerAngle);
        simple.domain = smooth.domain;
        moved += smooth.moved;
      }
      const bool isChanged = simple.domain.loops != given.domain.loops;
      if (!isChanged && (request.IsEmpty() || boundary.IsEmpty()))
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
      WriteLoops(simple, named, boundary, input, output);
      if (!isChanged)
      {
        return;
      }
      namespace names = vtkCrossFieldArrayNames;
      ColumnWriting::AddNumbers(output->GetFieldData(), names::BoundaryMoved, { moved });
      ColumnWriting::AddIntegers(output->GetFieldData(), names::BoundaryPoints,
        { CountPoints(given.domain), CountPoints(simple.domain) });
      WriteRemovedCorners(given, simple, cornerAngle, output);
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
