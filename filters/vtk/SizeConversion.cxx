#include "SizeConversion.h"

#include "DrilledMeshConversion.h"
#include "Error.h"
#include "SizeExtension.h"

#include "vtkCellArray.h"
#include "vtkCellTypes.h"
#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkGenericCell.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
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

std::vector<double> RequireSizes(vtkDataSet* domain, const std::string& name)
{
  vtkDataArray* array = domain->GetPointData()->GetArray(name.c_str());
  if (array == nullptr || array->GetNumberOfComponents() != 1)
  {
    throw Error("The domain has no point array '" + name +
      "' with one component; name one with the wanted length of quads at each point.");
  }
  std::vector<double> sizes;
  for (vtkIdType point = 0; point < array->GetNumberOfTuples(); ++point)
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

bool HasSurface(vtkDataSet* domain)
{
  vtkNew<vtkCellTypes> types;
  domain->GetCellTypes(types);
  for (const int type : { VTK_TRIANGLE, VTK_QUAD, VTK_PIXEL, VTK_POLYGON })
  {
    if (types->IsType(static_cast<unsigned char>(type)) != 0)
    {
      return true;
    }
  }
  return false;
}

/** The segments of all lines: VTK gives no weights along a polyline. */
vtkSmartPointer<vtkPolyData> SegmentsOf(vtkDataSet* curves)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (vtkIdType point = 0; point < curves->GetNumberOfPoints(); ++point)
  {
    points->InsertNextPoint(curves->GetPoint(point));
  }
  vtkNew<vtkCellArray> lines;
  vtkNew<vtkIdList> ids;
  for (vtkIdType cell = 0; cell < curves->GetNumberOfCells(); ++cell)
  {
    if (curves->GetCellType(cell) == VTK_LINE || curves->GetCellType(cell) == VTK_POLY_LINE)
    {
      curves->GetCellPoints(cell, ids);
      for (vtkIdType i = 1; i < ids->GetNumberOfIds(); ++i)
      {
        lines->InsertNextCell({ ids->GetId(i - 1), ids->GetId(i) });
      }
    }
  }
  auto segments = vtkSmartPointer<vtkPolyData>::New();
  segments->SetPoints(points);
  segments->SetLines(lines);
  return segments;
}
}

namespace SizeConversion
{
//------------------------------------------------------------------------------
Sizes ReadSizes(vtkDataSet* domain, const std::string& name, const crossfield::DomainPlane& plane,
  const crossfield::MeshTopology& topology)
{
  std::vector<double> given = RequireSizes(domain, name);
  const crossfield::TriangleMesh& mesh = topology.mesh;
  Eigen::VectorXd sizes(static_cast<Eigen::Index>(mesh.points.size()));
  if (HasSurface(domain))
  {
    Sampler sampler(domain, std::move(given));
    for (Eigen::Index v = 0; v < sizes.size(); ++v)
    {
      sizes[v] = sampler.At(plane.ToSpace(mesh.points[static_cast<std::size_t>(v)]));
    }
  }
  else
  {
    const vtkSmartPointer<vtkPolyData> segments = SegmentsOf(domain);
    Sampler sampler(segments, std::move(given));
    for (const crossfield::BoundaryEdge& edge : mesh.boundary)
    {
      const int vertex = edge.vertices[0];
      sizes[vertex] = sampler.At(plane.ToSpace(topology.PointAt(vertex)));
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
}
