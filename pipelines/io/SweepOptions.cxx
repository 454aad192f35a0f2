#include "SweepOptions.h"

#include "vtkExtrudeQuads.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace
{
/** Returns the parts of a text between commas, with empty texts if there are fewer than three. */
std::vector<std::string> Split(const std::string& text)
{
  std::vector<std::string> parts = CLI::detail::split(text, ',');
  parts.resize(std::max<std::size_t>(parts.size(), 3));
  return parts;
}

/** Reads a number, or returns NaN. */
double Number(const std::string& text)
{
  double value = 0.0;
  return CLI::detail::lexical_cast(text, value) ? value : std::numeric_limits<double>::quiet_NaN();
}

bool IsWhole(double value)
{
  return value >= 1.0 && value <= std::numeric_limits<int>::max() && value == std::floor(value);
}
}

void SweepOptions::AddTo(CLI::App& command)
{
  CLI::Option* height =
    command
      .add_option("--extrude", this->extrude,
        "make hexahedra: height along the normal of the quads, number of layers (default: 1), and height of "
        "the last layer by that of the first (default: 1); sides back and front")
      ->type_name("HEIGHT[,LAYERS[,RATIO]]");
  command
    .add_option("--revolve", this->revolve,
      "make hexahedra: angle about the axis in degrees, at most 360, number of layers (default: 1), and "
      "axis, x (y = 0), y (x = 0), or two points X0,Y0,X1,Y1 (default: x)")
    ->type_name("ANGLE[,LAYERS[,AXIS]]")
    ->excludes(height);
}

void SweepOptions::Read()
{
  const bool isRevolution = !this->revolve.empty();
  if (!isRevolution && this->extrude.empty())
  {
    return;
  }
  const std::string& text = isRevolution ? this->revolve : this->extrude;
  const std::vector<std::string> parts = Split(text);
  const double layers = parts[1].empty() ? 1.0 : Number(parts[1]);
  this->Size = Number(parts[0]);
  const bool isLastValid = isRevolution
    ? this->ReadAxis({ parts.begin() + 2, parts.end() })
    : parts.size() == 3 && (parts[2].empty() || this->ReadRatio(parts[2]));
  if (!(this->Size > 0.0) || !std::isfinite(this->Size) || !IsWhole(layers) || !isLastValid ||
    (isRevolution && this->Size > 360.0))
  {
    throw CLI::ValidationError(isRevolution ? "--revolve: '" + text +
          "' is not an angle from 0 to 360, a number of layers, and x, y or two points, such as 5,1,x or 5,1,0,2,1,2"
                                            : "--extrude: '" + text +
          "' is not a positive height, a number of layers and a positive ratio, such as 0.1,4 or 0.1,4,3");
  }
  this->Layers = static_cast<int>(layers);
}

bool SweepOptions::ReadRatio(const std::string& text)
{
  this->Ratio = Number(text);
  return this->Ratio > 0.0 && std::isfinite(this->Ratio);
}

bool SweepOptions::ReadAxis(const std::vector<std::string>& parts)
{
  if (parts.size() == 1)
  {
    this->Axis = parts[0] == "y" ? vtkExtrudeQuads::AxisY : vtkExtrudeQuads::AxisX;
    return parts[0].empty() || parts[0] == "x" || parts[0] == "y";
  }
  if (parts.size() != this->Line.size())
  {
    return false;
  }
  this->Axis = vtkExtrudeQuads::AxisLine;
  std::transform(parts.begin(), parts.end(), this->Line.begin(), Number);
  const auto& [x0, y0, x1, y1] = this->Line;
  return std::isfinite(x0 + y0 + x1 + y1) && (x0 != x1 || y0 != y1);
}

vtkSmartPointer<vtkExtrudeQuads> SweepOptions::Make() const
{
  if (!this->IsSet())
  {
    return nullptr;
  }
  auto filter = vtkSmartPointer<vtkExtrudeQuads>::New();
  filter->SetMotion(
    this->revolve.empty() ? vtkExtrudeQuads::Translation : vtkExtrudeQuads::Revolution);
  filter->SetHeight(this->Size);
  filter->SetAngle(this->Size);
  filter->SetLayers(this->Layers);
  filter->SetRatio(this->Ratio);
  filter->SetAxis(this->Axis);
  filter->SetAxisPoint1(this->Line[0], this->Line[1]);
  filter->SetAxisPoint2(this->Line[2], this->Line[3]);
  return filter;
}
