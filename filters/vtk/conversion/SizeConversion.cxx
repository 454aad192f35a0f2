#include "SizeConversion.h"

#include "CellOutline.h"
#include "Error.h"
#include "UsedPoints.h"
#include "vtkQuadMesher.h"
#include "vtkSingularityOptimizer.h"

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
#include <utility>
#include <vector>

namespace
{
using crossfield::Error;

/** Interpolates point values of a data set at the nearest point of its cells. */
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
      value += this->Weights[i] * this->Values[this->Cell->GetPointId(static_cast<int>(i))];
    }
    return value;
  }

private:
  vtkNew<vtkStaticCellLocator> Locator;
  vtkNew<vtkGenericCell> Cell;
  std::vector<double> Values;
  std::vector<double> Weights;
};

/** Returns the lengths at the used points; throws where they are missing or not positive. */
std::vector<double> RequireLengths(
  vtkDataSet* domain, const UsedPoints& used, const std::string& name)
{
  vtkDataArray* array = domain->GetPointData()->GetArray(name.c_str());
  if (array == nullptr && (name.empty() || name == "None")) // ParaView's choice of no array
  {
    throw Error(
      "No size array is chosen; choose a point array of the domain with the target length "
      "of quads at each point, or another sizing.");
  }
  if (array == nullptr || array->GetNumberOfComponents() != 1)
  {
    throw Error("The domain has no point array '" + name +
      "' with one component; name one with the target length of quads at each point.");
  }
  std::vector<double> lengths;
  for (const vtkIdType point : used.GetIds())
  {
    lengths.push_back(array->GetTuple1(point));
    if (!(lengths.back() > 0.0) || !std::isfinite(lengths.back()))
    {
      throw Error("The target size at point " + std::to_string(point) +
        " of the domain is not a positive number; correct the array '" + name + "'.");
    }
  }
  return lengths;
}

bool IsSurface(int type)
{
  return type == VTK_TRIANGLE || type == VTK_QUAD || type == VTK_PIXEL || type == VTK_POLYGON;
}

/**
 * Returns the surface cells, or where there are none the segments of all lines, since VTK has no
 * weights along a polyline. The grid holds the used points only: a locator is built on the bounds
 * of all points.
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
  CellOutline::ForEachCell(domain,
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
crossfield::Sizing ReadSizing(int sizing)
{
  static_assert(static_cast<int>(vtkSingularityOptimizer::SizingUniform) ==
      static_cast<int>(vtkQuadMesher::SizingUniform) &&
    static_cast<int>(vtkSingularityOptimizer::SizingField) ==
      static_cast<int>(vtkQuadMesher::SizingField));
  switch (sizing)
  {
  case vtkQuadMesher::SizingUniform:
    return crossfield::Sizing::Uniform;
  case vtkQuadMesher::SizingField:
    return crossfield::Sizing::Field;
  default:
    return crossfield::Sizing::Conformal;
  }
}

//------------------------------------------------------------------------------
crossfield::PrescribedSizes ReadSizes(
  vtkDataSet* domain, const std::string& name, const crossfield::DomainPlane& plane)
{
  const UsedPoints used(domain);
  bool hasSurface = false;
  CellOutline::ForEachCell(domain,
    [&hasSurface](vtkIdType, int type, const auto&)
    { hasSurface = hasSurface || IsSurface(type); });
  const auto cells = CellsToSample(domain, used, hasSurface);
  const auto sampler = std::make_shared<Sampler>(cells, RequireLengths(domain, used, name));
  crossfield::PrescribedSizes sizes;
  sizes.length = [sampler, plane](const crossfield::Point& place)
  { return sampler->At(plane.ToSpace(place)); };
  sizes.isOnBoundaryOnly = !hasSurface;
  for (const vtkIdType point : used.GetIds())
  {
    sizes.places.push_back(plane.ToPlane(Eigen::Vector3d(domain->GetPoint(point))));
  }
  return sizes;
}

//------------------------------------------------------------------------------
std::function<double(const crossfield::SpacePoint&)> ReadSizesOnSurface(
  vtkDataSet* surface, const std::string& name)
{
  const UsedPoints used(surface);
  const auto sampler = std::make_shared<Sampler>(
    CellsToSample(surface, used, true), RequireLengths(surface, used, name));
  return [sampler](const crossfield::SpacePoint& place) { return sampler->At(place); };
}
}
