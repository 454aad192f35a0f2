#include "ResultFiles.h"

#include "vtkAlgorithm.h"
#include "vtkNew.h"
#include "vtkUnstructuredGrid.h"
#include "vtkXMLUnstructuredGridWriter.h"

#include <gtest/gtest.h>

#include <cctype>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <functional>
#include <string>

namespace
{
/** Returns the suite and name of the running test, usable in a file name. */
std::string RunningTest()
{
  const testing::TestInfo* test = testing::UnitTest::GetInstance()->current_test_info();
  std::string name = std::string(test->test_suite_name()) + "." + test->name();
  for (char& letter : name)
  {
    letter = std::isalnum(static_cast<unsigned char>(letter)) != 0 || letter == '.' ? letter : '_';
  }
  return name;
}
}

namespace ResultFiles
{
void Save(vtkAlgorithm* filter)
{
  const char* folder = std::getenv("CROSSFIELD_WRITTEN");
  auto* grid = vtkUnstructuredGrid::SafeDownCast(filter->GetOutputDataObject(0));
  const std::string type = filter->GetClassName();
  const bool computes = type == "vtkDrillHoles" || type == "vtkPerforatedCrossField" ||
    type == "vtkGinzburgLandauCrossField" || type == "vtkHField";
  if (folder == nullptr || grid == nullptr || grid->GetNumberOfCells() == 0 || !computes)
  {
    return;
  }
  vtkNew<vtkXMLUnstructuredGridWriter> writer;
  writer->SetInputDataObject(grid);
  writer->SetDataModeToBinary();
  writer->WriteToOutputStringOn();
  writer->Write();
  const std::string contents = writer->GetOutputString();
  const std::filesystem::path file = std::filesystem::path(folder) /
    ("Vtk." + RunningTest() + "." + std::to_string(std::hash<std::string>()(contents)) + ".vtu");
  if (!std::filesystem::exists(file))
  {
    std::ofstream stream(file, std::ios::binary);
    stream << contents;
    stream.close();
    EXPECT_TRUE(stream.good()) << "cannot write " << file;
  }
}
}
