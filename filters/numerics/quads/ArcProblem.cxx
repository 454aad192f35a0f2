#include "ArcProblem.h"

#include <algorithm>
#include <cmath>

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

ArcProblem MakeArcProblem(const TMesh& mesh, double size)
{
  ArcProblem problem;
  problem.wanted.reserve(mesh.arcs.size());
  for (const TArc& arc : mesh.arcs)
  {
    problem.wanted.push_back(arc.length / size);
  }
  problem.weight.assign(mesh.arcs.size(), 0.0);
  problem.lower.assign(mesh.arcs.size(), 0);
  problem.terms.resize(mesh.arcs.size());
  for (const TFace& face : mesh.faces)
  {
    for (std::size_t side = 0; side < 4; ++side)
    {
      const double width = mesh.SideLength(face, (side + 1) % 4) / size;
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
}
