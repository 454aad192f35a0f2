#ifndef PlanesTest_h
#define PlanesTest_h

#include "FilterChecks.h"
#include "TestInputs.h"
#include "vtkDrillHoles.h"
#include "vtkPerforatedCrossField.h"

#include "vtkDataArray.h"
#include "vtkDataObject.h"
#include "vtkFieldData.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <array>
#include <cmath>

/** Domains in several planes of space, shared by the tests of planes. */
namespace PlanesTest
{
using Vector = std::array<double, 3>;
using Rotation = std::array<Vector, 3>; ///< Rows of the matrix.

/** Returns the shortest rotation that maps the z axis to the normal. */
inline Rotation Tilt(Vector normal)
{
  vtkMath::Normalize(normal.data());
  const auto [x, y, z] = normal;
  const double s = 1.0 / (1.0 + z);
  return { { { 1.0 - x * x * s, -x * y * s, x }, { -x * y * s, 1.0 - y * y * s, y },
    { -x, -y, z } } };
}

inline Vector Apply(const Rotation& rotation, const double* place)
{
  Vector result;
  for (int i = 0; i < 3; ++i)
  {
    result[i] = vtkMath::Dot(rotation[i].data(), place);
  }
  return result;
}

inline double Distance(const Vector& a, const double* b)
{
  return std::sqrt(vtkMath::Distance2BetweenPoints(a.data(), b));
}

/** Returns a rotated copy. */
inline vtkSmartPointer<vtkPolyData> Rotated(vtkPolyData* input, const Rotation& rotation)
{
  auto result = vtkSmartPointer<vtkPolyData>::New();
  result->DeepCopy(input);
  for (vtkIdType i = 0; i < input->GetNumberOfPoints(); ++i)
  {
    result->GetPoints()->SetPoint(i, Apply(rotation, input->GetPoint(i)).data());
  }
  return result;
}

inline double Value(vtkDataObject* data, const char* name)
{
  return FilterChecks::RequireArray(data->GetFieldData(), name)->GetTuple1(0);
}

/** Returns an L-shape with corners of 90 and 270 degrees. */
inline vtkSmartPointer<vtkPolyData> LShape()
{
  return TestInputs::Loops({ { { 0, 0 }, { 4, 0 }, { 4, 2 }, { 2, 2 }, { 2, 4 }, { 0, 4 } } });
}

/** Returns two singularities in the L-shape. */
inline vtkSmartPointer<vtkPolyData> Pair()
{
  return TestInputs::Singularities({ { 1, 3, 1, 0.25 }, { 3, 1, -1, 0.25 } });
}

/** Pipeline from a rotated domain to its field. */
struct Pipeline
{
  explicit Pipeline(const Rotation& rotation)
    : Domain(Rotated(LShape(), rotation))
    , Singularities(Rotated(Pair(), rotation))
  {
    this->Drill->SetInputData(this->Domain);
    this->Drill->SetSingularitiesData(this->Singularities);
    this->Drill->SetMeshSize(0.25);
    this->Solver->SetInputConnection(this->Drill->GetOutputPort());
  }

  vtkSmartPointer<vtkPolyData> Domain;
  vtkSmartPointer<vtkPolyData> Singularities;
  vtkNew<vtkDrillHoles> Drill;
  vtkNew<vtkPerforatedCrossField> Solver;
};

const Rotation Identity = { { { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 } } };
}

#endif
