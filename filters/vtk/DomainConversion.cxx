#include "DomainConversion.h"

#include "BoundaryLoops.h"
#include "ColumnWriting.h"
#include "DomainExtent.h"
#include "Error.h"
#include "InputCheck.h"
#include "MakePlanarDomain.h"
#include "QuarterIndexRange.h"
#include "vtkCrossFieldArrayNames.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkCellTypes.h"
#include "vtkCleanPolyData.h"
#include "vtkDataSet.h"
#include "vtkFeatureEdges.h"
#include "vtkIdList.h"
#include "vtkIncrementalOctreePointLocator.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <sstream>
#include <string>
#include <utility>

namespace
{
using crossfield::Error;
using crossfield::Point;

/**
 * The points that lines and surface cells use. Others, which vertices may use, count for nothing: they
 * may be anywhere.
 */
class UsedPoints
{
public:
  explicit UsedPoints(vtkDataSet* input)
    : Numbers(static_cast<std::size_t>(input->GetNumberOfPoints()), -1)
  {
    vtkNew<vtkIdList> points;
    for (vtkIdType cell = 0; cell < input->GetNumberOfCells(); ++cell)
    {
      const int type = input->GetCellType(cell);
      if (type == VTK_EMPTY_CELL || type == VTK_VERTEX || type == VTK_POLY_VERTEX)
      {
        continue;
      }
      input->GetCellPoints(cell, points);
      for (const vtkIdType point : *points)
      {
        this->Numbers[static_cast<std::size_t>(point)] = 0;
      }
    }
    for (vtkIdType point = 0; point < input->GetNumberOfPoints(); ++point)
    {
      if (this->Numbers[static_cast<std::size_t>(point)] == 0)
      {
        this->Numbers[static_cast<std::size_t>(point)] = static_cast<int>(this->Ids.size());
        this->Ids.push_back(point);
      }
    }
  }

  /** In ascending order. */
  const std::vector<vtkIdType>& GetIds() const { return this->Ids; }

  /** Where a used point is among them. */
  int NumberOf(vtkIdType point) const { return this->Numbers[static_cast<std::size_t>(point)]; }

  crossfield::DomainPlane FindPlane(vtkDataSet* input) const
  {
    Eigen::Matrix3Xd places(3, static_cast<Eigen::Index>(this->Ids.size()));
    for (Eigen::Index i = 0; i < places.cols(); ++i)
    {
      input->GetPoint(this->Ids[static_cast<std::size_t>(i)], places.col(i).data());
    }
    return crossfield::DomainPlane::Find(places);
  }

private:
  std::vector<int> Numbers; ///< −1 for points that are not used.
  std::vector<vtkIdType> Ids;
};

void RequireFinite(const double* place, vtkIdType point)
{
  if (!std::isfinite(place[0]) || !std::isfinite(place[1]) || !std::isfinite(place[2]))
  {
    throw Error("Point " + std::to_string(point) +
      " of the domain has coordinates that are not finite numbers; correct or remove it.");
  }
}

/**
 * The surface cells of a data set, or else its lines, with the points that they use; other cells than
 * vertices are refused, and so are places that are not finite.
 */
vtkSmartPointer<vtkPolyData> ExtractCurvesOrSurfaces(vtkDataSet* input)
{
  vtkNew<vtkCellArray> lines;
  vtkNew<vtkCellArray> surfaces;
  vtkNew<vtkIdList> ids;
  for (vtkIdType cell = 0; cell < input->GetNumberOfCells(); ++cell)
  {
    const int type = input->GetCellType(cell);
    input->GetCellPoints(cell, ids);
    switch (type)
    {
    case VTK_EMPTY_CELL:
    case VTK_VERTEX:
    case VTK_POLY_VERTEX:
      break;
    case VTK_LINE:
    case VTK_POLY_LINE:
      lines->InsertNextCell(ids);
      break;
    case VTK_TRIANGLE:
    case VTK_QUAD:
    case VTK_POLYGON:
      surfaces->InsertNextCell(ids);
      break;
    case VTK_PIXEL: // its points go row by row, not around
      surfaces->InsertNextCell({ ids->GetId(0), ids->GetId(1), ids->GetId(3), ids->GetId(2) });
      break;
    default:
      throw Error("The domain has cells of type " +
        std::string(vtkCellTypes::GetClassNameFromTypeId(type)) +
        "; give boundary lines or a mesh of triangles, quadrilaterals or polygons.");
    }
  }
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
    RequireFinite(place, point);
    kept->InsertNextPoint(place);
  }
  for (vtkIdType cell = 0; cell < cells->GetNumberOfCells(); ++cell)
  {
    cells->GetCellAtId(cell, ids);
    for (vtkIdType& point : *ids)
    {
      point = used.NumberOf(point);
    }
    cells->ReplaceCellAtId(cell, ids);
  }
  result->SetPoints(kept);
  return result;
}

/** Lines along the cells' boundary; refuses edges with more than two cells. */
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

/** Of the bounding box's diagonal: rounding of coordinates that were written out and read back. */
constexpr double OnePoint = 1e-9;

vtkSmartPointer<vtkPolyData> MergePoints(vtkPolyData* input, double tolerance)
{
  vtkNew<vtkCleanPolyData> clean;
  clean->SetInputData(input);
  clean->SetTolerance(tolerance);
  // The filter's own locator has buckets of one size, and a long curve is in few of them.
  vtkNew<vtkIncrementalOctreePointLocator> locator;
  clean->SetLocator(locator);
  clean->ConvertLinesToPointsOn();
  clean->Update();
  return clean->GetOutput();
}

/** Refuses surface cells that overlap, which their boundary does not tell. */
void RequireCoveredOnce(vtkPolyData* surface, const DomainConversion::Domain& covered)
{
  double area = 0.0;
  vtkNew<vtkIdList> cell;
  for (vtkIdType i = 0; i < surface->GetNumberOfPolys(); ++i)
  {
    surface->GetPolys()->GetCellAtId(i, cell);
    crossfield::Loop corners;
    for (vtkIdType id : *cell)
    {
      corners.push_back(covered.plane.ToPlane(Eigen::Vector3d(surface->GetPoint(id))));
    }
    area +=
      std::abs(crossfield::SignedArea(corners)); // neighbours may be oriented against each other
  }
  const double enclosed = covered.domain.Area();
  const double diagonal = covered.domain.Diagonal();
  // Both sums are of the same points, so they differ by rounding only; OnePoint is far above that, and
  // what is less counts as nothing here.
  if (std::abs(area - enclosed) > OnePoint * diagonal * diagonal)
  {
    std::ostringstream text;
    text << "The areas of the domain's cells add up to " << area << ", but their boundary encloses "
         << enclosed << "; give a mesh whose cells do not overlap, fold over or cross themselves.";
    throw Error(text.str());
  }
}

/** The loops of curves, or of the boundary of a surface, whose points are merged. */
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
      "The domain has no boundary lines and no surface cells, or only such as shrink to a "
      "point; give closed curves or a mesh.");
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

/** Throws another error where it is the merging of points that are not equal which made the loops fail. */
void RequireChainsWhenMerged(vtkPolyData* cells, const crossfield::DomainPlane& plane)
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
    "The boundary has points nearer to each other than 1e-9 of its diagonal, which count as "
    "one, and then its curves are not closed; move them apart or remove what is so narrow.");
}

vtkDataArray* RequireCellArray(vtkUnstructuredGrid* grid, const char* name)
{
  vtkDataArray* array = grid->GetCellData()->GetArray(name);
  if (array == nullptr || array->GetNumberOfComponents() != 1)
  {
    throw Error(std::string("The mesh has no cell array '") + name +
      "' with one component; give a mesh made by the drill filter.");
  }
  return array;
}

vtkSmartPointer<vtkIntArray> NewCellArray(vtkUnstructuredGrid* grid, const char* name)
{
  auto array = vtkSmartPointer<vtkIntArray>::New();
  array->SetName(name);
  array->SetNumberOfValues(grid->GetNumberOfCells());
  grid->GetCellData()->AddArray(array);
  return array;
}
}

namespace DomainConversion
{
//------------------------------------------------------------------------------
crossfield::DomainPlane FindPlane(vtkDataSet* input)
{
  return UsedPoints(input).FindPlane(input);
}

//------------------------------------------------------------------------------
Domain ReadDomain(vtkDataSet* input)
{
  InputCheck::Require(input);
  const vtkSmartPointer<vtkPolyData> cells = ExtractCurvesOrSurfaces(input);
  double bounds[6]; // of no points, the lower ones are above the upper ones
  cells->GetBounds(bounds);
  crossfield::RequireExtent(
    std::max({ 0.0, bounds[1] - bounds[0], bounds[3] - bounds[2], bounds[5] - bounds[4] }));
  const vtkSmartPointer<vtkPolyData> merged = MergePoints(cells, OnePoint);
  Domain result;
  // Of a surface as well, which could bulge from a planar boundary.
  result.plane = FindPlane(merged);
  std::vector<crossfield::Loop> loops;
  try
  {
    loops = ChainCurves(merged, result.plane);
  }
  catch (const Error&)
  {
    RequireChainsWhenMerged(cells, result.plane);
    throw;
  }
  result.domain = crossfield::MakePlanarDomain(std::move(loops));
  if (merged->GetNumberOfPolys() > 0)
  {
    RequireCoveredOnce(merged, result);
  }
  return result;
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

//------------------------------------------------------------------------------
crossfield::Configuration ReadConfiguration(vtkDataSet* input, const crossfield::DomainPlane& plane)
{
  crossfield::Configuration configuration;
  if (input == nullptr)
  {
    return configuration;
  }
  // The array is asked for even when there are no points: a source that failed gives no points and
  // no array, and must not pass for the empty configuration.
  InputCheck::Require(input);
  vtkDataArray* quarters = input->GetPointData()->GetArray(vtkCrossFieldArrayNames::QuarterIndex);
  vtkDataArray* radii = input->GetPointData()->GetArray(vtkCrossFieldArrayNames::Radius);
  if (quarters == nullptr || quarters->GetNumberOfComponents() != 1)
  {
    throw Error("The singularities have no point array 'QuarterIndex' with one component; add it "
                "(4 times the index of each point).");
  }
  if (radii != nullptr && radii->GetNumberOfComponents() != 1)
  {
    throw Error("The point array 'Radius' of the singularities has " +
      std::to_string(radii->GetNumberOfComponents()) + " components; give one radius per point.");
  }
  for (vtkIdType i = 0; i < input->GetNumberOfPoints(); ++i)
  {
    const int quarterIndex = crossfield::RequireQuarterIndex(
      quarters->GetTuple1(i), "The quarter index of singularity " + std::to_string(i + 1));
    crossfield::Singularity singularity;
    singularity.position = plane.RequireInPlane(
      Eigen::Vector3d(input->GetPoint(i)), "The singularity " + std::to_string(i + 1));
    singularity.quarterIndex = quarterIndex;
    if (radii != nullptr)
    {
      singularity.radius = radii->GetTuple1(i);
      if (!(singularity.radius > 0.0))
      {
        throw Error("The radius of singularity " + std::to_string(i + 1) +
          " is not positive; give a positive radius, or leave the array 'Radius' out.");
      }
    }
    configuration.push_back(singularity);
  }
  return configuration;
}

//------------------------------------------------------------------------------
void WriteConfiguration(const crossfield::Configuration& configuration,
  const crossfield::DomainPlane& plane, vtkPolyData* output)
{
  using crossfield::Singularity;
  ColumnWriting::WritePlaces(configuration, plane, output);
  vtkFieldData* data = output->GetPointData();
  ColumnWriting::AddColumn<vtkIntArray>(data, vtkCrossFieldArrayNames::QuarterIndex, configuration,
    [](const Singularity& singularity) { return singularity.quarterIndex; });
  if (std::any_of(configuration.begin(), configuration.end(),
        [](const Singularity& singularity) { return singularity.radius > 0.0; }))
  {
    ColumnWriting::AddColumn<vtkDoubleArray>(data, vtkCrossFieldArrayNames::Radius, configuration,
      [](const Singularity& singularity) { return singularity.radius; });
  }
}

//------------------------------------------------------------------------------
vtkUnstructuredGrid* AsDrilledMesh(vtkDataSet* input)
{
  auto* grid = vtkUnstructuredGrid::SafeDownCast(input);
  return grid != nullptr &&
      grid->GetCellData()->GetArray(vtkCrossFieldArrayNames::BoundaryKind) != nullptr
    ? grid
    : nullptr;
}

//------------------------------------------------------------------------------
DrilledMesh ReadDrilledMesh(vtkUnstructuredGrid* input)
{
  InputCheck::Require(input);
  vtkDataArray* kinds = RequireCellArray(input, vtkCrossFieldArrayNames::BoundaryKind);
  vtkDataArray* ids = RequireCellArray(input, vtkCrossFieldArrayNames::BoundaryId);
  vtkDataArray* quarters = RequireCellArray(input, vtkCrossFieldArrayNames::QuarterIndex);
  DrilledMesh result;
  crossfield::TriangleMesh mesh;
  const UsedPoints used(input);
  result.plane = used.FindPlane(input);
  result.pointIds = used.GetIds();
  for (const vtkIdType point : result.pointIds)
  {
    mesh.points.push_back(result.plane.ToPlane(Eigen::Vector3d(input->GetPoint(point))));
  }
  vtkNew<vtkIdList> points;
  for (vtkIdType cell = 0; cell < input->GetNumberOfCells(); ++cell)
  {
    input->GetCellPoints(cell, points);
    const auto vertex = [&](vtkIdType i) { return used.NumberOf(points->GetId(i)); };
    const int kind = static_cast<int>(kinds->GetTuple1(cell));
    if (input->GetCellType(cell) == VTK_TRIANGLE)
    {
      result.triangleCells.push_back(cell);
      mesh.triangles.push_back({ vertex(0), vertex(1), vertex(2) });
    }
    else if (input->GetCellType(cell) == VTK_LINE && kind >= 1 && kind <= 4)
    {
      const crossfield::BoundaryEdge edge{ { vertex(0), vertex(1) },
        static_cast<crossfield::BoundaryKind>(kind), static_cast<int>(ids->GetTuple1(cell)),
        static_cast<int>(quarters->GetTuple1(cell)) };
      const bool imprinted = edge.kind == crossfield::BoundaryKind::ImprintedCircle;
      (imprinted ? result.imprintedCells : result.lineCells).push_back(cell);
      (imprinted ? mesh.imprinted : mesh.boundary).push_back(edge);
    }
    else
    {
      throw Error("Cell " + std::to_string(cell) +
        " is neither a triangle nor a line with a BoundaryKind of 1 to 4; give a mesh made by the "
        "drill filter.");
    }
  }
  result.topology = crossfield::ShareTopology(std::move(mesh));
  return result;
}

//------------------------------------------------------------------------------
DrilledMesh NumberCells(crossfield::TriangleMesh mesh, const crossfield::DomainPlane& plane)
{
  const auto count = [](std::size_t size, vtkIdType first)
  {
    std::vector<vtkIdType> ids(size);
    std::iota(ids.begin(), ids.end(), first);
    return ids;
  };
  const auto lines = static_cast<vtkIdType>(mesh.triangles.size());
  const auto imprinted = lines + static_cast<vtkIdType>(mesh.boundary.size());
  DrilledMesh result;
  result.plane = plane;
  result.pointIds = count(mesh.points.size(), 0);
  result.triangleCells = count(mesh.triangles.size(), 0);
  result.lineCells = count(mesh.boundary.size(), lines);
  result.imprintedCells = count(mesh.imprinted.size(), imprinted);
  result.topology = crossfield::ShareTopology(std::move(mesh));
  return result;
}

//------------------------------------------------------------------------------
void WriteDrilledMesh(const crossfield::TriangleMesh& mesh, const crossfield::DomainPlane& plane,
  vtkUnstructuredGrid* output)
{
  std::vector<crossfield::BoundaryEdge> lines = mesh.boundary;
  lines.insert(lines.end(), mesh.imprinted.begin(), mesh.imprinted.end());
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->SetNumberOfPoints(static_cast<vtkIdType>(mesh.points.size()));
  for (std::size_t i = 0; i < mesh.points.size(); ++i)
  {
    points->SetPoint(static_cast<vtkIdType>(i), plane.ToSpace(mesh.points[i]).data());
  }
  vtkNew<vtkCellArray> cells;
  vtkNew<vtkUnsignedCharArray> types;
  cells->AllocateExact(static_cast<vtkIdType>(mesh.triangles.size() + lines.size()),
    static_cast<vtkIdType>(3 * mesh.triangles.size() + 2 * lines.size()));
  for (const auto& triangle : mesh.triangles)
  {
    cells->InsertNextCell({ triangle[0], triangle[1], triangle[2] });
    types->InsertNextValue(VTK_TRIANGLE);
  }
  for (const auto& edge : lines)
  {
    cells->InsertNextCell({ edge.vertices[0], edge.vertices[1] });
    types->InsertNextValue(VTK_LINE);
  }
  output->SetPoints(points);
  output->SetCells(types, cells);

  auto kinds = NewCellArray(output, vtkCrossFieldArrayNames::BoundaryKind);
  auto ids = NewCellArray(output, vtkCrossFieldArrayNames::BoundaryId);
  auto quarters = NewCellArray(output, vtkCrossFieldArrayNames::QuarterIndex);
  kinds->FillValue(0);
  ids->FillValue(-1);
  quarters->FillValue(0);
  auto cell = static_cast<vtkIdType>(mesh.triangles.size());
  for (const auto& edge : lines)
  {
    kinds->SetValue(cell, static_cast<int>(edge.kind));
    ids->SetValue(cell, edge.id);
    quarters->SetValue(cell, edge.quarterIndex);
    ++cell;
  }
  // What ParaView colours a new mesh by.
  output->GetCellData()->SetActiveScalars(vtkCrossFieldArrayNames::BoundaryKind);
}
}
