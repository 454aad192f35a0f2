#include "SingularityRecord.h"

#include "QuarterIndexRange.h"

#include "vtkDataArray.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkNew.h"

#include <string>

namespace SingularityRecord
{
//------------------------------------------------------------------------------
void Write(const char* name, const crossfield::Configuration& configuration,
  const crossfield::DomainPlane& plane, vtkFieldData* data)
{
  vtkNew<vtkDoubleArray> points;
  points->SetName(name);
  points->SetNumberOfComponents(4);
  for (const crossfield::Singularity& singularity : configuration)
  {
    const Eigen::Vector3d place = plane.ToSpace(singularity.position);
    points->InsertNextTuple4(place.x(), place.y(), place.z(), singularity.quarterIndex);
  }
  data->AddArray(points);
}

//------------------------------------------------------------------------------
crossfield::Configuration Read(
  const char* name, const crossfield::DomainPlane& plane, vtkFieldData* data)
{
  crossfield::Configuration configuration;
  vtkDataArray* points = data->GetArray(name);
  if (points == nullptr || points->GetNumberOfComponents() != 4)
  {
    return configuration;
  }
  const std::string what = std::string("A quarter index of the field data '") + name + "'";
  for (vtkIdType i = 0; i < points->GetNumberOfTuples(); ++i)
  {
    const Eigen::Vector3d place(
      points->GetComponent(i, 0), points->GetComponent(i, 1), points->GetComponent(i, 2));
    configuration.push_back({ plane.ToPlane(place),
      crossfield::RequireQuarterIndex(points->GetComponent(i, 3), what), 0.0 });
  }
  return configuration;
}
}
