#include <vtkDrillHoles.h>
#include <vtkNew.h>
#include <vtkPerforatedCrossField.h>
#include <vtkPlanarDomainSource.h>
#include <vtkSingularitySource.h>
#include <vtkUnstructuredGrid.h>

#include <iostream>

int main()
{
  vtkNew<vtkPlanarDomainSource> domain;
  vtkNew<vtkSingularitySource> singularities;
  vtkNew<vtkDrillHoles> drill;
  drill->SetInputConnection(domain->GetOutputPort());
  drill->SetSingularitiesConnection(singularities->GetOutputPort());
  vtkNew<vtkPerforatedCrossField> solver;
  solver->SetInputConnection(drill->GetOutputPort());
  solver->Update();
  std::cout << solver->GetOutput()->GetNumberOfCells() << " cells\n";
  return solver->GetErrorCode() == 0 && solver->GetOutput()->GetNumberOfCells() > 0 ? 0 : 1;
}
