#include "FieldReading.h"

#include "FilterChecks.h"

#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <cmath>

//------------------------------------------------------------------------------
FieldReading::FieldReading(vtkUnstructuredGrid* mesh)
  : MeshReading(mesh)
  , Exact(FilterChecks::RequireArray(mesh->GetCellData(), "CrossFieldCR"))
{
}

//------------------------------------------------------------------------------
FieldReading::Sides FieldReading::At(vtkIdType cell) const
{
  double values[6];
  this->Exact->GetTuple(cell, values);
  return { Complex(values[0], values[1]), Complex(values[2], values[3]),
    Complex(values[4], values[5]) };
}

//------------------------------------------------------------------------------
FieldReading::Complex FieldReading::OnLine(std::size_t line) const
{
  return this->At(this->lines[line].cell)[0];
}

//------------------------------------------------------------------------------
FieldReading::Sides FieldReading::AtCorners(std::size_t triangle) const
{
  const Sides u = this->At(this->triangles[triangle].cell);
  return { u[0] + u[2] - u[1], u[0] + u[1] - u[2], u[1] + u[2] - u[0] };
}

//------------------------------------------------------------------------------
double FieldReading::Dirichlet(std::size_t triangle, Complex toSecond, Complex toThird) const
{
  const auto& corners = this->triangles[triangle].points;
  const Place a = this->points[corners[1]] - this->points[corners[0]];
  const Place b = this->points[corners[2]] - this->points[corners[0]];
  // The gradient g solves a · g = toSecond and b · g = toThird.
  const double twiceArea = std::imag(std::conj(a) * b);
  const Complex gx = (b.imag() * toSecond - a.imag() * toThird) / twiceArea;
  const Complex gy = (a.real() * toThird - b.real() * toSecond) / twiceArea;
  return 0.25 * twiceArea * (std::norm(gx) + std::norm(gy));
}

//------------------------------------------------------------------------------
double FieldReading::Energy() const
{
  double energy = 0.0;
  for (std::size_t t = 0; t < this->triangles.size(); ++t)
  {
    const Sides u = this->AtCorners(t);
    energy += this->Dirichlet(t, u[1] - u[0], u[2] - u[0]);
  }
  return energy;
}

//------------------------------------------------------------------------------
double FieldReading::PhaseEnergy(std::size_t triangle) const
{
  const Sides u = this->At(this->triangles[triangle].cell);
  // The difference of a linear function between two corners is twice that between the midpoints of
  // the other two sides.
  return this->Dirichlet(triangle, 2.0 * std::arg(u[1] / u[2]), 2.0 * std::arg(u[1] / u[0]));
}

//------------------------------------------------------------------------------
int FieldReading::CountSingular() const
{
  std::vector<double> around(this->points.size(), 0.0);
  int count = 0;
  for (const Triangle& triangle : this->triangles)
  {
    const Sides u = this->At(triangle.cell);
    double sum = 0.0;
    for (std::size_t i = 0; i < 3; ++i)
    {
      const double step = std::arg(u[(i + 1) % 3] / u[i]);
      sum += step;
      around[static_cast<std::size_t>(triangle.points[(i + 1) % 3])] -= step;
    }
    count += std::abs(sum) > 1.0 ? 1 : 0;
  }
  for (const Line& line : this->lines)
  {
    around[static_cast<std::size_t>(line.points[0])] = 0.0;
  }
  return count +
    static_cast<int>(
      std::count_if(around.begin(), around.end(), [](double sum) { return std::abs(sum) > 1.0; }));
}

//------------------------------------------------------------------------------
double FieldReading::Degree(int row) const
{
  const std::vector<std::size_t> walk =
    this->OrderedLoop(3, row); // clockwise: the domain is on the left
  double angle = 0.0;
  for (std::size_t i = 0; i < walk.size(); ++i)
  {
    angle -= std::arg(this->OnLine(walk[(i + 1) % walk.size()]) / this->OnLine(walk[i]));
  }
  return angle / (2.0 * std::acos(-1.0));
}
