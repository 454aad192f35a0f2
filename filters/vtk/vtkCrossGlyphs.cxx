#include "vtkCrossGlyphs.h"

#include "DomainConversion.h"
#include "Error.h"
#include "FilterRun.h"
#include "InputCheck.h"
#include "vtkCrossFieldArrayNames.h"

#include "vtkCell.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDataSet.h"
#include "vtkDoubleArray.h"
#include "vtkIdList.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkTriangle.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <vector>

vtkStandardNewMacro(vtkCrossGlyphs);

namespace
{
vtkDataArray* RequireArray(vtkDataSet* input, const char* name, int components)
{
  vtkDataArray* array = input->GetCellData()->GetArray(name);
  if (array == nullptr || array->GetNumberOfComponents() != components)
  {
    throw crossfield::Error(std::string("The input has no cell array '") + name + "' with " +
      std::to_string(components) + " components; give the output of a cross field filter.");
  }
  return array;
}

/** Where a cross is drawn, and how large it may be. */
struct Place
{
  vtkIdType cell;
  std::array<double, 3> centre;
  double room;
};

std::vector<Place> TrianglePlaces(vtkDataSet* input)
{
  std::vector<Place> places;
  vtkNew<vtkIdList> ids;
  for (vtkIdType cell = 0; cell < input->GetNumberOfCells(); ++cell)
  {
    if (input->GetCellType(cell) != VTK_TRIANGLE)
    {
      continue;
    }
    input->GetCellPoints(cell, ids);
    double corners[3][3];
    for (int i = 0; i < 3; ++i)
    {
      input->GetPoint(ids->GetId(i), corners[i]);
    }
    Place place{ cell, {}, 0.0 };
    vtkTriangle::TriangleCenter(corners[0], corners[1], corners[2], place.centre.data());
    place.room = std::sqrt(vtkTriangle::TriangleArea(corners[0], corners[1], corners[2]));
    places.push_back(place);
  }
  return places;
}

/** Keeps in each square of the grid the place nearest to its middle, and moves it there if it can. */
std::vector<Place> ThinOut(vtkDataSet* input, const std::vector<Place>& places, double spacing)
{
  const crossfield::DomainPlane plane = DomainConversion::FindPlane(input);
  std::map<std::array<double, 2>, std::pair<double, Place>> nearest;
  for (const Place& place : places)
  {
    const crossfield::Point centre = plane.ToPlane(Eigen::Vector3d(place.centre.data()));
    const std::array<double, 2> square = { std::floor(centre.x() / spacing),
      std::floor(centre.y() / spacing) };
    const double distance = std::hypot(
      centre.x() - (square[0] + 0.5) * spacing, centre.y() - (square[1] + 0.5) * spacing);
    const auto [found, added] = nearest.try_emplace(square, distance, place);
    if (!added && distance < found->second.first)
    {
      found->second = { distance, place };
    }
  }
  std::vector<Place> kept;
  vtkNew<vtkIdList> ids;
  for (const auto& entry : nearest)
  {
    Place place = entry.second.second;
    place.room = spacing;
    Eigen::Vector3d middle =
      plane.ToSpace({ (entry.first[0] + 0.5) * spacing, (entry.first[1] + 0.5) * spacing });
    if (plane.IsHorizontal())
    {
      middle.z() = place.centre[2]; // as the crosses at the centres of triangles
    }
    double corners[3][3];
    input->GetCellPoints(place.cell, ids);
    for (int i = 0; i < 3; ++i)
    {
      input->GetPoint(ids->GetId(i), corners[i]);
    }
    if (vtkTriangle::PointInTriangle(middle.data(), corners[0], corners[1], corners[2], 0.0) != 0)
    {
      std::copy(middle.data(), middle.data() + 3, place.centre.begin());
    }
    kept.push_back(place);
  }
  return kept;
}
}

//------------------------------------------------------------------------------
vtkCrossGlyphs::vtkCrossGlyphs() = default;

//------------------------------------------------------------------------------
int vtkCrossGlyphs::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkDataSet");
  return 1;
}

//------------------------------------------------------------------------------
int vtkCrossGlyphs::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkDataSet* input = vtkDataSet::GetData(inputVector[0]);
  vtkPolyData* output = vtkPolyData::GetData(outputVector);
  return FilterRun::Run(this, this->ErrorCode, input,
    [&](const crossfield::Progress& progress)
    {
      InputCheck::Require(input);
      namespace names = vtkCrossFieldArrayNames;
      vtkDataArray* branches[2] = { RequireArray(input, names::Cross, 3),
        RequireArray(input, names::Cross2, 3) };
      vtkDataArray* norms = RequireArray(input, names::CrossNorm, 1);
      std::vector<Place> places = TrianglePlaces(input);
      progress.Report(0.5);
      if (this->Spacing > 0.0)
      {
        places = ThinOut(input, places, this->Spacing);
      }
      vtkNew<vtkPoints> points;
      points->SetDataTypeToDouble();
      vtkNew<vtkCellArray> lines;
      vtkNew<vtkDoubleArray> lineNorms;
      lineNorms->SetName(names::CrossNorm);
      for (const Place& place : places)
      {
        const double norm = norms->GetTuple1(place.cell);
        const double half = 0.5 * this->Scale * place.room * (this->ScaleByNorm ? norm : 1.0);
        for (vtkDataArray* branch : branches)
        {
          const double* along = branch->GetTuple3(place.cell);
          const auto& c = place.centre;
          const vtkIdType from = points->InsertNextPoint(
            c[0] - half * along[0], c[1] - half * along[1], c[2] - half * along[2]);
          const vtkIdType to = points->InsertNextPoint(
            c[0] + half * along[0], c[1] + half * along[1], c[2] + half * along[2]);
          lines->InsertNextCell({ from, to });
          lineNorms->InsertNextValue(norm);
        }
      }
      output->SetPoints(points);
      output->SetLines(lines);
      output->GetCellData()->SetScalars(lineNorms);
    });
}

//------------------------------------------------------------------------------
void vtkCrossGlyphs::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Spacing: " << this->Spacing << "\n";
  os << indent << "Scale: " << this->Scale << "\n";
  os << indent << "ScaleByNorm: " << (this->ScaleByNorm ? "on" : "off") << "\n";
}
