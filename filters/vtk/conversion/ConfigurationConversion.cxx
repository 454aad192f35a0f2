#include "ConfigurationConversion.h"

#include "ColumnWriting.h"
#include "Error.h"
#include "InputCheck.h"
#include "PlaneFrame.h"
#include "QuarterIndexRange.h"
#include "vtkCrossFieldArrayNames.h"

#include "vtkDataSet.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <string>

namespace ConfigurationConversion
{
using crossfield::Error;

//------------------------------------------------------------------------------
vtkDataArray* RequireQuarterIndices(vtkDataSet* input)
{
  // The array is required even without points: the output of a failed source has neither points nor
  // the array, and must not be mistaken for the empty configuration.
  InputCheck::Require(input);
  vtkDataArray* quarters = input->GetPointData()->GetArray(vtkCrossFieldArrayNames::QuarterIndex);
  if (quarters == nullptr || quarters->GetNumberOfComponents() != 1)
  {
    throw Error("The singularities have no point array 'QuarterIndex' with one component; add it "
                "(4 times the index of each point).");
  }
  return quarters;
}

//------------------------------------------------------------------------------
crossfield::Configuration ReadConfiguration(vtkDataSet* input, const crossfield::DomainPlane& plane)
{
  crossfield::Configuration configuration;
  if (input == nullptr)
  {
    return configuration;
  }
  vtkDataArray* quarters = RequireQuarterIndices(input);
  vtkDataArray* radii = input->GetPointData()->GetArray(vtkCrossFieldArrayNames::Radius);
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
  PlaneFrame(plane).Record(output->GetFieldData());
}
}
