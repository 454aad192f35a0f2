#include "SizeConversion.h"

#include "CellLoop.h"
#include "DrilledMeshConversion.h"
#include "Error.h"
#include "MeshForPoints.h"
#include "SizeExtension.h"
#include "UsedPoints.h"
#include "vtkQuadMesher.h"

#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkGenericCell.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkStaticCellLocator.h"
#include "vtkUnstructuredGrid.h"

#include <cmath>
#include <memory>
#include <vector>

namespace
{
using crossfield::Error;

/** Interpolates values at the points of a data set, at the place of its cells that is nearest. */
class Sampler
{
public:
  Sampler(vtkDataSet* cells, std::vector<double> values)
    : Values(std::move(values))
    , Weights(static_cast<std::size_t>(cells->GetMaxCellSize()))
  {
    this->Locator->SetDataSet(cells);
    this->Locator->BuildLocator();
  }

  double At(const Eigen::Vector3d& place)
  {
    double nearest[3];
    double parametric[3];
    double squaredDistance = 0.0;
    vtkIdType number = -1;
    int part = 0;
    this->Locator->FindClosestPoint(
      place.data(), nearest, this->Cell, number, part, squaredDistance);
    this->Cell->EvaluatePosition(
      nearest, nullptr, part, parametric, squaredDistance, this->Weights.data());
    double value = 0.0;
    for (vtkIdType i = 0; i < this->Cell->GetNumberOfPoints(); ++i)
    {
      value += this->Weights[static_cast<std::size_t>(i)] *
        this->Values[static_cast<std::size_t>(this->Cell->GetPointId(static_cast<int>(i)))];
    }
    return value;
  }

private:
  vtkNew<vtkStaticCellLocator> Locator;
  vtkNew<vtkGenericCell> Cell;
  std::vector<double> Values;
  std::vector<double> Weights;
};

/** At the used points. */
std::vector<double> RequireSizes(
  vtkDataSet* domain, const UsedPoints& used, const std::string& name)
{
  vtkDataArray* array = domain->GetPointData()->GetArray(name.c_str());
  if (array == nullptr || array->GetNumberOfComponents() != 1)
  {
    throw Error("The domain has no point array '" + name +
      "' with one component; name one with the wanted length of quads at each point.");
  }
  std::vector<double> sizes;
  for (const vtkIdType point : used.GetIds())
  {
    sizes.push_back(array->GetTuple1(point));
    if (!(sizes.back() > 0.0) || !std::isfinite(sizes.back()))
    {
      throw Error("The wanted size at point " + std::to_string(point) +
        " of the domain is not a positive number; correct the array '" + name + "'.");
    }
  }
  return sizes;
}

bool IsSurface(int type)
{
  return type == VTK_TRIANGLE || type == VTK_QUAD || type == VTK_PIXEL || type == VTK_POLYGON;
}

/**
 * The cells of a surface, or else the segments of all lines, as VTK gives no weights along a polyline; with the used points
 * alone, as a locator goes by the bounds of all points.
 */
vtkSmartPointer<vtkUnstructuredGrid> CellsToSample(
  vtkDataSet* domain, const UsedPoints& used, bool hasSurface)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (const vtkIdType point : used.GetIds())
  {
    points->InsertNextPoint(domain->GetPoint(point));
  }
  auto cells = vtkSmartPointer<vtkUnstructuredGrid>::New();
  cells->SetPoints(points);
  cells->Allocate(domain->GetNumberOfCells());
  std::vector<vtkIdType> ids;
  CellLoop::ForEachCell(domain,
    [&](vtkIdType, int type, const auto& cell)
    {
      ids.clear();
      for (const auto point : cell)
      {
        ids.push_back(used.IndexOf(static_cast<vtkIdType>(point)));
      }
      if (hasSurface && IsSurface(type))
      {
        cells->InsertNextCell(type, static_cast<vtkIdType>(ids.size()), ids.data());
      }
      const bool isLine = type == VTK_LINE || type == VTK_POLY_LINE;
      for (std::size_t i = 1; !hasSurface && isLine && i < ids.size(); ++i)
      {
        cells->InsertNextCell(VTK_LINE, 2, &ids[i - 1]);
      }
    });
  return cells;
}
}

namespace SizeConversion
{
//------------------------------------------------------------------------------
Sizes ReadSizes(vtkDataSet* domain, const std::string& name, const crossfield::DomainPlane& plane,
  const crossfield::MeshTopology& topology)
{
  const UsedPoints used(domain);
  bool hasSurface = false;
  CellLoop::ForEachCell(domain,
    [&hasSurface](vtkIdType, int type, const auto&)
    { hasSurface = hasSurface || IsSurface(type); });
  const auto cells = CellsToSample(domain, used, hasSurface);
  Sampler given(cells, RequireSizes(domain, used, name));
  const crossfield::TriangleMesh& mesh = topology.mesh;
  Eigen::VectorXd sizes(static_cast<Eigen::Index>(mesh.points.size()));
  if (hasSurface)
  {
    for (Eigen::Index v = 0; v < sizes.size(); ++v)
    {
      sizes[v] = given.At(plane.ToSpace(mesh.points[static_cast<std::size_t>(v)]));
    }
  }
  else
  {
    for (const crossfield::BoundaryEdge& edge : mesh.boundary)
    {
      const int vertex = edge.vertices[0];
      sizes[vertex] = given.At(plane.ToSpace(topology.PointAt(vertex)));
    }
    sizes = crossfield::ExtendSizes(topology, sizes);
  }
  Sizes result;
  result.mean = crossfield::EquivalentSize(mesh, sizes);
  sizes /= result.mean;
  vtkNew<vtkUnstructuredGrid> grid;
  DrilledMeshConversion::WriteDrilledMesh(mesh, plane, grid);
  const auto sampler =
    std::make_shared<Sampler>(grid, std::vector<double>(sizes.data(), sizes.data() + sizes.size()));
  result.relative = [sampler, plane](const crossfield::Point& place)
  { return sampler->At(plane.ToSpace(place)); };
  return result;
}

//------------------------------------------------------------------------------
Sizes ReadSizes(vtkDataSet* domain, const std::string& name, const DomainConversion::Domain& input,
  double meshSize)
{
  const crossfield::SharedTopology topology =
    crossfield::ShareTopology(crossfield::MeshOnPoints(input.domain, {}, meshSize));
  return ReadSizes(domain, name, input.plane, *topology);
}

//------------------------------------------------------------------------------
void ChooseForQuads(vtkDataSet* domain, const DomainConversion::Domain& input,
  const QuadRequest& request, crossfield::AutomaticOptions& automatic)
{
  automatic.quadSize = request.quadSize;
  automatic.quadCount = request.quadCount;
  automatic.optimizer.pairs = request.pairs;
  automatic.optimizer.uniformSizes = request.sizing != vtkQuadMesher::SizingConformal;
  if (request.sizing == vtkQuadMesher::SizingField)
  {
    const Sizes sizes = ReadSizes(domain, request.sizeArray, input, automatic.optimizer.meshSize);
    automatic.optimizer.wantedSize = sizes.relative;
    automatic.quadSize *= sizes.mean; // a factor of the array's lengths
  }
}
}
