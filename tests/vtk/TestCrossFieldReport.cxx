#include "vtkCrossFieldReport.h"

#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkStringArray.h"
#include "vtkTable.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <string>
#include <vector>

namespace
{
template <class Array, class Value>
void Add(vtkFieldData* data, const char* name, std::initializer_list<Value> values, int size = 1)
{
  vtkNew<Array> array;
  array->SetName(name);
  array->SetNumberOfComponents(size);
  for (const Value& value : values)
  {
    array->InsertNextValue(value);
  }
  data->AddArray(array);
}

/** Returns a report without blanks and line breaks. */
std::string Compact(vtkCrossFieldReport* report, const std::string& name)
{
  std::string text = report->Write(name);
  text.erase(std::remove_if(text.begin(), text.end(), [](char c) { return c == ' ' || c == '\n'; }),
    text.end());
  return text;
}

TEST(CrossFieldReport, KeysAreTheNamesOfArrays)
{
  vtkNew<vtkPolyData> lines;
  vtkFieldData* data = lines->GetFieldData();
  Add<vtkIntArray>(data, "ExtraLines", { 3 });
  Add<vtkDoubleArray>(data, "Longest", { std::nan("") });
  Add<vtkIntArray>(data, "Other", { 1 });
  vtkNew<vtkPolyData> map;
  Add<vtkStringArray>(map->GetFieldData(), "StretchReason", { "\xff" });
  Add<vtkDoubleArray>(map->GetFieldData(), "DefectBefore", { 0.5 });
  vtkNew<vtkCrossFieldReport> report;
  report->SetSource("data", lines);
  report->SetSource("map", map);
  report->SetSource("domain", nullptr);
  EXPECT_EQ(Compact(report, "separatrices"),
    R"({"extra_lines":3,"longest":null,"stretch":{"reason":"�"},"repair":{"defect_before":[0.5]}})");
  report->SetSeconds({ 1.0, 2.0, 4.0 });
  EXPECT_NE(Compact(report, "separatrices").find(R"("seconds":{"mesh":1.0,"map":2.0,"trace":4.0})"),
    std::string::npos);
  EXPECT_EQ(Compact(report, ""), "{}");
}

TEST(CrossFieldReport, RowsAreObjects)
{
  vtkNew<vtkTable> energies;
  Add<vtkIntArray>(energies->GetRowData(), "Configuration", { 1, 0 });
  Add<vtkDoubleArray>(energies->GetRowData(), "Energy", { 2.0, std::nan("") });
  Add<vtkIntArray>(energies->GetRowData(), "Consistent", { 1, 0 });
  vtkNew<vtkPolyData> gradients;
  vtkNew<vtkPoints> points;
  points->InsertNextPoint(0.25, 0.5, 0.0);
  gradients->SetPoints(points);
  Add<vtkIntArray>(gradients->GetPointData(), "Configuration", { 1 });
  Add<vtkDoubleArray>(gradients->GetPointData(), "Gradient", { 1.0, 2.0 }, 2);
  vtkNew<vtkCrossFieldReport> report;
  report->SetSource("data", energies);
  report->SetSource("gradients", gradients);
  const std::string gradient = R"("gradient":[{"x":0.25,"y":0.5,"dx":1.0,"dy":2.0}])";
  EXPECT_EQ(Compact(report, "energy"),
    R"({"configurations":[{"configuration":1,"energy":2.0,"consistent":true,)" + gradient +
      R"(},{"configuration":0,"energy":null,"consistent":false,"gradient":[]}]})");
  report->SetFiles({ "a.csv", "b.csv" });
  EXPECT_EQ(Compact(report, "energy"),
    R"({"configurations":[{"energy":2.0,"consistent":true,)" + gradient +
      R"(,"file":"b.csv"},{"consistent":false,"file":"a.csv"}]})");
}
TEST(CrossFieldReport, WhatIsMissingIsLeftOut)
{
  vtkNew<vtkTable> other;
  for (const char* name :
    { "check", "corners", "energy", "field", "optimize", "quads", "separatrices" })
  {
    vtkNew<vtkCrossFieldReport> report;
    report->SetSeconds(std::vector<double>(20, 1.0));
    EXPECT_EQ(Compact(report, name).front(), '{');
    for (const char* source :
      { "data", "scenarios", "gradients", "corners", "map", "domain", "singularities" })
    {
      report->SetSource(source, other);
    }
    EXPECT_EQ(Compact(report, name).front(), '{');
  }
}
}
