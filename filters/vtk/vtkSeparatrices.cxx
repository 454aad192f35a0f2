#include "vtkSeparatrices.h"

#include "Error.h"
#include "FilterPorts.h"
#include "FilterRun.h"
#include "InputCheck.h"
#include "MapConversion.h"
#include "PatchConversion.h"
#include "Stopwatch.h"
#include "TMeshConversion.h"
#include "TMeshPatches.h"

#include "vtkDataSet.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"
#include "vtkUnstructuredGrid.h"

#include <cmath>
#include <string>

vtkStandardNewMacro(vtkSeparatrices);

namespace
{
std::vector<crossfield::Point> ReadSeeds(vtkDataSet* seeds, const crossfield::DomainPlane& plane)
{
  std::vector<crossfield::Point> places;
  if (seeds != nullptr)
  {
    InputCheck::Require(seeds);
    for (vtkIdType i = 0; i < seeds->GetNumberOfPoints(); ++i)
    {
      places.push_back(
        plane.RequireInPlane(Eigen::Vector3d(seeds->GetPoint(i)), "The seed " + std::to_string(i)));
    }
  }
  return places;
}
}

//------------------------------------------------------------------------------
vtkSeparatrices::vtkSeparatrices()
{
  this->SetNumberOfInputPorts(2);
  this->SetNumberOfOutputPorts(2);
}

//------------------------------------------------------------------------------
int vtkSeparatrices::FillInputPortInformation(int port, vtkInformation* info)
{
  return port == 0 ? FilterPorts::AcceptMesh(info) : FilterPorts::AcceptOptionalPoints(info);
}

//------------------------------------------------------------------------------
int vtkSeparatrices::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkUnstructuredGrid* input = vtkUnstructuredGrid::GetData(inputVector[0]);
  vtkDataSet* seeds = vtkDataSet::GetData(inputVector[1]);
  vtkPolyData* lines = vtkPolyData::GetData(outputVector, 0);
  vtkPolyData* patches = vtkPolyData::GetData(outputVector, 1);
  return FilterRun::Run(this, this->ErrorCode, input,
    [&](const crossfield::Progress& progress)
    {
      const MapConversion::Map map = MapConversion::ReadMap(input);
      if (seeds != nullptr && map.map.topology->charts)
      {
        throw crossfield::Error(
          "Streamlines from seeds are not supported on a surface in space yet; leave the seeds out.");
      }
      const std::vector<crossfield::Point> places = ReadSeeds(seeds, map.plane);
      const double longest = this->LongestStreamline > 0.0
        ? this->LongestStreamline
        : 10.0 * std::sqrt(map.map.topology->Area());
      crossfield::Stopwatch stopwatch;
      const crossfield::TraceGraph graph =
        crossfield::TraceSeparatrices(map.map, progress.Part(0.2, 0.8));
      const crossfield::TMesh mesh = crossfield::MakeTMesh(map.map, graph);
      this->StageSeconds = stopwatch.Lap();
      TMeshConversion::WriteTraces(map, graph, places, longest, lines);
      PatchConversion::WritePatches(map, mesh, patches);
      TMeshConversion::AddCounts(mesh, lines->GetFieldData());
      TMeshConversion::AddCounts(mesh, patches->GetFieldData());
    });
}

//------------------------------------------------------------------------------
void vtkSeparatrices::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "LongestStreamline: " << this->LongestStreamline << "\n";
  os << indent << "StageSeconds: " << this->StageSeconds << "\n";
}
