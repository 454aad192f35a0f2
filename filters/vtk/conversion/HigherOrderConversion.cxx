#include "HigherOrderConversion.h"

#include "ColumnWriting.h"
#include "CurveConversion.h"
#include "DomainConversion.h"
#include "Error.h"
#include "InputCheck.h"
#include "PeriodicConversion.h"
#include "QuadConversion.h"
#include "SegmentCurveConversion.h"
#include "vtkCrossFieldArrayNames.h"

#include "vtkCellData.h"
#include "vtkCellType.h"
#include "vtkDataArray.h"
#include "vtkIdList.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkStringArray.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace names = vtkCrossFieldArrayNames;

namespace
{
using crossfield::CurvedQuads;
using crossfield::Error;

/** Throws Error unless quads and boundary have the arrays of vtkQuadMesher's outputs. */
void RequireBoundaryOf(vtkUnstructuredGrid* quads, vtkPolyData* boundary)
{
  const auto hasCells = [](vtkDataSet* data, const char* name)
  { return data->GetCellData()->GetAbstractArray(name) != nullptr; };
  vtkDataArray* vertices = boundary->GetPointData()->GetArray(names::VertexId);
  const auto isVertex = [&](vtkIdType i)
  {
    const double id = vertices->GetTuple1(i);
    return id >= 0.0 && id < static_cast<double>(quads->GetNumberOfPoints());
  };
  bool isValid = vertices != nullptr && vertices->GetNumberOfComponents() == 1 &&
    boundary->GetNumberOfLines() == boundary->GetNumberOfCells();
  for (vtkIdType i = 0; isValid && i < boundary->GetNumberOfPoints(); ++i)
  {
    isValid = isVertex(i);
  }
  for (vtkIdType i = 0; isValid && i < boundary->GetNumberOfCells(); ++i)
  {
    isValid = boundary->GetCellType(i) == VTK_LINE;
  }
  for (const char* name : { names::BoundaryKind, names::BoundaryId, names::Side })
  {
    isValid = isValid && hasCells(boundary, name);
  }
  for (const char* name :
    { names::BlockId, names::I, names::J, names::ScaledJacobian, names::SizeRatio })
  {
    isValid = isValid && hasCells(quads, name);
  }
  if (!isValid)
  {
    throw Error(
      "The inputs are not the quads and the boundary of one mesh; connect the outputs Quads "
      "and Boundary of the same Quad Mesher.");
  }
}

/** Returns the number of a name in a list, to which it is added if it is new. */
int NumberOf(const std::string& name, std::vector<std::string>& all)
{
  const auto found = std::find(all.begin(), all.end(), name);
  const auto number = static_cast<int>(found - all.begin());
  if (found == all.end())
  {
    all.push_back(name);
  }
  return number;
}

/** A new point: the points that it is between, with weights. */
struct Mixture
{
  std::vector<vtkIdType> points;
  std::vector<double> weights;
  int quads = 0; ///< Number of quads that it belongs to.
  bool onBoundary = false;
};

/** Returns for each new point, by its number less that of old points, what it is between. */
std::vector<Mixture> MixturesOf(
  const HigherOrderConversion::Quads& quads, const CurvedQuads& curved)
{
  const std::size_t old = quads.straight.points.size();
  const int p = curved.order;
  std::vector<Mixture> mixtures(curved.points.size() - old);
  for (std::size_t q = 0; q < curved.quads.size(); ++q)
  {
    for (int j = 0; j <= p; ++j)
    {
      for (int i = 0; i <= p; ++i)
      {
        const auto point =
          static_cast<std::size_t>(curved.quads[q][static_cast<std::size_t>(j * (p + 1) + i)]);
        if (point < old)
        {
          continue;
        }
        Mixture& mixture = mixtures[point - old];
        ++mixture.quads;
        const double x = static_cast<double>(i) / p;
        const double y = static_cast<double>(j) / p;
        mixture.points.assign(quads.straight.quads[q].begin(), quads.straight.quads[q].end());
        mixture.weights = { (1.0 - x) * (1.0 - y), x * (1.0 - y), x * y, (1.0 - x) * y };
      }
    }
  }
  for (std::size_t e = 0; e < curved.edges.size(); ++e)
  {
    for (std::size_t k = 1; k + 1 < curved.edges[e].size(); ++k)
    {
      Mixture& mixture = mixtures[static_cast<std::size_t>(curved.edges[e][k]) - old];
      mixture.onBoundary = true;
      mixture.points = { quads.straight.edges[e].points[0], quads.straight.edges[e].points[1] };
      const double part = static_cast<double>(k) / p;
      mixture.weights = { 1.0 - part, part };
    }
  }
  return mixtures;
}

void WritePointData(
  const std::vector<Mixture>& mixtures, vtkPointData* from, vtkIdType old, vtkPointData* to)
{
  for (int a = 0; a < from->GetNumberOfArrays(); ++a)
  {
    vtkDataArray* source = from->GetArray(a);
    if (source == nullptr)
    {
      continue; // texts of points
    }
    const std::string name = source->GetName() ? source->GetName() : "";
    const bool isReal = source->GetDataType() == VTK_DOUBLE || source->GetDataType() == VTK_FLOAT;
    vtkSmartPointer<vtkDataArray> array;
    array.TakeReference(source->NewInstance());
    array->SetName(source->GetName());
    array->SetNumberOfComponents(source->GetNumberOfComponents());
    array->SetNumberOfTuples(old + static_cast<vtkIdType>(mixtures.size()));
    array->InsertTuples(0, old, 0, source);
    for (std::size_t m = 0; m < mixtures.size(); ++m)
    {
      const Mixture& mixture = mixtures[m];
      const vtkIdType tuple = old + static_cast<vtkIdType>(m);
      for (int c = 0; c < source->GetNumberOfComponents(); ++c)
      {
        double value = 0.0;
        for (std::size_t i = 0; isReal && i < mixture.points.size(); ++i)
        {
          value += mixture.weights[i] * source->GetComponent(mixture.points[i], c);
        }
        value = name == names::Valence ? mixture.quads : value;
        value = name == names::BoundarySide
          ? (mixture.onBoundary ? source->GetComponent(mixture.points[0], c) : -1.0)
          : value;
        array->SetComponent(tuple, c, value);
      }
    }
    to->AddArray(array);
  }
}
}

namespace HigherOrderConversion
{
//------------------------------------------------------------------------------
std::vector<std::size_t> LatticeOrder(int order)
{
  const auto at = [order](int i, int j) { return static_cast<std::size_t>(j * (order + 1) + i); };
  const int p = order;
  std::vector<std::size_t> positions = { at(0, 0), at(p, 0), at(p, p), at(0, p) };
  const auto addEdge = [&](const auto& node)
  {
    for (int k = 1; k < p; ++k)
    {
      positions.push_back(node(k));
    }
  };
  addEdge([&](int k) { return at(k, 0); });
  addEdge([&](int k) { return at(p, k); });
  addEdge([&](int k) { return at(k, p); });
  addEdge([&](int k) { return at(0, k); });
  for (int j = 1; j < p; ++j)
  {
    for (int i = 1; i < p; ++i)
    {
      positions.push_back(at(i, j));
    }
  }
  return positions;
}

//------------------------------------------------------------------------------
void Join(vtkUnstructuredGrid* quads, vtkPolyData* boundary, vtkUnstructuredGrid* mesh)
{
  InputCheck::Require(quads);
  if (boundary == nullptr || boundary->GetNumberOfCells() == 0)
  {
    mesh->ShallowCopy(quads);
    return;
  }
  InputCheck::Require(boundary);
  RequireBoundaryOf(quads, boundary);
  QuadConversion::Combine(quads, boundary, mesh);
  SegmentCurveConversion::CopyCurves(boundary, mesh);
  PeriodicConversion::Copy(boundary->GetFieldData(), mesh->GetFieldData());
}

//------------------------------------------------------------------------------
Quads ReadQuads(vtkUnstructuredGrid* mesh)
{
  Quads result;
  result.plane = DomainConversion::FindPlane(mesh);
  CurveConversion::CellCurves curves = CurveConversion::ReadCurves(mesh);
  for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
  {
    result.straight.points.push_back(result.plane.ToPlane(Eigen::Vector3d(mesh->GetPoint(i))));
  }
  auto* sides = vtkStringArray::SafeDownCast(mesh->GetCellData()->GetAbstractArray(names::Side));
  std::vector<std::string> sideNames;
  vtkNew<vtkIdList> ids;
  for (vtkIdType cell = 0; cell < mesh->GetNumberOfCells(); ++cell)
  {
    const int type = mesh->GetCellType(cell);
    mesh->GetCellPoints(cell, ids);
    const auto id = [&](vtkIdType i) { return static_cast<int>(ids->GetId(i)); };
    if (type == VTK_QUAD)
    {
      result.straight.quads.push_back({ id(0), id(1), id(2), id(3) });
      result.quadCells.push_back(cell);
    }
    else if (type == VTK_LINE)
    {
      const int curve = curves.ofCell.empty() ? -1 : curves.ofCell[static_cast<std::size_t>(cell)];
      const int side = sides == nullptr ? -1 : NumberOf(sides->GetValue(cell), sideNames);
      result.straight.edges.push_back({ { id(0), id(1) }, curve, side });
      result.edgeCells.push_back(cell);
    }
    else
    {
      throw Error("The mesh has cells that are neither quads nor lines; give the quads of a Quad "
                  "Mesher.");
    }
  }
  if (result.straight.quads.empty())
  {
    throw Error("The mesh has no quads; give the quads of a Quad Mesher.");
  }
  if (result.straight.edges.empty())
  {
    throw Error(
      "The quads have no boundary edges, which have the curves; put this filter directly behind "
      "Quad Mesher, before filters that change points or cells.");
  }
  result.straight.curves = std::move(curves.curves);
  result.straight.periodic =
    PeriodicConversion::ReadInPlane(mesh->GetFieldData(), sideNames, result.plane);
  return result;
}

//------------------------------------------------------------------------------
void WriteQuads(const Quads& quads, const CurvedQuads& curved, vtkUnstructuredGrid* mesh,
  vtkUnstructuredGrid* output)
{
  const auto old = static_cast<vtkIdType>(quads.straight.points.size());
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (std::size_t i = 0; i < curved.points.size(); ++i)
  {
    if (static_cast<vtkIdType>(i) < old)
    {
      points->InsertNextPoint(
        mesh->GetPoint(static_cast<vtkIdType>(i))); // the same to the last bit
      continue;
    }
    points->InsertNextPoint(quads.plane.ToSpace(curved.points[i]).data());
  }
  output->SetPoints(points);
  const bool isSecond = curved.order == 2;
  const std::vector<std::size_t> order = LatticeOrder(curved.order);
  std::vector<vtkIdType> ids;
  std::size_t quad = 0;
  std::size_t edge = 0;
  output->Allocate(mesh->GetNumberOfCells());
  for (vtkIdType cell = 0; cell < mesh->GetNumberOfCells(); ++cell)
  {
    ids.clear();
    if (quad < quads.quadCells.size() && quads.quadCells[quad] == cell)
    {
      for (const std::size_t position : order)
      {
        ids.push_back(curved.quads[quad][position]);
      }
      // With one node inside each edge, VTK's orders of both types are the same.
      output->InsertNextCell(isSecond ? VTK_BIQUADRATIC_QUAD : VTK_LAGRANGE_QUADRILATERAL,
        static_cast<vtkIdType>(ids.size()), ids.data());
      ++quad;
      continue;
    }
    const std::vector<int>& nodes = curved.edges[edge++];
    ids = { nodes.front(), nodes.back() };
    ids.insert(ids.end(), nodes.begin() + 1, nodes.end() - 1);
    output->InsertNextCell(isSecond ? VTK_QUADRATIC_EDGE : VTK_LAGRANGE_CURVE,
      static_cast<vtkIdType>(ids.size()), ids.data());
  }
  output->GetCellData()->PassData(mesh->GetCellData());
  WritePointData(MixturesOf(quads, curved), mesh->GetPointData(), old, output->GetPointData());
  auto ratios = ColumnWriting::NewArray<vtkDoubleArray>(
    output->GetCellData(), names::JacobianRatio, 1, mesh->GetNumberOfCells(), 1.0);
  for (std::size_t q = 0; q < quads.quadCells.size(); ++q)
  {
    ratios->SetValue(quads.quadCells[q], curved.jacobianRatios[q]);
  }
  vtkFieldData* report = output->GetFieldData();
  report->ShallowCopy(mesh->GetFieldData());
  ColumnWriting::AddIntegers(report, names::Order, { curved.order });
  ColumnWriting::AddNumbers(report, names::JacobianRatioMin, { curved.jacobianRatio });
  ColumnWriting::AddIntegers(report, names::CurvedInverted, { curved.inverted });
  ColumnWriting::AddIntegers(report, names::CurvedRows, { curved.curvedRows });
  if (!curved.sagittas.empty())
  {
    ColumnWriting::AddNumbers(report, names::CurveSagitta, curved.sagittas);
  }
}

//------------------------------------------------------------------------------
std::string DescribeInverted(const CurvedQuads& curved)
{
  return std::to_string(curved.inverted) + " of the curved quads " +
    (curved.inverted == 1 ? "is" : "are") + " inverted, the worst one near " +
    crossfield::Describe(curved.worst) + "; use smaller quads there.";
}
}
