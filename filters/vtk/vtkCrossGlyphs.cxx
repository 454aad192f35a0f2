#include "vtkCrossGlyphs.h"

#include "CrossSamples.h"
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

#include <Eigen/Geometry>

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

/**
 * Crosses of triangles. They are read from the display arrays, which other filters may have
 * transformed with the mesh, or computed from the exact field.
 */
class CrossReader
{
public:
  explicit CrossReader(vtkDataSet* input)
  {
    namespace names = vtkCrossFieldArrayNames;
    const auto has = [input](const char* name)
    { return input->GetCellData()->GetArray(name) != nullptr; };
    const bool derives = has(names::CrossFieldCR) && !(has(names::Cross) && has(names::CrossNorm));
    if (derives)
    {
      this->Exact = RequireArray(input, names::CrossFieldCR, 6);
      this->Plane = DomainConversion::FindPlane(input);
      return;
    }
    this->Cross = RequireArray(input, names::Cross, 3);
    this->Cross2 = has(names::Cross2) ? RequireArray(input, names::Cross2, 3) : nullptr;
    this->Norms = RequireArray(input, names::CrossNorm, 1);
  }

  /** Stores the two branches of the cross of a cell with a unit normal, and returns |u|. */
  double Read(vtkIdType cell, const Eigen::Vector3d& normal, Eigen::Vector3d (&branches)[2]) const
  {
    double norm = 0.0;
    if (this->Exact != nullptr)
    {
      std::array<double, 6> sides = {};
      this->Exact->GetTuple(cell, sides.data());
      const crossfield::Complex u(
        (sides[0] + sides[2] + sides[4]) / 3.0, (sides[1] + sides[3] + sides[5]) / 3.0);
      branches[0] = this->Plane.DirectionToSpace(crossfield::CrossBranch(u));
      norm = std::abs(u);
    }
    else
    {
      this->Cross->GetTuple(cell, branches[0].data());
      norm = this->Norms->GetTuple1(cell);
    }
    if (this->Cross2 != nullptr)
    {
      this->Cross2->GetTuple(cell, branches[1].data());
      return norm;
    }
    branches[1] = normal.cross(branches[0]);
    return norm;
  }

private:
  vtkDataArray* Exact = nullptr;
  vtkDataArray* Cross = nullptr;
  vtkDataArray* Cross2 = nullptr;
  vtkDataArray* Norms = nullptr;
  crossfield::DomainPlane Plane;
};

/** Position and size of a glyph. */
struct GlyphPlace
{
  vtkIdType cell;
  std::array<double, 3> centre;
  double size;
  Eigen::Vector3d normal;
};

std::vector<GlyphPlace> PlacesOfTriangles(vtkDataSet* input)
{
  std::vector<GlyphPlace> places;
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
    GlyphPlace place{ cell, {}, 0.0, {} };
    vtkTriangle::TriangleCenter(corners[0], corners[1], corners[2], place.centre.data());
    place.size = std::sqrt(vtkTriangle::TriangleArea(corners[0], corners[1], corners[2]));
    const Eigen::Vector3d origin(corners[0]);
    place.normal = (Eigen::Vector3d(corners[1]) - origin)
                     .cross(Eigen::Vector3d(corners[2]) - origin)
                     .normalized();
    places.push_back(place);
  }
  return places;
}

/**
 * Selects in each square of the grid the glyph nearest to its centre, and moves it there if its
 * triangle contains the centre.
 */
std::vector<GlyphPlace> SelectOnGrid(
  vtkDataSet* input, const std::vector<GlyphPlace>& places, double spacing)
{
  const crossfield::DomainPlane plane = DomainConversion::FindPlane(input);
  std::map<std::array<double, 2>, std::pair<double, GlyphPlace>> nearest;
  for (const GlyphPlace& place : places)
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
  std::vector<GlyphPlace> kept;
  vtkNew<vtkIdList> ids;
  for (const auto& entry : nearest)
  {
    GlyphPlace place = entry.second.second;
    place.size = spacing;
    Eigen::Vector3d middle =
      plane.ToSpace({ (entry.first[0] + 0.5) * spacing, (entry.first[1] + 0.5) * spacing });
    if (plane.IsHorizontal())
    {
      middle.z() = place.centre[2]; // same height as the glyphs at centres of triangles
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
      const CrossReader crosses(input);
      std::vector<GlyphPlace> places = PlacesOfTriangles(input);
      progress.Report(0.5);
      if (this->Spacing > 0.0)
      {
        places = SelectOnGrid(input, places, this->Spacing);
      }
      vtkNew<vtkPoints> points;
      points->SetDataTypeToDouble();
      vtkNew<vtkCellArray> lines;
      vtkNew<vtkDoubleArray> lineNorms;
      lineNorms->SetName(vtkCrossFieldArrayNames::CrossNorm);
      for (const GlyphPlace& place : places)
      {
        Eigen::Vector3d branches[2];
        const double norm = crosses.Read(place.cell, place.normal, branches);
        const double half = 0.5 * this->Scale * place.size * (this->ScaleByNorm ? norm : 1.0);
        const Eigen::Vector3d centre(place.centre.data());
        for (const Eigen::Vector3d& along : branches)
        {
          const Eigen::Vector3d from = centre - half * along;
          const Eigen::Vector3d to = centre + half * along;
          lines->InsertNextCell(
            { points->InsertNextPoint(from.data()), points->InsertNextPoint(to.data()) });
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
