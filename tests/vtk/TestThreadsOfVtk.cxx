/** The number of threads of VTK's SMP backend counts for all filters. */
#include "vtkDrillHoles.h"
#include "vtkPerforatedCrossField.h"
#include "vtkPlanarDomainSource.h"
#include "vtkSingularitySource.h"

#include "vtkNew.h"
#include "vtkSMPTools.h"
#include "vtkUnstructuredGrid.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <string>
#include <thread>

namespace
{
/** Returns the number of threads of this process. */
int ThreadsOfProcess()
{
  int count = 0;
  for (const auto& task : std::filesystem::directory_iterator("/proc/self/task"))
  {
    count += task.path().empty() ? 0 : 1;
  }
  return count;
}

/** Selects VTK's backend of threads and makes those that it keeps: VTK 9.3 has a pool. */
void UseThreads()
{
  ASSERT_TRUE(vtkSMPTools::SetBackend("STDThread"));
  vtkSMPTools::For(0, 100, 1, [](vtkIdType, vtkIdType) {});
}

/** Returns how many threads remain after a filter with parallel loops, beside its own. */
int ThreadsOfAFilter()
{
  const int before = ThreadsOfProcess();
  vtkNew<vtkPlanarDomainSource> domain;
  vtkNew<vtkDrillHoles> drill;
  drill->SetInputConnection(domain->GetOutputPort());
  vtkNew<vtkSingularitySource> singularities;
  drill->SetSingularitiesConnection(singularities->GetOutputPort());
  drill->SetMeshSize(0.012);
  vtkNew<vtkPerforatedCrossField> field;
  field->SetInputConnection(drill->GetOutputPort());
  field->Update();
  EXPECT_EQ(field->GetErrorCode(), 0u);
  EXPECT_GT(field->GetOutput()->GetNumberOfCells(), 40000);
  return ThreadsOfProcess() - before;
}

// Threads are made when they are first needed, so each test runs in a process of its own (ctest).
class ThreadsOfVtk : public testing::Test
{
protected:
  void SetUp() override
  {
    if (std::thread::hardware_concurrency() < 2)
    {
      GTEST_SKIP() << "one processor";
    }
  }
  ~ThreadsOfVtk() override
  {
    vtkSMPTools::SetBackend(this->Backend.c_str());
    vtkSMPTools::Initialize(0);
    unsetenv("VTK_SMP_MAX_THREADS");
    unsetenv("VTK_SMP_BACKEND_IN_USE");
  }

  std::string Backend = vtkSMPTools::GetBackend();
};

TEST_F(ThreadsOfVtk, TheNumberOfABackendIsALimit)
{
  UseThreads();
  vtkSMPTools::Initialize(1);
  EXPECT_EQ(ThreadsOfAFilter(), 0);
  vtkSMPTools::Initialize(2);
  EXPECT_EQ(ThreadsOfAFilter(), 1);
}

TEST_F(ThreadsOfVtk, SequentialIsALimitIfTheUserHasChosenIt)
{
  ASSERT_TRUE(vtkSMPTools::SetBackend("Sequential"));
  setenv("VTK_SMP_BACKEND_IN_USE", "Sequential", 1);
  EXPECT_EQ(ThreadsOfAFilter(), 0);
  unsetenv("VTK_SMP_BACKEND_IN_USE");
  if (this->Backend == "Sequential") // VTK was built so
  {
    EXPECT_GT(ThreadsOfAFilter(), 0);
  }
}

TEST_F(ThreadsOfVtk, TheMaximumOfTheEnvironmentIsALimit)
{
  if (this->Backend != "Sequential")
  {
    GTEST_SKIP() << "this backend has read the variable already";
  }
  setenv("VTK_SMP_MAX_THREADS", "1", 1);
  EXPECT_EQ(ThreadsOfAFilter(), 0);
  unsetenv("VTK_SMP_MAX_THREADS");
  EXPECT_GT(ThreadsOfAFilter(), 0);
}

TEST_F(ThreadsOfVtk, ParallelLoopsOfVtkHaveDividedTheWork)
{
  UseThreads();
  vtkSMPTools::Initialize(2);
  const int before = ThreadsOfProcess();
  vtkSMPTools::For(0, 2, 1,
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType i = begin; i < end; ++i)
      {
        ThreadsOfAFilter();
      }
    });
  EXPECT_EQ(ThreadsOfProcess(), before); // none is left beside those of the pool
}
}
