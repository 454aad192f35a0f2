#include "SweepOptions.h"

#include "vtkExtrudeQuads.h"

#include <CLI/CLI.hpp>

#include <cmath>
#include <limits>
#include <vector>

namespace
{
/** Returns the parts of a text between commas, an empty text if there are fewer than three. */
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
        "make hexahedra: height along the normal of the quads, and number of layers "
        "(default: 1); sides back and front")
      ->type_name("HEIGHT[,LAYERS]");
  command
    .add_option("--revolve", this->revolve,
      "make hexahedra: angle about the axis in degrees, at most 360, number of layers (default: 1), and "
      "axis, x (y = 0) or y (x = 0) (default: x)")
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
  const bool isAxis = parts[2].empty() || (isRevolution && (parts[2] == "x" || parts[2] == "y"));
  if (!(this->Size > 0.0) || !std::isfinite(this->Size) || !IsWhole(layers) || !isAxis ||
    parts.size() > 3 || (isRevolution && this->Size > 360.0))
  {
    throw CLI::ValidationError(isRevolution ? "--revolve: '" + text +
          "' is not an angle from 0 to 360, a number of layers and x or y, such as 5,1,x"
                                            : "--extrude: '" + text +
          "' is not a positive height and a number of layers, such as 0.1,4");
  }
  this->Layers = static_cast<int>(layers);
  this->Axis = parts[2] == "y" ? vtkExtrudeQuads::AxisY : vtkExtrudeQuads::AxisX;
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
  filter->SetAxis(this->Axis);
  return filter;
}
