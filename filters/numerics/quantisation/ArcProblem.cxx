#include "ArcProblem.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace crossfield
{
double ArcProblem::Cost(std::size_t arc, int count) const
{
  return this->weight[arc] * std::abs(count - this->wanted[arc]);
}

double ArcProblem::Cost(const std::vector<int>& counts) const
{
  double cost = 0.0;
  for (std::size_t a = 0; a < counts.size(); ++a)
  {
    cost += this->Cost(a, counts[a]);
  }
  return cost;
}

bool ArcProblem::Allows(const std::vector<int>& counts) const
{
  std::vector<int> sums(static_cast<std::size_t>(this->rows), 0);
  for (std::size_t a = 0; a < counts.size(); ++a)
  {
    if (counts[a] < this->lower[a])
    {
      return false;
    }
    for (const ArcTerm& term : this->terms[a])
    {
      sums[static_cast<std::size_t>(term.row)] += term.sign * counts[a];
    }
  }
  return std::all_of(sums.begin(), sums.end(), [](int sum) { return sum == 0; });
}

ArcProblem MakeArcProblem(const TMesh& mesh, std::vector<double> wanted)
{
  ArcProblem problem;
  problem.wanted = std::move(wanted);
  problem.weight.assign(mesh.arcs.size(), 0.0);
  problem.lower.assign(mesh.arcs.size(), 0);
  problem.terms.resize(mesh.arcs.size());
  for (const TPatch& face : mesh.patches)
  {
    std::array<double, 4> edges{};
    for (std::size_t side = 0; side < 4; ++side)
    {
      for (const int half : face.sides[side])
      {
        edges[side] += problem.wanted[static_cast<std::size_t>(half / 2)];
      }
    }
    for (std::size_t side = 0; side < 4; ++side)
    {
      const double width = 0.5 * (edges[(side + 1) % 4] + edges[(side + 3) % 4]);
      const ArcTerm term = { problem.rows + static_cast<int>(side % 2), side < 2 ? 1 : -1 };
      for (const int half : face.sides[side])
      {
        const auto arc = static_cast<std::size_t>(half / 2);
        problem.weight[arc] += 0.5 * width;
        std::vector<ArcTerm>& terms = problem.terms[arc];
        if (terms.size() == 1 && terms[0].row == term.row && terms[0].sign == -term.sign)
        {
          terms.clear();
        }
        else
        {
          terms.push_back(term);
        }
      }
    }
    problem.rows += 2;
  }
  // An arc between faces without width still has a wanted count; far below any real weight.
  constexpr double LeastWeight = 1e-3;
  for (double& weight : problem.weight)
  {
    weight = std::max(weight, LeastWeight);
  }
  return problem;
}

ArcProblem MakeArcProblem(const TMesh& mesh, double size)
{
  std::vector<double> wanted;
  wanted.reserve(mesh.arcs.size());
  for (const TArc& arc : mesh.arcs)
  {
    wanted.push_back(arc.length / size);
  }
  return MakeArcProblem(mesh, std::move(wanted));
}
}
