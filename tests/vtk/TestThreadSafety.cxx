/**
 * Pipelines in several threads at once: each must produce the same bytes as alone. As VTK requires,
 * threads share neither filters nor data sets.
 */
#include "vtkDrillHoles.h"
#include "vtkGinzburgLandauCrossField.h"
#include "vtkHField.h"
#include "vtkPerforatedCrossField.h"
#include "vtkPlanarDomainSource.h"
#include "vtkSingularityEnergy.h"
#include "vtkSingularitySource.h"

#include "vtkCallbackCommand.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkCommand.h"
#include "vtkDataArray.h"
#include "vtkExecutive.h"
#include "vtkFieldData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkTable.h"
#include "vtkUnstructuredGrid.h"

#include <gtest/gtest.h>

#include <atomic>
#include <cstdlib>
#include <functional>
#include <string>
#include <thread>
#include <vector>

namespace
{
void AppendBytes(vtkDataArray* array, std::string& bytes)
{
  if (array != nullptr)
  {
    bytes.append(static_cast<const char*>(array->GetVoidPointer(0)),
      static_cast<std::size_t>(array->GetNumberOfValues() * array->GetDataTypeSize()));
  }
}

/** Appends the bytes of all arrays except those of times. */
void AppendArrays(vtkFieldData* data, std::string& bytes)
{
  for (int i = 0; i < data->GetNumberOfArrays(); ++i)
  {
    const std::string name = data->GetAbstractArray(i)->GetName();
    if (name.find("Seconds") == std::string::npos)
    {
      bytes += name;
      AppendBytes(data->GetArray(i), bytes);
    }
  }
}

std::string Bytes(vtkUnstructuredGrid* field)
{
  std::string bytes;
  AppendBytes(field->GetPoints()->GetData(), bytes);
  AppendBytes(field->GetCells()->GetConnectivityArray(), bytes);
  AppendArrays(field->GetPointData(), bytes);
  AppendArrays(field->GetCellData(), bytes);
  AppendArrays(field->GetFieldData(), bytes);
  return bytes;
}

/** Domain and singularities of a pipeline: four on a disk or pairs in a ring. */
struct Inputs
{
  vtkNew<vtkPlanarDomainSource> domain;
  vtkNew<vtkSingularitySource> singularities;

  explicit Inputs(bool ring)
  {
    if (ring)
    {
      this->domain->SetDomainName("ring");
      this->singularities->RemoveAllSingularities();
      this->singularities->AddSingularity(0.7, 0.0, 1, 0.05);
      this->singularities->AddSingularity(-0.7, 0.0, -1, 0.05);
    }
  }
};

std::string Perforated(bool ring, int method)
{
  Inputs inputs(ring);
  vtkNew<vtkDrillHoles> drill;
  drill->SetInputConnection(inputs.domain->GetOutputPort());
  drill->SetSingularitiesConnection(inputs.singularities->GetOutputPort());
  vtkNew<vtkPerforatedCrossField> solver;
  solver->SetInputConnection(drill->GetOutputPort());
  solver->SetMethod(method);
  solver->Update();
  return solver->GetErrorCode() == 0 ? Bytes(solver->GetOutput()) : "";
}

std::string H()
{
  Inputs inputs(false);
  vtkNew<vtkHField> solver;
  solver->SetInputConnection(inputs.domain->GetOutputPort());
  solver->SetSingularitiesConnection(inputs.singularities->GetOutputPort());
  solver->Update();
  return solver->GetErrorCode() == 0 ? Bytes(solver->GetOutput()) : "";
}

std::string Energy()
{
  Inputs inputs(false);
  vtkNew<vtkSingularityEnergy> energy;
  energy->SetInputConnection(inputs.domain->GetOutputPort());
  energy->AddConfigurationConnection(inputs.singularities->GetOutputPort());
  energy->Update();
  std::string bytes;
  AppendArrays(energy->GetOutput()->GetRowData(), bytes);
  return energy->GetErrorCode() == 0 ? bytes : "";
}

std::string GinzburgLandau()
{
  Inputs inputs(false);
  inputs.singularities->RemoveAllSingularities();
  vtkNew<vtkDrillHoles> drill;
  drill->SetInputConnection(inputs.domain->GetOutputPort());
  drill->SetSingularitiesConnection(inputs.singularities->GetOutputPort());
  drill->SetMeshSize(0.2);
  vtkNew<vtkGinzburgLandauCrossField> solver;
  solver->SetInputConnection(drill->GetOutputPort());
  solver->Update();
  return solver->GetErrorCode() == 0 ? Bytes(solver->GetOutput()) : "";
}

/** Returns the message of a failing pipeline with overlapping holes. */
std::string Failure()
{
  Inputs inputs(false);
  inputs.singularities->AddSingularity(0.42, 0.42, 1, 0.3);
  vtkNew<vtkDrillHoles> drill;
  drill->SetInputConnection(inputs.domain->GetOutputPort());
  drill->SetSingularitiesConnection(inputs.singularities->GetOutputPort());
  // An observer receives the message; otherwise VTK prints it from all threads to one window.
  std::string message;
  const auto storeMessage = [](vtkObject*, unsigned long, void* to, void* text)
  { *static_cast<std::string*>(to) += static_cast<const char*>(text); };
  vtkNew<vtkCallbackCommand> observer;
  observer->SetCallback(storeMessage);
  observer->SetClientData(&message);
  drill->AddObserver(vtkCommand::ErrorEvent, observer);
  drill->GetExecutive()->AddObserver(vtkCommand::ErrorEvent, observer);
  drill->Update();
  const auto sentence = message.find("Two holes overlap");
  return drill->GetErrorCode() == 0 || sentence == std::string::npos
    ? ""
    : message.substr(sentence, message.find('\n', sentence) - sentence);
}

using Pipeline = std::function<std::string()>;

/** Runs each pipeline repeatedly in its own thread, all at the same time. */
void ExpectSameBytesInParallel(const std::vector<Pipeline>& pipelines, int repetitions)
{
  std::vector<std::string> alone;
  for (const Pipeline& pipeline : pipelines)
  {
    alone.push_back(pipeline());
    ASSERT_FALSE(alone.back().empty()) << "pipeline " << alone.size() - 1;
  }
  std::vector<int> different(pipelines.size(), 0);
  std::atomic<std::size_t> ready{ 0 };
  std::vector<std::thread> threads;
  for (std::size_t i = 0; i < pipelines.size(); ++i)
  {
    threads.emplace_back(
      [&, i]
      {
        ++ready;
        while (ready < pipelines.size())
        {
          std::this_thread::yield();
        }
        for (int repetition = 0; repetition < repetitions; ++repetition)
        {
          different[i] += pipelines[i]() != alone[i] ? 1 : 0;
        }
      });
  }
  for (std::thread& thread : threads)
  {
    thread.join();
  }
  for (std::size_t i = 0; i < pipelines.size(); ++i)
  {
    EXPECT_EQ(different[i], 0) << "of " << repetitions << " runs of pipeline " << i;
  }
}

const Pipeline Constrained = []
{ return Perforated(false, vtkPerforatedCrossField::MethodConstrained); };
const Pipeline UnitNorm = [] { return Perforated(true, vtkPerforatedCrossField::MethodUnitNorm); };

/**
 * Returns the number of repetitions, which an environment variable can increase to find rare races.
 */
int Repetitions()
{
  const char* given = std::getenv("CROSSFIELD_THREAD_REPETITIONS");
  return given != nullptr ? std::atoi(given) : 8;
}

TEST(ThreadSafety, TwoPipelinesInParallel)
{
  ExpectSameBytesInParallel({ Constrained, UnitNorm }, Repetitions());
}

TEST(ThreadSafety, FourPipelinesInParallel)
{
  ExpectSameBytesInParallel({ Constrained, UnitNorm, H, Energy }, Repetitions());
}

TEST(ThreadSafety, TheSamePipelineTwice)
{
  ExpectSameBytesInParallel(
    { Constrained, Constrained, GinzburgLandau, GinzburgLandau }, Repetitions());
}

TEST(ThreadSafety, FailureDoesNotAffectOtherThreads)
{
  ExpectSameBytesInParallel({ Failure, Constrained, Failure, H }, Repetitions());
}
}
