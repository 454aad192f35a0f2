#include "MethodRun.h"

#include "PipelineRun.h"
#include "SingularityInput.h"
#include "vtkCrossFieldSingularities.h"
#include "vtkDrillHoles.h"
#include "vtkGinzburgLandauCrossField.h"
#include "vtkPerforatedCrossField.h"
#include "vtkSingularitySource.h"

#include "vtkPolyData.h"
#include "vtkTimerLog.h"
#include "vtkUnstructuredGrid.h"

namespace
{
bool Contains(const std::string& text, const std::string& part)
{
  return text.find(part) != std::string::npos;
}
}

const std::vector<std::string>& MethodRun::AllMethods()
{
  static const std::vector<std::string> all = { "constrained", "unit-norm", "unit-holes",
    "global-constraint", "imprint", "imprint-unit", "triangle", "triangle-penalty", "penalty",
    "ginzburg-landau", "ginzburg-landau-constant" };
  return all;
}

bool MethodRun::IsReference(const std::string& method)
{
  return Contains(method, "ginzburg-landau");
}

MethodRun::MethodRun() = default;
MethodRun::~MethodRun() = default;

CompareRow MethodRun::Solve(const std::string& method, double size, double epsilon,
  vtkAlgorithm* domain, const SingularityInput& singularities)
{
  const bool isReference = IsReference(method);
  vtkNew<vtkTimerLog> timer;
  timer->StartTimer();
  this->None->RemoveAllSingularities();
  this->Drill->SetInputConnection(domain->GetOutputPort());
  this->Drill->SetSingularitiesConnection(
    isReference ? this->None->GetOutputPort() : singularities.GetOutputPort());
  this->Drill->SetMeshSize(size);
  this->Drill->SetMode(Contains(method, "imprint") ? vtkDrillHoles::ModeImprint
      : Contains(method, "triangle")               ? vtkDrillHoles::ModeTriangle
                                                   : vtkDrillHoles::ModePerforate);
  vtkCrossFieldSolver* solver = this->Constrained;
  if (isReference)
  {
    this->Reference->SetStart(Contains(method, "constant")
        ? vtkGinzburgLandauCrossField::StartConstant
        : vtkGinzburgLandauCrossField::StartHarmonic);
    this->Reference->SetEpsilon(epsilon);
    solver = this->Reference;
  }
  else
  {
    singularities.ConnectCorners(this->Constrained.Get());
    this->Constrained->SetMethod(method == "unit-norm"
        ? vtkPerforatedCrossField::MethodUnitNorm
        : vtkPerforatedCrossField::MethodConstrained);
    this->Constrained->SetUnitHoles(method == "unit-holes" || method == "imprint-unit");
    this->Constrained->SetGlobalConstraint(method == "global-constraint");
    this->Constrained->SetEpsilon(Contains(method, "penalty") ? epsilon : 0.0);
  }
  solver->SetInputConnection(this->Drill->GetOutputPort());
  this->Found->SetInputConnection(solver->GetOutputPort());
  PipelineRun::Update(solver, method.c_str());
  timer->StopTimer();
  PipelineRun::Update(this->Found, method.c_str());
  CompareRow row = CompareTable::Read(method, solver->GetOutput(), this->Found->GetOutput());
  row.seconds = timer->GetElapsedTime();
  this->Field = solver->GetOutput();
  return row;
}
