#include "RegionTurns.h"

#include <cmath>

namespace crossfield
{
namespace
{
double EnergyOfTurn(const Configuration& own, const Configuration& others, const Isometry& turn)
{
  double energy = 0.0;
  for (const Singularity& one : own)
  {
    const Point place = turn(one.position);
    for (const Singularity& other : others)
    {
      energy -= one.quarterIndex * other.quarterIndex * std::log((place - other.position).norm());
    }
  }
  return energy;
}
}

Isometry LowestTurn(const Configuration& own, const Configuration& others, const Point& centre)
{
  constexpr int Directions = 360; // more than minima
  const auto energyAt = [&](double angle) {
    return EnergyOfTurn(own, others, { centre, angle, false });
  };
  double best = 0.0;
  constexpr double Rounding = 1e-9;
  const double present = energyAt(0.0);
  double lowest = present;
  for (int i = 1; i < Directions; ++i)
  {
    const double angle = 2.0 * Pi * i / Directions;
    if (energyAt(angle) < lowest - Rounding)
    {
      lowest = energyAt(angle);
      best = angle;
    }
  }
  double low = best - 2.0 * Pi / Directions;
  double high = best + 2.0 * Pi / Directions;
  constexpr int Thirds = 60; // (2/3)⁶⁰ of the interval
  for (int i = 0; i < Thirds; ++i)
  {
    const double third = (high - low) / 3.0;
    if (energyAt(low + third) < energyAt(high - third))
    {
      high -= third;
    }
    else
    {
      low += third;
    }
  }
  const double angle = 0.5 * (low + high);
  return { centre, energyAt(angle) < present - Rounding ? angle : 0.0, false };
}
}
