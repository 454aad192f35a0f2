#include "DomainConversion.h"

#include "BoundaryLoops.h"
#include "CellLoop.h"
#include "CellOutline.h"
#include "DomainExtent.h"
#include "DomainParts.h"
#include "Error.h"
#include "ExactSymmetry.h"
#include "InputCheck.h"
#include "MakePlanarDomain.h"
#include "UsedPoints.h"

#include "vtkBoundingBox.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkCleanPolyData.h"
#include "vtkDataSet.h"
#include "vtkDataSetSurfaceFilter.h"
#include "vtkFeatureEdges.h"
#include "vtkGenericCell.h"
#include "vtkIdList.h"
#include "vtkIdTypeArray.h"
#include "vtkIncrementalOctreePointLocator.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <sstream>
#include <string>
#include <utility>

namespace
{
using crossfield::Error;
using crossfield::Point;

/** Returns the class of the cells of a type, for a message. */
std::string NameOfType(int type)
{
  const auto cell = vtk::TakeSmartPointer(vtkGenericCell::InstantiateCell(type));
  return cell ? cell->GetClassName() : "number " + std::to_string(type);
}

/** Name of the array of cells that a surface cell comes from, as VTK has it. */
constexpr const char* OriginalCells = "vtkOriginalCellIds";

/** Returns the surface of a data set with cells of three dimensions, null if it has none. */
vtkSmartPointer<vtkPolyData> SurfaceOfVolumes(vtkDataSet* input)
{
  bool hasVolumes = false;
  std::set<int> types;
  for (vtkIdType cell = 0; cell < input->GetNumberOfCells(); ++cell)
  {
    const int type = input->GetCellType(cell);
    if (types.insert(type).second)
    {
      const auto made = vtk::TakeSmartPointer(vtkGenericCell::InstantiateCell(type));
      hasVolumes = hasVolumes || (made != nullptr && made->GetCellDimension() == 3);
    }
  }
  if (!hasVolumes)
  {
    return nullptr;
  }
  vtkNew<vtkDataSetSurfaceFilter> surface;
  surface->SetInputData(input);
  surface->PassThroughCellIdsOn();
  surface->SetNonlinearSubdivisionLevel(0);
  surface->Update();
  return surface->GetOutput();
}

/**
 * Returns the surface cells of a data set, or else its lines, with the points that they use.
 * Edges of higher order have their nodes as vertices. Vertex cells are ignored. Throws crossfield::Error for
 * other cells and for coordinates that are not finite.
 */
vtkSmartPointer<vtkPolyData> ExtractCurvesOrSurfaces(vtkDataSet* input)
{
  vtkNew<vtkCellArray> lines;
  vtkNew<vtkCellArray> surfaces;
  vtkNew<vtkIdTypeArray> ids;
  ids->SetName(OriginalCells);
  CellOutline::ForEachCell(input,
    [&](vtkIdType cell, int type, const CellLoop::Points& points)
    {
      const vtkIdType before = surfaces->GetNumberOfCells();
      switch (type)
      {
      case VTK_EMPTY_CELL:
      case VTK_VERTEX:
      case VTK_POLY_VERTEX:
        break;
      case VTK_LINE:
      case VTK_POLY_LINE:
        lines->InsertNextCell(points.Size(), points.begin());
        break;
      case VTK_TRIANGLE:
      case VTK_QUAD:
      case VTK_POLYGON:
        surfaces->InsertNextCell(points.Size(), points.begin());
        break;
      case VTK_PIXEL: // points are ordered by rows, not around the cell
        surfaces->InsertNextCell({ points[0], points[1], points[3], points[2] });
        break;
      default:
        throw Error("The domain has cells of type " + NameOfType(type) +
          "; give boundary lines or a mesh of triangles, quadrilaterals or polygons.");
      }
      if (surfaces->GetNumberOfCells() > before)
      {
        ids->InsertNextValue(cell);
      }
    });
  auto result = vtkSmartPointer<vtkPolyData>::New();
  const bool isSurface = surfaces->GetNumberOfCells() > 0;
  vtkCellArray* cells = isSurface ? surfaces : lines;
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->SetNumberOfPoints(input->GetNumberOfPoints());
  result->SetPoints(points);
  isSurface ? result->SetPolys(cells) : result->SetLines(cells);
  const UsedPoints used(result);
  vtkNew<vtkPoints> kept;
  kept->SetDataTypeToDouble();
  for (const vtkIdType point : used.GetIds())
  {
    double place[3];
    input->GetPoint(point, place);
    InputCheck::RequireFinite(place, point);
    kept->InsertNextPoint(place);
  }
  vtkNew<vtkCellArray> numbered;
  CellLoop::ForEachInList(cells,
    [&](vtkIdType, const CellLoop::Points& cell)
    {
      numbered->InsertNextCell(static_cast<int>(cell.Size()));
      for (const vtkIdType point : cell)
      {
        numbered->InsertCellPoint(used.IndexOf(point));
      }
    });
  isSurface ? result->SetPolys(numbered) : result->SetLines(numbered);
  result->SetPoints(kept);
  if (isSurface)
  {
    result->GetCellData()->AddArray(ids);
  }
  return result;
}

/**
 * Returns lines along the boundary of the cells. Throws crossfield::Error if an edge has more than
 * two cells.
 */
vtkSmartPointer<vtkPolyData> SurfaceBoundary(vtkPolyData* surface)
{
  vtkNew<vtkFeatureEdges> edges;
  edges->SetInputData(surface);
  edges->ColoringOff();
  edges->FeatureEdgesOff();
  edges->ManifoldEdgesOff();
  edges->BoundaryEdgesOff();
  edges->NonManifoldEdgesOn();
  edges->Update();
  if (edges->GetOutput()->GetNumberOfCells() > 0)
  {
    throw Error("The domain has edges with more than two cells; give a manifold planar mesh.");
  }
  edges->NonManifoldEdgesOff();
  edges->BoundaryEdgesOn();
  edges->Update();
  return edges->GetOutput();
}

/**
 * Merge tolerance, relative to the diagonal of the bounding box. It is above the rounding of
 * coordinates that were written and read back.
 */
constexpr double MergeTolerance = 1e-9;

vtkSmartPointer<vtkPolyData> MergePoints(vtkPolyData* input, double tolerance)
{
  vtkNew<vtkCleanPolyData> clean;
  clean->SetInputData(input);
  clean->SetTolerance(tolerance);
  // The default locator has buckets of one size, and a long curve is in only a few of them.
  vtkNew<vtkIncrementalOctreePointLocator> locator;
  clean->SetLocator(locator);
  clean->ConvertLinesToPointsOn();
  clean->Update();
  return clean->GetOutput();
}

/**
 * Throws crossfield::Error if surface cells overlap, which the boundary of their parts does not
 * show.
 */
void RequireCoveredOnce(vtkPolyData* surface, const std::vector<DomainConversion::Domain>& parts)
{
  double area = 0.0;
  vtkNew<vtkIdList> cell;
  for (vtkIdType i = 0; i < surface->GetNumberOfPolys(); ++i)
  {
    surface->GetPolys()->GetCellAtId(i, cell);
    crossfield::Loop corners;
    for (vtkIdType id : *cell)
    {
      corners.push_back(parts[0].plane.ToPlane(Eigen::Vector3d(surface->GetPoint(id))));
    }
    area += std::abs(crossfield::SignedArea(corners)); // neighbours may have opposite orientations
  }
  double enclosed = 0.0;
  for (const DomainConversion::Domain& part : parts)
  {
    enclosed += part.domain.Area();
  }
  double bounds[6];
  surface->GetBounds(bounds);
  const double diagonal = vtkBoundingBox(bounds).GetDiagonalLength();
  // Both sums use the same points and differ only by rounding, far below MergeTolerance. Smaller
  // overlaps are ignored.
  if (std::abs(area - enclosed) > MergeTolerance * diagonal * diagonal)
  {
    std::ostringstream text;
    text << "The areas of the domain's cells add up to " << area << ", but their boundary encloses "
         << enclosed << "; give a mesh whose cells do not overlap, fold over or cross themselves.";
    throw Error(text.str());
  }
}

void WarnOfFlattening(const crossfield::DomainPlane& plane, vtkObject* self)
{
  const std::string warning = plane.FlatteningWarning();
  if (self != nullptr && !warning.empty())
  {
    vtkWarningWithObjectMacro(self, << warning);
  }
}

/** Returns the loops of curves, or of the boundary of a surface, whose points are merged. */
std::vector<crossfield::Loop> ChainCurves(vtkPolyData* cells, const crossfield::DomainPlane& plane)
{
  vtkSmartPointer<vtkPolyData> curves = cells;
  if (cells->GetNumberOfPolys() > 0)
  {
    curves = SurfaceBoundary(cells);
  }
  if (curves->GetNumberOfLines() == 0)
  {
    throw Error(
      "The domain has no boundary lines and no surface cells, or all of them shrink to a point; "
      "give closed curves or a mesh.");
  }

  std::vector<Point> points;
  for (vtkIdType i = 0; i < curves->GetNumberOfPoints(); ++i)
  {
    points.push_back(plane.ToPlane(Eigen::Vector3d(curves->GetPoint(i))));
  }
  std::vector<std::array<int, 2>> segments;
  vtkNew<vtkIdList> line;
  for (vtkIdType i = 0; i < curves->GetNumberOfLines(); ++i)
  {
    curves->GetLines()->GetCellAtId(i, line);
    for (vtkIdType j = 1; j < line->GetNumberOfIds(); ++j)
    {
      segments.push_back(
        { static_cast<int>(line->GetId(j - 1)), static_cast<int>(line->GetId(j)) });
    }
  }
  return crossfield::ChainLoops(points, segments);
}

/**
 * Throws an error with another message if the loops fail only because unequal points were merged.
 */
void RejectMergedPoints(vtkPolyData* cells, const crossfield::DomainPlane& plane)
{
  try
  {
    ChainCurves(MergePoints(cells, 0.0), plane);
  }
  catch (const Error&)
  {
    return;
  }
  throw Error(
    "The boundary has points closer to each other than 1e-9 of its diagonal; they count as one, "
    "and its curves are then not closed. Move the points apart or remove the narrow part.");
}
}

namespace DomainConversion
{
//------------------------------------------------------------------------------
crossfield::DomainPlane FindPlane(vtkDataSet* input)
{
  return UsedPoints(input).FindPlane(input);
}

namespace
{
/** Cells with merged points, and their boundary. */
struct MergedCells
{
  vtkSmartPointer<vtkPolyData> cells;
  Boundary boundary;
};

MergedCells ReadMerged(vtkDataSet* input)
{
  InputCheck::Require(input);
  const vtkSmartPointer<vtkPolyData> cells = ExtractCurvesOrSurfaces(input);
  double bounds[6]; // without points, lower bounds exceed upper bounds
  cells->GetBounds(bounds);
  crossfield::RequireExtent(
    std::max({ 0.0, bounds[1] - bounds[0], bounds[3] - bounds[2], bounds[5] - bounds[4] }));
  MergedCells result{ MergePoints(cells, MergeTolerance), {} };
  // Also checks the inside of a surface, which may not be planar although its boundary is.
  result.boundary.plane = FindPlane(result.cells);
  try
  {
    result.boundary.loops = ChainCurves(result.cells, result.boundary.plane);
  }
  catch (const Error&)
  {
    RejectMergedPoints(cells, result.boundary.plane);
    throw;
  }
  return result;
}
}

//------------------------------------------------------------------------------
Boundary ReadLoops(vtkDataSet* input)
{
  return ReadMerged(input).boundary;
}

//------------------------------------------------------------------------------
Domain ReadDomain(vtkDataSet* input, vtkObject* self)
{
  MergedCells merged = ReadMerged(input);
  WarnOfFlattening(merged.boundary.plane, self);
  Domain result{ crossfield::MakePlanarDomain(std::move(merged.boundary.loops)),
    merged.boundary.plane };
  if (merged.cells->GetNumberOfPolys() > 0)
  {
    RequireCoveredOnce(merged.cells, { result });
  }
  result.domain = crossfield::WithExactSymmetries(result.domain);
  return result;
}

//------------------------------------------------------------------------------
std::vector<Domain> ReadParts(vtkDataSet* input, vtkObject* self)
{
  const MergedCells merged = ReadMerged(input);
  WarnOfFlattening(merged.boundary.plane, self);
  std::vector<Domain> parts;
  for (crossfield::PlanarDomain& part : crossfield::SplitParts(merged.boundary.loops))
  {
    parts.push_back({ std::move(part), merged.boundary.plane });
  }
  if (merged.cells->GetNumberOfPolys() > 0)
  {
    RequireCoveredOnce(merged.cells, parts);
  }
  for (Domain& part : parts)
  {
    part.domain = crossfield::WithExactSymmetries(part.domain);
  }
  return parts;
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkPolyData> ReadSurface(vtkDataSet* input)
{
  InputCheck::Require(input);
  const vtkSmartPointer<vtkPolyData> ofVolumes = SurfaceOfVolumes(input);
  vtkSmartPointer<vtkPolyData> surface =
    ExtractCurvesOrSurfaces(ofVolumes != nullptr ? ofVolumes.Get() : input);
  if (ofVolumes != nullptr)
  {
    vtkDataArray* original = ofVolumes->GetCellData()->GetArray(OriginalCells);
    vtkDataArray* ids = surface->GetCellData()->GetArray(OriginalCells);
    for (vtkIdType cell = 0; ids != nullptr && cell < ids->GetNumberOfTuples(); ++cell)
    {
      ids->SetTuple1(cell, original->GetTuple1(static_cast<vtkIdType>(ids->GetTuple1(cell))));
    }
  }
  vtkSmartPointer<vtkPolyData> cells = MergePoints(surface, MergeTolerance);
  if (cells->GetNumberOfPolys() == 0)
  {
    throw Error(
      "A domain of several materials needs surface cells, which have the materials; give a mesh.");
  }
  return cells;
}

//------------------------------------------------------------------------------
void WriteLoops(const std::vector<crossfield::Loop>& loops, vtkPolyData* output)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> lines;
  for (const crossfield::Loop& loop : loops)
  {
    const vtkIdType first = points->GetNumberOfPoints();
    lines->InsertNextCell(static_cast<int>(loop.size()) + 1);
    for (const Point& point : loop)
    {
      lines->InsertCellPoint(points->InsertNextPoint(point.x(), point.y(), 0.0));
    }
    lines->InsertCellPoint(first);
  }
  output->SetPoints(points);
  output->SetLines(lines);
}
}
