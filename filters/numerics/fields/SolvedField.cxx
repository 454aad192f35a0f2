#include "SolvedField.h"

#include <tuple>

namespace crossfield
{
namespace
{
bool IsFlawless(const SolvedField& field)
{
  return field.converged && field.wrongDegrees == 0 && field.unwantedSingularities == 0;
}
}

void SolvedField::Read(const Configuration& points)
{
  static_cast<FieldReading&>(*this) =
    ReadField(*this, { this->count, points, this->globalConstraint });
}

bool IsBetter(const SolvedField& field, const SolvedField& other)
{
  const auto shortcomings = [](const SolvedField& of)
  { return std::make_tuple(!of.converged, of.wrongDegrees, of.unwantedSingularities); };
  // Two paths to one minimum yield energies that differ by the remaining residual.
  constexpr double SameEnergy = 1e-9;
  return shortcomings(field) != shortcomings(other)
    ? shortcomings(field) < shortcomings(other)
    : field.energy < other.energy * (1.0 - SameEnergy);
}

SolvedField BestOfTwo(
  const std::function<SolvedField()>& first, const std::function<SolvedField()>& second)
{
  SolvedField field = first();
  if (!IsFlawless(field))
  {
    SolvedField other = second();
    if (IsBetter(other, field))
    {
      return other;
    }
  }
  return field;
}
}
