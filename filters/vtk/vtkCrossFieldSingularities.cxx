#include "vtkCrossFieldSingularities.h"

#include "ColumnWriting.h"
#include "ConfigurationConversion.h"
#include "CrossFieldArrays.h"
#include "DrilledMeshConversion.h"
#include "FieldSingularities.h"
#include "FilterPorts.h"
#include "FilterRun.h"
#include "SurfaceConversion.h"
#include "SurfaceIndices.h"
#include "vtkCrossFieldArrayNames.h"

#include "vtkCellArray.h"
#include "vtkInformationVector.h"
#include "vtkIntArray.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkUnstructuredGrid.h"

vtkStandardNewMacro(vtkCrossFieldSingularities);

namespace
{
void WriteSingularities(const std::vector<crossfield::FieldSingularity>& singularities,
  const crossfield::DomainPlane& plane, vtkPolyData* output)
{
  vtkNew<vtkIntArray> kinds;
  kinds->SetName(vtkCrossFieldArrayNames::BoundaryKind);
  vtkNew<vtkIntArray> ids;
  ids->SetName(vtkCrossFieldArrayNames::BoundaryId);
  crossfield::Configuration configuration;
  for (const crossfield::FieldSingularity& singularity : singularities)
  {
    configuration.push_back(singularity);
    kinds->InsertNextValue(static_cast<int>(singularity.place));
    ids->InsertNextValue(singularity.id);
  }
  ConfigurationConversion::WriteConfiguration(configuration, plane, output);
  output->GetPointData()->AddArray(kinds);
  output->GetPointData()->AddArray(ids);
}

/** Writes the singularities of the crosses on the triangles of a surface in space. */
void WriteThoseOfSurface(vtkUnstructuredGrid* input, bool includesCorners, vtkPolyData* output)
{
  const SurfaceConversion::Crosses crosses = SurfaceConversion::ReadCrosses(input);
  const crossfield::MeshTopology& topology = *crosses.topology;
  std::vector<int> quarters = crossfield::ReadSurfaceIndices(topology, crosses.angle);
  crossfield::JoinNeighbours(topology, quarters);
  std::vector<int> kind(quarters.size(), 0);
  std::vector<int> loop(quarters.size(), -1);
  for (const crossfield::BoundaryEdge& edge : topology.mesh.boundary)
  {
    const auto vertex = static_cast<std::size_t>(edge.vertices[0]);
    kind[vertex] = static_cast<int>(edge.kind);
    loop[vertex] = edge.id;
    const bool isCorner = topology.corners[vertex];
    quarters[vertex] = isCorner && !includesCorners ? 0 : quarters[vertex];
  }
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> vertices;
  std::vector<int> columns[3];
  for (int wanted = 0; wanted < 3; ++wanted) // those inside first
  {
    for (std::size_t v = 0; v < quarters.size(); ++v)
    {
      if (quarters[v] != 0 && kind[v] == wanted)
      {
        const crossfield::SpacePoint place = topology.PositionOf(static_cast<int>(v));
        vertices->InsertNextCell({ points->InsertNextPoint(place.data()) });
        columns[0].push_back(quarters[v]);
        columns[1].push_back(kind[v]);
        columns[2].push_back(loop[v]);
      }
    }
  }
  output->SetPoints(points);
  output->SetVerts(vertices);
  namespace names = vtkCrossFieldArrayNames;
  ColumnWriting::AddIntegers(output->GetPointData(), names::QuarterIndex, columns[0]);
  ColumnWriting::AddIntegers(output->GetPointData(), names::BoundaryKind, columns[1]);
  ColumnWriting::AddIntegers(output->GetPointData(), names::BoundaryId, columns[2]);
}
}

//------------------------------------------------------------------------------
vtkCrossFieldSingularities::vtkCrossFieldSingularities() = default;

//------------------------------------------------------------------------------
int vtkCrossFieldSingularities::FillInputPortInformation(int, vtkInformation* info)
{
  return FilterPorts::AcceptMesh(info);
}

//------------------------------------------------------------------------------
int vtkCrossFieldSingularities::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkUnstructuredGrid* input = vtkUnstructuredGrid::GetData(inputVector[0]);
  return FilterRun::Run(this, this->ErrorCode, input,
    [&](const crossfield::Progress&)
    {
      if (SurfaceConversion::IsSurface(input))
      {
        WriteThoseOfSurface(input, this->IncludeCorners, vtkPolyData::GetData(outputVector));
        return;
      }
      const DrilledMeshConversion::DrilledMesh cells =
        DrilledMeshConversion::ReadDrilledMesh(input);
      crossfield::FieldSingularityOptions options;
      options.corners = this->IncludeCorners;
      options.holes = this->IncludeHoles;
      options.cornerAngle = vtkMath::RadiansFromDegrees(this->CornerAngle);
      const auto singularities =
        crossfield::FindFieldSingularities(CrossFieldArrays::ReadField(cells, input), options);
      vtkPolyData* output = vtkPolyData::GetData(outputVector);
      WriteSingularities(singularities, cells.plane, output);
      if (!this->IncludeHoles)
      {
        // Only holes have a radius; vtkDrillHoles refuses a radius of 0.
        output->GetPointData()->RemoveArray(vtkCrossFieldArrayNames::Radius);
      }
    });
}

//------------------------------------------------------------------------------
void vtkCrossFieldSingularities::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "IncludeCorners: " << (this->IncludeCorners ? "on" : "off") << "\n";
  os << indent << "IncludeHoles: " << (this->IncludeHoles ? "on" : "off") << "\n";
  os << indent << "CornerAngle: " << this->CornerAngle << "\n";
}
