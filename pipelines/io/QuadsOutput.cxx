#include "QuadsOutput.h"

#include "CommandLine.h"
#include "Json.h"
#include "vtkCrossFieldArrayNames.h"
#include "vtkCrossFieldReport.h"

#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkStringArray.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <iostream>
#include <string>
#include <vector>

namespace names = vtkCrossFieldArrayNames;

namespace
{
/** Prints a line for each curve. */
void PrintCurves(vtkFieldData* report)
{
  auto* sides = vtkStringArray::SafeDownCast(report->GetAbstractArray(names::CurveSides));
  auto* kinds = vtkStringArray::SafeDownCast(report->GetAbstractArray(names::CurveKind));
  for (vtkIdType i = 0; sides != nullptr && i < sides->GetNumberOfValues(); ++i)
  {
    std::cout << kinds->GetValue(i) << " along '" << sides->GetValue(i)
              << "': " << report->GetArray(names::CurveEdges)->GetTuple1(i)
              << " edges, nodes moved by at most "
              << report->GetArray(names::CurveMoved)->GetTuple1(i) << "\n";
  }
  if (vtkDataArray* ratio = report->GetArray(names::JacobianRatioMin))
  {
    std::cout << "curved quads of order " << report->GetArray(names::Order)->GetTuple1(0)
              << ": minimum over maximum of det J at least " << ratio->GetTuple1(0) << ", "
              << report->GetArray(names::CurvedInverted)->GetTuple1(0) << " inverted\n";
  }
}

/** Prints a line about materials. */
void PrintMaterials(vtkFieldData* report)
{
  auto* regions = vtkStringArray::SafeDownCast(report->GetAbstractArray(names::RegionMaterial));
  if (regions == nullptr)
  {
    return;
  }
  std::vector<std::string> materials;
  for (vtkIdType i = 0; i < regions->GetNumberOfValues(); ++i)
  {
    if (std::find(materials.begin(), materials.end(), regions->GetValue(i)) == materials.end())
    {
      materials.push_back(regions->GetValue(i));
    }
  }
  if (materials.size() < 2)
  {
    return; // lines divide one material
  }
  std::cout << regions->GetNumberOfValues() << " regions of " << materials.size() << " materials";
  constexpr std::size_t Listed = 10;
  for (std::size_t i = 0; i < std::min(Listed, materials.size()); ++i)
  {
    std::cout << (i == 0 ? ": " : ", ") << materials[i];
  }
  std::cout << (materials.size() > Listed ? ", ...\n" : "\n");
}

/** Prints the names of the sides and their numbers of edges. */
void PrintNames(vtkFieldData* report)
{
  auto* sides = vtkStringArray::SafeDownCast(report->GetAbstractArray(names::SideNames));
  const vtkIdType count = sides == nullptr ? 0 : sides->GetNumberOfValues();
  for (vtkIdType i = 0; i < count; ++i)
  {
    std::cout << (i == 0 ? "sides: " : ", ") << sides->GetValue(i) << " "
              << report->GetArray(names::SideEdges)->GetTuple1(i)
              << (i + 1 == count ? " edges\n" : "");
  }
}

/** Prints a line for each boundary layer. */
void PrintLayers(vtkFieldData* report)
{
  auto* sides = vtkStringArray::SafeDownCast(report->GetAbstractArray(names::LayerSide));
  for (vtkIdType i = 0; sides != nullptr && i < sides->GetNumberOfValues(); ++i)
  {
    const auto value = [&](const char* name, int component = 0)
    { return report->GetArray(name)->GetComponent(i, component); };
    std::cout << "layer of '" << sides->GetValue(i) << "': " << value(names::LayerReplaced)
              << " rows divided into " << value(names::LayerRows) << ", heights of the first "
              << value(names::LayerHeightRange, 0) << " to " << value(names::LayerHeightRange, 1)
              << ", largest growth " << value(names::LayerGrowth)
              << ", largest ratio of neighbours " << value(names::LayerRatio) << "\n";
  }
}

/** Prints a line for each pair of periodic sides. */
void PrintPeriodic(vtkFieldData* report)
{
  auto* kinds = vtkStringArray::SafeDownCast(report->GetAbstractArray(names::PeriodicKind));
  auto* sides = vtkStringArray::SafeDownCast(report->GetAbstractArray(names::PeriodicSides));
  for (vtkIdType i = 0; kinds != nullptr && i < kinds->GetNumberOfValues(); ++i)
  {
    const auto value = [&](const char* name, int component = 0)
    { return report->GetArray(name)->GetComponent(i, component); };
    const bool isRotation = value(names::PeriodicAngle) != 0.0;
    const char* vector = isRotation ? names::PeriodicCentre : names::PeriodicVector;
    std::cout << "periodic sides '" << sides->GetValue(2 * i) << "' and '"
              << sides->GetValue(2 * i + 1) << "': " << value(names::PeriodicEdges) << " edges, ";
    if (isRotation)
    {
      std::cout << "rotation by " << vtkMath::DegreesFromRadians(value(names::PeriodicAngle))
                << " degrees about (";
    }
    else
    {
      std::cout << "translation by (";
    }
    std::cout << value(vector, 0) << ", " << value(vector, 1) << ", " << value(vector, 2)
              << "), largest mismatch of nodes " << value(names::PeriodicMismatch) << "\n";
  }
}
}

namespace QuadsOutput
{
void Print(vtkUnstructuredGrid* quads)
{
  PrintMaterials(quads->GetFieldData());
  vtkNew<vtkCrossFieldReport> report;
  report->SetSource("data", quads);
  const double parts = FieldValue(quads, names::Parts);
  if (parts > 1.0)
  {
    std::cout << parts << " parts: ";
  }
  std::cout << FieldValue(quads, names::Quads) << " quads in " << FieldValue(quads, names::Blocks)
            << (FieldValue(quads, names::Blocks) == 1.0 ? " block" : " blocks")
            << ", irregular nodes by valence "
            << nlohmann::ordered_json::parse(report->Write("quads"))["irregular"]
            << ", minimum scaled Jacobian " << FieldValue(quads, names::ScaledJacobianRange)
            << " (attainable " << FieldValue(quads, names::ScaledJacobianBound) << ")\n";
  if (vtkDataArray* hexahedra = quads->GetFieldData()->GetArray(names::Hexahedra))
  {
    const double layers = FieldValue(quads, names::SweepLayers);
    std::cout << hexahedra->GetTuple1(0) << " hexahedra in " << layers
              << (layers == 1.0 ? " layer\n" : " layers\n");
  }
}

void PrintSides(vtkFieldData* report)
{
  PrintNames(report);
  PrintLayers(report);
  PrintPeriodic(report);
  PrintCurves(report);
}

void PrintFiles(std::initializer_list<std::string> files)
{
  const char* separator = "Written to ";
  for (const std::string& file : files)
  {
    if (!file.empty())
    {
      std::cout << separator << file;
      separator = ", ";
    }
  }
  std::cout << "\n";
}
}
