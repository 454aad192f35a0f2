#include "ConjugateField.h"

#include "Parts.h"

#include <algorithm>
#include <cstdint>
#include <map>
#include <utility>

namespace crossfield
{
namespace
{
/// Value on an edge between two parts of the triangles, as found in one of them.
struct LinkValue
{
  int edge;
  int component;
  Eigen::VectorXd values;
};

/// Integrates the conjugate in connected components of parts of the triangles, from any value in
/// each component, and then finds the constants that make them fit.
class PartwiseIntegral
{
public:
  PartwiseIntegral(const MeshTopology& topology, const Eigen::MatrixXd& gradients,
    const std::vector<LogSource>& logs)
    : Topology(topology)
    , Edges(topology.edges)
    , Gradients(gradients)
    , Logs(logs)
    , Functions(gradients.rows() / 2)
    , PartOf(topology.mesh.triangles.size())
    , Links(PartCount(topology.TriangleCount()))
    , ComponentOf(topology.mesh.triangles.size(), -1)
    , ComponentCounts(Links.size(), 0)
    , Known(static_cast<std::size_t>(this->Edges.Count()), 0)
    , Values(Functions, topology.edges.Count())
  {
    for (std::size_t part = 0; part < this->Links.size(); ++part)
    {
      const auto [begin, end] = this->RangeOf(part);
      std::fill(
        this->PartOf.begin() + begin, this->PartOf.begin() + end, static_cast<std::uint8_t>(part));
    }
  }

  /// Returns the values on all edges, with given ones on the first edge.
  Eigen::MatrixXd Integrate(int firstEdge, const Eigen::VectorXd& firstValues)
  {
    const int firstTriangle = this->Edges.triangles[firstEdge][0];
    ForParts(this->Links.size(),
      [&](std::size_t part)
      {
        if (part == this->PartOf[firstTriangle])
        {
          this->IntegrateComponent(part, firstTriangle, firstEdge, firstValues);
        }
        const auto [begin, end] = this->RangeOf(part);
        for (int t = begin; t < end; ++t)
        {
          if (this->ComponentOf[t] < 0)
          {
            this->IntegrateComponent(
              part, t, this->Edges.ofTriangle[t][0], Eigen::VectorXd::Zero(this->Functions));
          }
        }
      });
    if (this->Links.size() > 1)
    {
      this->AddConstants(firstTriangle);
    }
    return std::move(this->Values);
  }

private:
  std::pair<int, int> RangeOf(std::size_t part) const
  {
    return PartRange(this->Topology.TriangleCount(), part, this->Links.size());
  }

  /// Breadth-first search. Each triangle is entered once, through an edge with known values, and
  /// these are continued to its other two edges.
  void IntegrateComponent(
    std::size_t part, int firstTriangle, int firstEdge, const Eigen::VectorXd& firstValues)
  {
    const int component = this->ComponentCounts[part]++;
    struct Entry
    {
      int triangle;
      int edge;
    };
    std::vector<Entry> queue = { { firstTriangle, firstEdge } };
    const auto isLink = [&](int edge)
    {
      const auto& beside = this->Edges.triangles[edge];
      return beside[1] >= 0 && this->PartOf[beside[0]] != this->PartOf[beside[1]];
    };
    const auto reach = [&](int triangle, int edge, const Eigen::VectorXd& values)
    {
      const auto& beside = this->Edges.triangles[edge];
      if (isLink(edge))
      {
        this->Links[part].push_back({ edge, component, values });
        if (beside[0] == triangle)
        {
          this->Values.col(edge) = values;
        }
        return;
      }
      this->Known[edge] = 1;
      this->Values.col(edge) = values;
      for (const int t : beside)
      {
        if (t >= 0 && this->ComponentOf[t] < 0)
        {
          queue.push_back({ t, edge });
        }
      }
    };
    reach(firstTriangle, firstEdge, firstValues);
    Eigen::VectorXd from = firstValues;
    Eigen::VectorXd to(this->Functions);
    for (std::size_t next = 0; next < queue.size(); ++next)
    {
      const auto [t, edge] = queue[next];
      if (this->ComponentOf[t] >= 0)
      {
        continue;
      }
      this->ComponentOf[t] = component;
      if (next > 0)
      {
        from = this->Values.col(edge);
      }
      const int i = this->Edges.SideOf(t, edge);
      for (const int other : { (i + 1) % 3, (i + 2) % 3 })
      {
        const int toEdge = this->Topology.EdgeOf(t, other);
        if (this->Known[toEdge] == 0)
        {
          this->Step(t, i, other, from, to);
          reach(t, toEdge, to);
        }
      }
    }
  }

  /// Continues values from the midpoint of one edge of a triangle to that of another.
  void Step(int t, int i, int other, const Eigen::VectorXd& from, Eigen::VectorXd& to) const
  {
    const Point start = this->Topology.MiddleOf(t, i);
    const Point end = this->Topology.MiddleOf(t, other);
    const double turn =
      SumOfTurns(this->Logs.data(), this->Logs.data() + this->Logs.size(), start, end);
    for (Eigen::Index c = 0; c < this->Functions; ++c)
    {
      // rot g · Δ = g × Δ
      to[c] = from[c] + Cross(this->Gradients.block<2, 1>(2 * c, t), end - start) + turn;
    }
  }

  /// Adds the constants of all components, from that of the first triangle on.
  void AddConstants(int firstTriangle)
  {
    std::vector<int> firsts = { 0 }; // first component of each part
    for (const int count : this->ComponentCounts)
    {
      firsts.push_back(firsts.back() + count);
    }
    const auto componentOf = [&](int triangle)
    {
      const auto t = static_cast<std::size_t>(triangle);
      return firsts[this->PartOf[t]] + this->ComponentOf[t];
    };
    struct Difference
    {
      int component;
      Eigen::VectorXd values;
    };
    std::vector<std::vector<Difference>> differences(static_cast<std::size_t>(firsts.back()));
    std::map<int, std::pair<int, const Eigen::VectorXd*>> firstSides; // of links, by edge
    for (std::size_t part = 0; part < this->Links.size(); ++part)
    {
      for (const LinkValue& link : this->Links[part])
      {
        const int here = firsts[part] + link.component;
        const auto [side, isFirst] = firstSides.insert({ link.edge, { here, &link.values } });
        if (!isFirst)
        {
          const auto& [there, values] = side->second;
          differences[there].push_back({ here, *values - link.values });
          differences[here].push_back({ there, link.values - *values });
        }
      }
    }
    Eigen::MatrixXd constants = Eigen::MatrixXd::Zero(this->Functions, firsts.back());
    std::vector<char> isFound(static_cast<std::size_t>(firsts.back()), 0);
    std::vector<int> queue = { componentOf(firstTriangle) };
    isFound[queue[0]] = 1;
    for (std::size_t next = 0; next < queue.size(); ++next)
    {
      for (const Difference& difference : differences[queue[next]])
      {
        char& found = isFound[difference.component];
        if (found == 0)
        {
          found = 1;
          constants.col(difference.component) = constants.col(queue[next]) + difference.values;
          queue.push_back(difference.component);
        }
      }
    }
    ForRanges(this->Values.cols(),
      [&](int begin, int end)
      {
        for (int e = begin; e < end; ++e)
        {
          this->Values.col(e) += constants.col(componentOf(this->Edges.triangles[e][0]));
        }
      });
  }

  const MeshTopology& Topology;
  const EdgeNumbering& Edges;
  const Eigen::MatrixXd& Gradients;
  const std::vector<LogSource>& Logs;
  const Eigen::Index Functions;
  std::vector<std::uint8_t> PartOf;          ///< Of each triangle.
  std::vector<std::vector<LinkValue>> Links; ///< Of each part.
  std::vector<int> ComponentOf;              ///< Of each triangle, in its part.
  std::vector<int> ComponentCounts;          ///< Of each part.
  std::vector<char> Known;                   ///< Edges inside of a part with values.
  Eigen::MatrixXd Values;
};
}

Eigen::MatrixXd IntegrateConjugate(const MeshTopology& topology, const Eigen::MatrixXd& gradients,
  int firstEdge, const Eigen::VectorXd& firstValues, const std::vector<LogSource>& logs)
{
  return PartwiseIntegral(topology, gradients, logs).Integrate(firstEdge, firstValues);
}

double GradientEnergy(const MeshTopology& topology, const Eigen::MatrixXd& gradients)
{
  return SumOfRanges(topology.TriangleCount(),
    [&](int begin, int end)
    {
      double energy = 0.0;
      for (int t = begin; t < end; ++t)
      {
        energy += 0.5 * topology.AreaOf(t) * gradients.col(t).squaredNorm();
      }
      return energy;
    });
}
}
