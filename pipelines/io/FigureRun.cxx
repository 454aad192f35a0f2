#include "FigureRun.h"

#include "MethodRun.h"
#include "OutputFile.h"
#include "PaperFigures.h"
#include "PipelineRun.h"
#include "SingularityInput.h"
#include "vtkConfigurationProposal.h"
#include "vtkCrossFieldArrayNames.h"
#include "vtkCrossFieldSingularities.h"
#include "vtkHField.h"
#include "vtkPlanarDomainSource.h"
#include "vtkSingularitySource.h"

#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkUnstructuredGrid.h"

#include <functional>
#include <map>
#include <sstream>

namespace
{
namespace names = vtkCrossFieldArrayNames;

/** Returns the singularities of a field, including those on holes, as "4 x +1, 1 x -1". */
std::string FoundSingularities(vtkUnstructuredGrid* field)
{
  vtkNew<vtkCrossFieldSingularities> reader;
  reader->SetInputData(field);
  reader->IncludeHolesOn();
  PipelineRun::Update(reader, "reading singularities");
  vtkDataArray* quarters = reader->GetOutput()->GetPointData()->GetArray(names::QuarterIndex);
  std::map<int, int, std::greater<>> counts;
  for (vtkIdType i = 0; i < quarters->GetNumberOfTuples(); ++i)
  {
    ++counts[static_cast<int>(quarters->GetTuple1(i))];
  }
  std::ostringstream text;
  for (const auto& [quarter, count] : counts)
  {
    text << (text.tellp() > 0 ? ", " : "") << count << " x " << std::showpos << quarter
         << std::noshowpos;
  }
  return counts.empty() ? "none" : text.str();
}

/** Sets the domain of a figure. */
void SetDomain(const PaperFigure& figure, vtkPlanarDomainSource* domain)
{
  domain->SetDomainName(figure.domain);
  domain->SetEdgeLength(figure.size);
  if (figure.domain == "ring")
  {
    domain->SetInnerRadius(figure.innerRadius);
  }
  if (figure.domain == "ellipse") // semi-axes 3 and 0.6
  {
    domain->SetWidth(6.0);
    domain->SetHeight(1.2);
  }
  if (figure.domain == "l-shape")
  {
    domain->SetWidth(1.0);
  }
}
}

FigureResult ComputeFigure(
  const PaperFigure& figure, const std::string& folder, OutputTransaction& outputs)
{
  vtkNew<vtkPlanarDomainSource> domain;
  SetDomain(figure, domain);
  vtkNew<vtkSingularitySource> rows;
  rows->RemoveAllSingularities();
  for (const auto& [x, y, quarter, radius] : figure.singularities)
  {
    rows->AddSingularity(x, y, quarter, radius > 0.0 ? radius : figure.size);
  }
  vtkNew<vtkConfigurationProposal> proposal;
  proposal->SetInputConnection(domain->GetOutputPort());
  vtkAlgorithm* singularities = rows;
  if (figure.propose)
  {
    singularities = proposal;
  }
  PipelineRun::Update(domain, figure.name.c_str());
  PipelineRun::Update(singularities, figure.name.c_str());

  MethodRun run;
  vtkNew<vtkHField> h;
  vtkUnstructuredGrid* field = nullptr;
  if (figure.method == "h")
  {
    h->SetInputConnection(domain->GetOutputPort());
    h->SetSingularitiesConnection(singularities->GetOutputPort());
    h->SetMeshSize(figure.size);
    PipelineRun::Update(h, figure.name.c_str());
    field = h->GetOutput();
  }
  else
  {
    run.Solve(figure.method, figure.size, figure.epsilon, domain, SingularityInput(singularities));
    field = run.GetField();
  }
  OutputFile::Write(field, folder + "/" + figure.name + ".vtu", outputs);

  const auto value = [field](const char* name)
  {
    vtkDataArray* array = field->GetFieldData()->GetArray(name);
    return array != nullptr ? array->GetComponent(0, 0) : 0.0;
  };
  return { value(names::Energy), static_cast<int>(value(names::Iterations)),
    value(names::Converged) != 0.0, static_cast<int>(value(names::UnwantedSingularities)),
    FoundSingularities(field) };
}
