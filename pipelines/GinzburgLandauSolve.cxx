/**
 * crossfield solve DOMAIN --method ginzburg-landau -o F.vtu: the reference to compare with, which
 * places singularities by itself.
 *
 *   crossfield solve builtin:ring --method ginzburg-landau --epsilon 0.01 --start constant \
 *     --size 0.04 -o field.vtu
 */
#include "GinzburgLandauSolve.h"

#include "DomainReader.h"
#include "OutputFile.h"
#include "OutputTransaction.h"
#include "PipelineRun.h"
#include "ReportJson.h"
#include "vtkCrossFieldArrayNames.h"
#include "vtkCrossFieldSingularities.h"
#include "vtkDrillHoles.h"
#include "vtkGinzburgLandauCrossField.h"
#include "vtkSingularitySource.h"

#include "vtkAlgorithm.h"
#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkTimerLog.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <iostream>
#include <map>

namespace
{
namespace names = vtkCrossFieldArrayNames;

void PrintSummary(vtkUnstructuredGrid* field, vtkPolyData* singularities)
{
  std::cout << "energy " << FieldValue(field, names::Energy) << " (gradient "
            << FieldValue(field, names::GradientEnergy) << ", penalty "
            << FieldValue(field, names::PenaltyEnergy) << ", epsilon "
            << FieldValue(field, names::Epsilon) << "), "
            << (FieldValue(field, names::Converged) != 0.0 ? "converged" : "NOT converged")
            << " after " << FieldValue(field, names::Iterations) << " iterations (residual "
            << FieldValue(field, names::Residual) << "), unwanted singularities "
            << FieldValue(field, names::UnwantedSingularities) << "\n";
  PrintSingularities(singularities, field);
}
}

void PrintSingularities(vtkPolyData* singularities, vtkUnstructuredGrid* field)
{
  for (vtkIdType i = 0; i < singularities->GetNumberOfPoints(); ++i)
  {
    const double* place = singularities->GetPoint(i);
    std::cout << "quarter index "
              << singularities->GetPointData()->GetArray(names::QuarterIndex)->GetComponent(i, 0)
              << " at " << place[0] << " " << place[1];
    if (DomainReader::HasHeight(field))
    {
      std::cout << " " << place[2];
    }
    std::cout << "\n";
  }
}

const std::vector<std::string> GinzburgLandauSolve::Starts = { "harmonic", "constant", "zero" };

int GinzburgLandauSolve::Run() const
{
  // 1. Read the domain. A configuration is read as well, so that a wrong name does not go
  //    unnoticed, but nothing is made of it: this method has its own.
  const auto domainReader = DomainReader::Open(this->domain, this->size);
  vtkNew<vtkSingularitySource> none;
  none->RemoveAllSingularities();
  if (!this->singularities.empty())
  {
    PipelineRun::Update(DomainReader::OpenPoints(this->singularities), "reading");
  }

  // 2. Triangulate, without holes.
  vtkNew<vtkTimerLog> timer;
  timer->StartTimer();
  vtkNew<vtkDrillHoles> drill;
  drill->SetInputConnection(domainReader->GetOutputPort());
  drill->SetSingularitiesConnection(none->GetOutputPort());
  drill->SetMeshSize(this->size);
  PipelineRun::Update(drill, "meshing");
  timer->StopTimer();
  std::map<std::string, double> seconds;
  seconds["mesh"] = timer->GetElapsedTime();

  // 3. Minimise, and look for the singularities.
  vtkNew<vtkGinzburgLandauCrossField> solver;
  solver->SetInputConnection(drill->GetOutputPort());
  solver->SetEpsilon(this->epsilon);
  solver->SetStart(
    static_cast<int>(std::find(Starts.begin(), Starts.end(), this->start) - Starts.begin()));
  PipelineRun::Update(solver, "solving");
  vtkUnstructuredGrid* field = solver->GetOutput();
  seconds["assemble"] = solver->GetStageSeconds()[0];
  seconds["factor"] = solver->GetStageSeconds()[1];
  seconds["solve"] = solver->GetStageSeconds()[2];
  vtkNew<vtkCrossFieldSingularities> found;
  found->SetInputConnection(solver->GetOutputPort());
  PipelineRun::Update(found, "reading singularities");

  // 4. Write the field and the report.
  OutputTransaction outputs;
  seconds["write"] = OutputFile::WriteIfNamed(field, this->output, outputs);
  if (this->json.empty())
  {
    PrintSummary(field, found->GetOutput());
  }
  else
  {
    outputs.Write(ReportJson::Write(field, seconds, found->GetOutput()), this->json);
  }
  outputs.Commit();

  // 5. The answer.
  const bool unwanted = FieldValue(field, names::UnwantedSingularities) != 0.0;
  return FieldValue(field, names::Converged) == 0.0 || (this->strict && unwanted) ? AnswerIsNo
                                                                                  : Done;
}
