#include "vtkBoundarySimplifier.h"

#include "BoundaryCorners.h"
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
#include "SimplifiedBoundary.h"
#include "SmoothBoundary.h"
#include "SurfaceConversion.h"
#include "ThinBoundary.h"
#include "vtkCrossFieldArrayNames.h"

#include "vtkCellData.h"
#include "vtkCellType.h"
#include "vtkDataSet.h"
#include "vtkFieldData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>

vtkStandardNewMacro(vtkBoundarySimplifier);

namespace
{
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
void Simplify(
  const Options& options, std::vector<crossfield::Point> kept, SimplifiedBoundary::Part& part)
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
      if (SurfaceConversion::IsSurface(whole))
      {
        if (isRequested || !this->Part.empty())
        {
          throw crossfield::Error(
            "The boundary of a surface in space is not simplified, and its parts are not selected "
            "yet; leave out the lengths (--thin-boundary, --smooth-boundary) and the part (--part).");
        }
        PassThrough(whole, output);
        return;
      }
      if ((isRequested || !this->Part.empty()) && !CanHaveLines(whole))
      {
        throw crossfield::Error(
          "The boundary of structured data has no lines to simplify or select; use Extract Surface first.");
      }
      const vtkSmartPointer<vtkDataSet> part =
        PartSelection::Select(whole, this->Part, this->SideNameArray);
      vtkDataSet* input = part;
      const crossfield::CurveRequest request = SideText::ReadCurves(this->Curves);
      const bool hasRegions =
        !MaterialCheck::FindArray(input, this->MaterialArray).empty() || !this->Lines.empty();
      if (hasRegions && isRequested)
      {
        throw crossfield::Error(
          "The boundary of a domain of several materials or with lines is not simplified yet; leave "
          "the lengths of thinning and smoothing out (--thin-boundary, --smooth-boundary), or the "
          "materials (--materials none) and lines.");
      }
      if (DrilledMeshConversion::AsDrilledMesh(input) != nullptr || hasRegions ||
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
      std::vector<SimplifiedBoundary::Part> parts;
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
      for (SimplifiedBoundary::Part& one : parts)
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
      SimplifiedBoundary::WriteLoops(parts, array, input, output);
      if (isChanged)
      {
        SimplifiedBoundary::WriteChanges(parts, options.cornerAngle, output);
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
  os << indent << "MaterialArray: " << this->MaterialArray << "\n";
  os << indent << "Lines: " << this->Lines << "\n";
  os << indent << "SideSizes: " << this->SideSizes.size() << "\n";
  os << indent << "KeptSides: " << this->KeptSides.size() << "\n";
  os << indent << "Curves: " << this->Curves << "\n";
}
