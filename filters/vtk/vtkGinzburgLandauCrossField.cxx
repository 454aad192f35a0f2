#include "vtkGinzburgLandauCrossField.h"

#include "CrossFieldArrays.h"
#include "DrilledMeshConversion.h"
#include "FilterPorts.h"
#include "GinzburgLandau.h"

#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkUnstructuredGrid.h"

vtkStandardNewMacro(vtkGinzburgLandauCrossField);

static_assert(static_cast<int>(crossfield::GinzburgLandauStart::Given) ==
    vtkGinzburgLandauCrossField::StartGiven,
  "starts are numbered as in the numerics");

//------------------------------------------------------------------------------
vtkGinzburgLandauCrossField::vtkGinzburgLandauCrossField()
  : vtkCrossFieldSolver(500)
{
}

//------------------------------------------------------------------------------
int vtkGinzburgLandauCrossField::FillInputPortInformation(int, vtkInformation* info)
{
  return FilterPorts::AcceptMesh(info);
}

//------------------------------------------------------------------------------
void vtkGinzburgLandauCrossField::Compute(const DrilledMeshConversion::DrilledMesh& cells,
  vtkInformationVector** inputVector, const crossfield::Progress& progress,
  vtkInformationVector* outputVector)
{
  vtkUnstructuredGrid* input = vtkUnstructuredGrid::GetData(inputVector[0]);
  vtkUnstructuredGrid* output = vtkUnstructuredGrid::GetData(outputVector);
  crossfield::GinzburgLandauOptions options;
  options.epsilon = this->Epsilon;
  options.start = static_cast<crossfield::GinzburgLandauStart>(this->Start);
  if (this->Start == StartGiven)
  {
    options.given = CrossFieldArrays::ReadField(cells, input).u;
  }
  options.pinning.norm = CrossFieldArrays::ReadOnTriangles(cells, this->NormArrayName, input);
  options.pinning.gradientWeight =
    CrossFieldArrays::ReadOnTriangles(cells, this->GradientWeightArrayName, input);
  options.maximumIterations = this->GetMaximumIterations();
  options.tolerance = this->GetTolerance();
  const crossfield::GinzburgLandauField field =
    crossfield::SolveGinzburgLandau(cells.topology, options, progress);
  this->Publish(cells, field,
    "the field is not a minimum. Allow more iterations, or use a larger epsilon.", input, output);
  CrossFieldArrays::AddConvexifiedSteps(field.convexifiedSteps, output);
}

//------------------------------------------------------------------------------
void vtkGinzburgLandauCrossField::PrintSelf(ostream& os, vtkIndent indent)
{
  const char* const starts[] = { "Harmonic", "Constant", "Zero", "Given" };
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Epsilon: " << this->Epsilon << "\n";
  os << indent << "Start: " << starts[this->Start] << "\n";
  os << indent << "NormArrayName: " << this->NormArrayName << "\n";
  os << indent << "GradientWeightArrayName: " << this->GradientWeightArrayName << "\n";
}
