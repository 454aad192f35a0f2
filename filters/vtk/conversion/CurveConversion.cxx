#include "CurveConversion.h"

#include "ColumnWriting.h"
#include "Error.h"
#include "vtkCrossFieldArrayNames.h"

#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkIdTypeArray.h"
#include "vtkIntArray.h"
#include "vtkStringArray.h"
#include "vtkVariant.h"

#include <array>
#include <cmath>
#include <string>
#include <utility>

namespace names = vtkCrossFieldArrayNames;

namespace
{
using crossfield::Error;
using crossfield::PlaneCurve;
using crossfield::Point;

/** Texts of PlaneCurve::Kind. */
constexpr std::array<const char*, 4> Kinds = { "line", "circle", "ellipse", "nurbs" };

std::vector<double> ValuesOf(const PlaneCurve& curve)
{
  switch (curve.kind)
  {
  case PlaneCurve::Kind::Circle:
    return { curve.centre.x(), curve.centre.y(), curve.axis.x(), curve.axis.y() };
  case PlaneCurve::Kind::Ellipse:
    return { curve.centre.x(), curve.centre.y(), curve.axis.x(), curve.axis.y(), curve.ratio };
  case PlaneCurve::Kind::Nurbs:
  {
    std::vector<double> values = { static_cast<double>(curve.degree),
      static_cast<double>(curve.points.size()) };
    values.insert(values.end(), curve.knots.begin(), curve.knots.end());
    for (std::size_t i = 0; i < curve.points.size(); ++i)
    {
      values.insert(values.end(), { curve.points[i].x(), curve.points[i].y(), curve.weights[i] });
    }
    return values;
  }
  default:
    return {};
  }
}

/** The values of one curve, with checks. */
class CurveReader
{
public:
  CurveReader(std::size_t number, std::vector<double> values)
    : Number(number)
    , Values(std::move(values))
  {
  }

  PlaneCurve Read(const std::string& kind) const
  {
    for (const double value : this->Values)
    {
      this->Require(std::isfinite(value), "has a value that is not finite");
    }
    PlaneCurve curve;
    if (kind == Kinds[0])
    {
      this->RequireCount(0);
    }
    else if (kind == Kinds[1] || kind == Kinds[2])
    {
      this->ReadConic(kind == Kinds[2], curve);
    }
    else
    {
      this->Require(kind == Kinds[3], "is of the unknown kind '" + kind + "'");
      this->ReadNurbs(curve);
    }
    return curve;
  }

private:
  void Require(bool isValid, const std::string& problem) const
  {
    if (!isValid)
    {
      throw Error("Curve " + std::to_string(this->Number) + " of the domain " + problem +
        "; read its drawing again, or remove the cell array 'Curve'.");
    }
  }

  void RequireCount(std::size_t count) const
  {
    this->Require(this->Values.size() == count,
      "has " + std::to_string(this->Values.size()) + " values instead of " + std::to_string(count));
  }

  void ReadConic(bool isEllipse, PlaneCurve& curve) const
  {
    this->RequireCount(isEllipse ? 5 : 4);
    curve.kind = isEllipse ? PlaneCurve::Kind::Ellipse : PlaneCurve::Kind::Circle;
    curve.centre = Point(this->Values[0], this->Values[1]);
    curve.axis = Point(this->Values[2], this->Values[3]);
    curve.ratio = isEllipse ? this->Values[4] : 1.0;
    this->Require(curve.axis.norm() > 0.0, "has an axis of length zero");
    this->Require(curve.ratio > 0.0, "has a ratio of axes that is not positive");
  }

  void ReadNurbs(PlaneCurve& curve) const
  {
    const double rows = static_cast<double>(this->Values.size());
    this->Require(rows >= 2.0, "has no degree and number of control points");
    const double degree = this->Values[0];
    const double count = this->Values[1];
    this->Require(degree >= 1.0 && degree == std::floor(degree) && degree < count &&
        count == std::floor(count) && rows == 3.0 + degree + 4.0 * count,
      "has a degree, a number of control points and a number of values that do not match");
    curve.kind = PlaneCurve::Kind::Nurbs;
    curve.degree = static_cast<int>(degree);
    const auto points = static_cast<std::size_t>(count);
    const std::size_t knots = points + static_cast<std::size_t>(curve.degree) + 1;
    curve.knots.assign(
      this->Values.begin() + 2, this->Values.begin() + 2 + static_cast<long>(knots));
    for (std::size_t i = 1; i < knots; ++i)
    {
      this->Require(curve.knots[i] >= curve.knots[i - 1], "has knots that decrease");
    }
    this->Require(curve.knots[curve.degree] < curve.knots[points], "has an empty range of knots");
    for (std::size_t at = 2 + knots; at < this->Values.size(); at += 3)
    {
      curve.points.emplace_back(this->Values[at], this->Values[at + 1]);
      curve.weights.push_back(this->Values[at + 2]);
      this->Require(curve.weights.back() > 0.0, "has a weight that is not positive");
    }
  }

  std::size_t Number;
  std::vector<double> Values;
};

[[noreturn]] void Refuse(const std::string& problem)
{
  throw Error("The curves of the domain are damaged: " + problem +
    "; read its drawing again, or remove the cell array 'Curve'.");
}

std::vector<PlaneCurve> ReadList(vtkFieldData* data)
{
  auto* kinds = vtkStringArray::SafeDownCast(data->GetAbstractArray(names::CurveKind));
  vtkDataArray* offsets = data->GetArray(names::CurveOffset);
  vtkDataArray* values = data->GetArray(names::CurveValues);
  if (kinds == nullptr || offsets == nullptr || values == nullptr ||
    offsets->GetNumberOfComponents() != 1 || values->GetNumberOfComponents() != 1)
  {
    Refuse("the field data lack 'CurveKind', 'CurveOffset' or 'CurveValues'");
  }
  const vtkIdType count = kinds->GetNumberOfValues();
  if (offsets->GetNumberOfTuples() != count + 1)
  {
    Refuse("'CurveOffset' must have one more entry than 'CurveKind'");
  }
  std::vector<PlaneCurve> curves;
  vtkIdType first = 0;
  for (vtkIdType i = 0; i < count; ++i)
  {
    const double begin = offsets->GetTuple1(i);
    const double end = offsets->GetTuple1(i + 1);
    if (begin != static_cast<double>(first) || !(end >= begin) ||
      end > static_cast<double>(values->GetNumberOfTuples()) || end != std::floor(end))
    {
      Refuse("'CurveOffset' does not increase from 0 to the number of values");
    }
    std::vector<double> row;
    for (; first < static_cast<vtkIdType>(end); ++first)
    {
      row.push_back(values->GetTuple1(first));
    }
    curves.push_back(
      CurveReader(static_cast<std::size_t>(i), std::move(row)).Read(kinds->GetValue(i)));
  }
  return curves;
}
}

namespace CurveConversion
{
//------------------------------------------------------------------------------
void AddCurves(const CellCurves& curves, vtkDataSet* domain)
{
  std::vector<double> values;
  std::vector<vtkIdType> offsets = { 0 };
  for (const PlaneCurve& curve : curves.curves)
  {
    const std::vector<double> own = ValuesOf(curve);
    values.insert(values.end(), own.begin(), own.end());
    offsets.push_back(static_cast<vtkIdType>(values.size()));
  }
  vtkFieldData* data = domain->GetFieldData();
  ColumnWriting::AddColumn<vtkStringArray>(data, names::CurveKind, curves.curves,
    [](const PlaneCurve& curve) { return Kinds[static_cast<std::size_t>(curve.kind)]; });
  ColumnWriting::AddColumn<vtkIdTypeArray>(
    data, names::CurveOffset, offsets, [](vtkIdType offset) { return offset; });
  ColumnWriting::AddNumbers(data, names::CurveValues, values);
  ColumnWriting::AddIntegers(domain->GetCellData(), names::Curve, curves.ofCell);
}

//------------------------------------------------------------------------------
CellCurves ReadCurves(vtkDataSet* domain)
{
  CellCurves result;
  if (domain->GetCellData()->GetAbstractArray(names::Curve) == nullptr)
  {
    return result;
  }
  vtkDataArray* cells = domain->GetCellData()->GetArray(names::Curve);
  if (cells == nullptr || cells->GetNumberOfComponents() != 1 ||
    cells->GetNumberOfTuples() != domain->GetNumberOfCells())
  {
    Refuse("the cell array 'Curve' must have one integer for each cell");
  }
  result.curves = ReadList(domain->GetFieldData());
  const auto count = static_cast<double>(result.curves.size());
  for (vtkIdType cell = 0; cell < cells->GetNumberOfTuples(); ++cell)
  {
    const double index = cells->GetTuple1(cell);
    if (!(index >= -1.0 && index < count) || index != std::floor(index))
    {
      Refuse("the cell array 'Curve' has the entry " + cells->GetVariantValue(cell).ToString() +
        " at cell " + std::to_string(cell));
    }
    result.ofCell.push_back(static_cast<int>(index));
  }
  return result;
}
}
