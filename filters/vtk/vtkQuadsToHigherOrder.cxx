#include "vtkQuadsToHigherOrder.h"

#include "ColumnWriting.h"
#include "FilterPorts.h"
#include "FilterRun.h"
#include "NamedSurface.h"
#include "QuadBoundary.h"
#include "QuadsOnSurface.h"
#include "RaiseOrder.h"
#include "SolverMeshReading.h"
#include "SolverMeshWriting.h"
#include "SurfaceConversion.h"
#include "VertexPlacement.h"
#include "vtkCrossFieldArrayNames.h"

#include "vtkCellData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkUnstructuredGrid.h"

#include <array>
#include <optional>
#include <vector>

vtkStandardNewMacro(vtkQuadsToHigherOrder);

namespace names = vtkCrossFieldArrayNames;

namespace
{
/** Returns the corners of quads of order 1. */
std::vector<std::array<int, 4>> CornersOf(const crossfield::SolverMesh& quads)
{
  std::vector<std::array<int, 4>> corners;
  for (int cell = 0; cell < quads.CellCount(); ++cell)
  {
    const int* nodes = quads.Cell(cell);
    corners.push_back({ nodes[0], nodes[1], nodes[3], nodes[2] });
  }
  return corners;
}

using Lines = std::vector<std::array<crossfield::SpacePoint, 2>>;

crossfield::SpacePoint NearestOn(const Lines& lines, const crossfield::SpacePoint& place)
{
  crossfield::SpacePoint nearest = crossfield::SpacePoint::Constant(VTK_DOUBLE_MAX);
  for (const auto& [from, to] : lines)
  {
    const crossfield::SpacePoint here = crossfield::NearestOnSide(from, to, place);
    nearest = (here - place).squaredNorm() < (nearest - place).squaredNorm() ? here : nearest;
  }
  return nearest;
}

/** Returns a function that places nodes on a surface, whose lines are given. It refers to all arguments. */
crossfield::NodePlacement PlacementOn(const crossfield::QuadsOnSurface& located, const Lines& lines,
  const crossfield::SolverMesh& quads)
{
  return [&](const crossfield::SpacePoint& place, const std::array<int, 4>& corners, bool isOnLine)
  {
    constexpr double Rounding = 1e-6; // of an edge
    const crossfield::SpacePoint& end = quads.points[static_cast<std::size_t>(corners[0])];
    if (isOnLine && (NearestOn(lines, end) - end).norm() <= Rounding * (place - end).norm())
    {
      return NearestOn(lines, place);
    }
    // A corner on a sharp edge may be known in a triangle of the other face, from which no walk leads here.
    crossfield::SpacePoint nearest = crossfield::SpacePoint::Constant(VTK_DOUBLE_MAX);
    for (const int corner : corners)
    {
      const crossfield::SpacePoint here = located.NearestTo(place, corner);
      nearest = (here - place).squaredNorm() < (nearest - place).squaredNorm() ? here : nearest;
    }
    return nearest;
  };
}

void WriteQuality(const crossfield::SolverMesh& mesh, const crossfield::OrderQuality& quality,
  vtkUnstructuredGrid* output)
{
  auto ratios = ColumnWriting::NewArray<vtkDoubleArray>(
    output->GetCellData(), names::JacobianRatio, 1, output->GetNumberOfCells(), 1.0);
  for (std::size_t quad = 0; quad < quality.jacobianRatios.size(); ++quad)
  {
    ratios->SetValue(mesh.sources.cells[quad], quality.jacobianRatios[quad]);
  }
  vtkFieldData* report = output->GetFieldData();
  ColumnWriting::AddIntegers(report, names::Order, { mesh.order });
  ColumnWriting::AddNumbers(report, names::JacobianRatioMin, { quality.jacobianRatio });
  ColumnWriting::AddIntegers(report, names::CurvedInverted, { quality.inverted });
  ColumnWriting::AddIntegers(report, names::CurvedRows, { quality.curvedRows });
  if (!quality.sagittas.empty())
  {
    ColumnWriting::AddNumbers(report, names::CurveSagitta, quality.sagittas);
  }
}
}

//------------------------------------------------------------------------------
vtkQuadsToHigherOrder::vtkQuadsToHigherOrder()
{
  this->SetNumberOfInputPorts(3);
}

//------------------------------------------------------------------------------
int vtkQuadsToHigherOrder::FillInputPortInformation(int port, vtkInformation* info)
{
  return port == 0 ? FilterPorts::AcceptMesh(info)
    : port == 1    ? FilterPorts::AcceptOptionalBoundary(info)
                   : FilterPorts::AcceptOptionalDomain(info);
}

//------------------------------------------------------------------------------
int vtkQuadsToHigherOrder::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkUnstructuredGrid* input = vtkUnstructuredGrid::GetData(inputVector[0]);
  return FilterRun::Run(this, this->ErrorCode, input,
    [&](const crossfield::Progress& progress)
    {
      vtkNew<vtkUnstructuredGrid> grid;
      SolverMeshReading::Join(input, QuadBoundary::Find(this), grid);
      progress.Report(0.1);
      crossfield::SolverMesh quads = SolverMeshReading::Read(grid);
      SolverMeshReading::ReadCurves(grid, quads);
      vtkUnstructuredGrid* output = vtkUnstructuredGrid::GetData(outputVector);
      if (this->Order == 1)
      {
        output->ShallowCopy(grid);
        return;
      }
      vtkDataSet* surface = vtkDataSet::GetData(inputVector[2]);
      std::optional<crossfield::QuadsOnSurface> located;
      Lines lines;
      crossfield::NodePlacement placement;
      if (surface != nullptr && SurfaceConversion::IsSurface(surface))
      {
        located.emplace(NamedSurface::Read(surface).mesh, quads.points, CornersOf(quads));
        lines = located->FindLines(vtkMath::RadiansFromDegrees(this->FeatureAngle));
        placement = PlacementOn(*located, lines, quads);
      }
      crossfield::OrderQuality quality;
      const crossfield::SolverMesh raised =
        crossfield::RaiseOrder(quads, this->Order, quality, progress.Part(0.1, 0.9), placement);
      if (quality.inverted > 0)
      {
        vtkWarningMacro(<< quality.inverted << " of the curved quads "
                        << (quality.inverted == 1 ? "is" : "are")
                        << " inverted, the worst one near "
                        << crossfield::DescribePlace(quality.worst)
                        << "; use smaller quads there.");
      }
      SolverMeshWriting::WriteMesh(raised, grid, output);
      WriteQuality(raised, quality, output);
    });
}

//------------------------------------------------------------------------------
void vtkQuadsToHigherOrder::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Order: " << this->Order << "\n";
  os << indent << "FeatureAngle: " << this->FeatureAngle << "\n";
}
