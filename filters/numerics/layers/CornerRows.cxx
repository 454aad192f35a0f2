#include "CornerRows.h"

#include "Outcome.h"
#include "PoincareHopf.h"

#include <algorithm>
#include <cmath>
#include <string>

namespace crossfield
{
namespace
{
constexpr double Degree = Pi / 180.0;

/// Throws Error for a corner whose angle is out of the bounds of a treatment.
[[noreturn]] void Refuse(const Corner& corner, const std::string& word, const std::string& bounds,
  const std::string& remedy)
{
  throw Error("The corner at " + Describe(corner.position) + " has an angle of " +
    std::to_string(std::lround(corner.angle / Degree)) + "°, but rows can " + word + " only at " +
    bounds + "; let them " + remedy + " there.");
}

/// Returns a number that is smaller the more special a rule is.
int Rank(const CornerRule& rule)
{
  return rule.position ? 0 : rule.side.empty() ? 2 : 1;
}

bool IsPossible(const Corner& corner, CornerRows rows)
{
  return Try([&] { return QuarterIndexFor(corner, rows); }).value.has_value();
}

bool Applies(
  const CornerRule& rule, const Corner& corner, const std::vector<std::string>& sides, double reach)
{
  if (rule.position)
  {
    return (corner.position - *rule.position).norm() <= reach;
  }
  if (!rule.side.empty())
  {
    return std::find(sides.begin(), sides.end(), rule.side) != sides.end();
  }
  return corner.angle >= rule.angles[0] - AngleRounding &&
    corner.angle <= rule.angles[1] + AngleRounding;
}

/// Returns where a rule applies, for messages.
std::string DescribeRule(const CornerRule& rule)
{
  if (rule.position)
  {
    return "at " + Describe(*rule.position);
  }
  if (!rule.side.empty())
  {
    return "of a side '" + rule.side + "'";
  }
  return "with an angle of " + std::to_string(std::lround(rule.angles[0] / Degree)) + "° to " +
    std::to_string(std::lround(rule.angles[1] / Degree)) + "°";
}
}

CornerRows DefaultRows(double angle)
{
  if (angle <= 135.0 * Degree + TieRounding)
  {
    return CornerRows::End;
  }
  return angle <= 315.0 * Degree + TieRounding ? CornerRows::Turn : CornerRows::Leave;
}

int QuarterIndexFor(const Corner& corner, CornerRows rows)
{
  const double angle = corner.angle;
  switch (rows)
  {
  case CornerRows::End:
    if (angle >= 170.0 * Degree)
    {
      Refuse(corner, "end", "less than 170°", angle > 315.0 * Degree ? "leave" : "turn");
    }
    return 1;
  case CornerRows::Turn:
    if (angle <= 100.0 * Degree || angle >= 350.0 * Degree)
    {
      Refuse(corner, "turn", "100° to 350°", angle <= 100.0 * Degree ? "end" : "leave");
    }
    return 0;
  default:
    if (angle <= 225.0 * Degree)
    {
      Refuse(corner, "leave", "more than 225°", angle <= 135.0 * Degree ? "end" : "turn");
    }
    return std::min(-1, SmallestRotationIndex(corner.Turning()));
  }
}

std::vector<CornerChoice> TreatCorners(
  const PlanarDomain& domain, const std::vector<CornerRule>& rules, const SidesAtCorner& sidesAt)
{
  std::vector<CornerChoice> choices;
  if (rules.empty())
  {
    return choices;
  }
  const double reach = BoundaryReach * domain.Diagonal();
  std::vector<bool> applies(rules.size(), false);
  for (const Corner& corner : FindCorners(domain.loops))
  {
    const std::vector<std::string> sides = sidesAt(corner);
    const CornerRule* found = nullptr;
    for (std::size_t i = 0; i < rules.size(); ++i)
    {
      const CornerRule& rule = rules[i];
      if (!Applies(rule, corner, sides, reach) ||
        (!rule.position && !IsPossible(corner, rule.rows)))
      {
        continue;
      }
      applies[i] = true;
      if (found != nullptr && Rank(*found) == Rank(rule) && found->rows != rule.rows)
      {
        throw Error("The corner at " + Describe(corner.position) +
          " is treated in two ways; give one of them.");
      }
      found = found == nullptr || Rank(rule) < Rank(*found) ? &rule : found;
    }
    if (found != nullptr)
    {
      choices.push_back({ corner.position, QuarterIndexFor(corner, found->rows) });
    }
  }
  for (std::size_t i = 0; i < rules.size(); ++i)
  {
    if (!applies[i])
    {
      throw Error("The boundary has no corner " + DescribeRule(rules[i]) +
        " at which rows can do this; give vertices at which it turns by more than 30°.");
    }
  }
  return choices;
}
}
