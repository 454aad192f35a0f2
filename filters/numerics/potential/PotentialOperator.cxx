#include "PotentialOperator.h"

#include "P1Laplacian.h"
#include "Parts.h"

#include <algorithm>
#include <utility>

namespace crossfield
{
PotentialOperator::PotentialOperator(SharedTopology topology)
  : Topology(std::move(topology))
  , IslandCount(static_cast<Eigen::Index>(this->Topology->cycles.size()) -
      this->Topology->LoopCount(BoundaryKind::Hole))
{
}

Eigen::SparseMatrix<double> PotentialOperator::Assemble() const
{
  const TriangleMesh& mesh = this->Topology->mesh;
  const std::vector<Cycle>& cycles = this->Topology->cycles;
  const Eigen::SparseMatrix<double> stiffness = P1Stiffness(*this->Topology);
  if (cycles.empty())
  {
    return stiffness;
  }
  const Eigen::Index vertexCount = stiffness.rows();
  const auto size = vertexCount + static_cast<Eigen::Index>(cycles.size());
  std::vector<Eigen::Triplet<double>> border;
  for (std::size_t k = 0; k < cycles.size(); ++k)
  {
    const auto row = static_cast<int>(vertexCount + static_cast<Eigen::Index>(k));
    // K_T η_k on the triangles of its strip, sorted to find where other strips overlap.
    std::vector<std::pair<int, Eigen::Vector3d>> products;
    for (const Cycle::Step& step : cycles[k].steps)
    {
      const Eigen::Vector3d product =
        P1ElementStiffness(this->Topology->ChartOf(step.triangle)) * step.Left();
      products.emplace_back(step.triangle, product);
      for (std::size_t i = 0; i < 3; ++i)
      {
        const int vertex = mesh.triangles[step.triangle][i];
        border.emplace_back(vertex, row, product[static_cast<Eigen::Index>(i)]);
        border.emplace_back(row, vertex, product[static_cast<Eigen::Index>(i)]);
      }
    }
    std::sort(products.begin(), products.end(),
      [](const auto& a, const auto& b) { return a.first < b.first; });
    for (std::size_t l = 0; l < cycles.size(); ++l)
    {
      for (const Cycle::Step& step : cycles[l].steps)
      {
        const auto found = std::lower_bound(products.begin(), products.end(), step.triangle,
          [](const auto& entry, int triangle) { return entry.first < triangle; });
        if (found != products.end() && found->first == step.triangle)
        {
          border.emplace_back(static_cast<int>(vertexCount + static_cast<Eigen::Index>(l)), row,
            found->second.dot(step.Left()));
        }
      }
    }
  }
  std::stable_sort(border.begin(), border.end(),
    [](const auto& a, const auto& b)
    { return a.col() < b.col() || (a.col() == b.col() && a.row() < b.row()); });

  // The rows of periods come last in every column.
  Eigen::SparseMatrix<double> matrix(size, size);
  int* const starts = matrix.outerIndexPtr();
  std::fill(starts, starts + size + 1, 0);
  std::vector<Eigen::Triplet<double>> merged;
  for (const Eigen::Triplet<double>& entry : border)
  {
    if (!merged.empty() && merged.back().col() == entry.col() && merged.back().row() == entry.row())
    {
      merged.back() = { entry.row(), entry.col(), merged.back().value() + entry.value() };
      continue;
    }
    merged.push_back(entry);
    ++starts[entry.col() + 1];
  }
  const int* const before = stiffness.outerIndexPtr();
  for (Eigen::Index column = 0; column < size; ++column)
  {
    starts[column + 1] +=
      starts[column] + (column < vertexCount ? before[column + 1] - before[column] : 0);
  }
  matrix.resizeNonZeros(starts[size]);
  ForRanges(vertexCount,
    [&](int begin, int end)
    {
      for (int column = begin; column < end; ++column)
      {
        const int count = before[column + 1] - before[column];
        std::copy_n(stiffness.innerIndexPtr() + before[column], count,
          matrix.innerIndexPtr() + starts[column]);
        std::copy_n(
          stiffness.valuePtr() + before[column], count, matrix.valuePtr() + starts[column]);
      }
    });
  for (auto entry = merged.rbegin(), last = entry; entry != merged.rend(); ++entry)
  {
    // From the end of each column.
    last = last->col() == entry->col() ? last : entry;
    const auto place = starts[entry->col() + 1] - 1 - static_cast<int>(entry - last);
    matrix.innerIndexPtr()[place] = entry->row();
    matrix.valuePtr()[place] = entry->value();
  }
  return matrix;
}

Eigen::MatrixXd PotentialOperator::Gradient(const Eigen::MatrixXd& potentials) const
{
  const auto gradientOf = [this](int t, double f0, double f1, double f2) -> Point
  {
    const Point& p0 = this->Topology->At(t, 0);
    const Point a = this->Topology->At(t, 1) - p0;
    const Point b = this->Topology->At(t, 2) - p0;
    const double da = f1 - f0;
    const double db = f2 - f0;
    return Point(da * b.y() - db * a.y(), db * a.x() - da * b.x()) / Cross(a, b);
  };
  Eigen::MatrixXd gradient(
    2 * potentials.cols(), static_cast<Eigen::Index>(this->Topology->mesh.triangles.size()));
  ForRanges(gradient.cols(),
    [&](int begin, int end)
    {
      for (int t = begin; t < end; ++t)
      {
        const auto& v = this->Topology->mesh.triangles[t];
        for (Eigen::Index c = 0; c < potentials.cols(); ++c)
        {
          gradient.block<2, 1>(2 * c, t) =
            gradientOf(t, potentials(v[0], c), potentials(v[1], c), potentials(v[2], c));
        }
      }
    });
  for (Eigen::Index k = 0; k < this->PeriodCount(); ++k)
  {
    for (const Cycle::Step& step : this->Topology->cycles[k].steps)
    {
      const Eigen::Vector3d left = step.Left();
      const Point cut = gradientOf(step.triangle, left[0], left[1], left[2]);
      for (Eigen::Index c = 0; c < potentials.cols(); ++c)
      {
        gradient.block<2, 1>(2 * c, step.triangle) += potentials(this->PeriodRow(k), c) * cut;
      }
    }
  }
  return gradient;
}

Eigen::VectorXd PotentialOperator::Apply(const Eigen::VectorXd& potential) const
{
  const Eigen::Matrix2Xd gradient = this->Gradient(potential);
  Eigen::VectorXd sources = Eigen::VectorXd::Zero(this->Rows());
  // ∫ ∇Φ · ∇λ_i over a triangle is half the cross product of the opposite edge and the gradient.
  const auto load = [&](int t, int i)
  {
    const Point opposite = this->Topology->At(t, (i + 2) % 3) - this->Topology->At(t, (i + 1) % 3);
    return 0.5 * Cross(opposite, gradient.col(t));
  };
  for (int t = 0; t < this->Topology->TriangleCount(); ++t)
  {
    for (int i = 0; i < 3; ++i)
    {
      sources[this->Topology->mesh.triangles[t][i]] += load(t, i);
    }
  }
  for (Eigen::Index k = 0; k < this->PeriodCount(); ++k)
  {
    for (const Cycle::Step& step : this->Topology->cycles[k].steps)
    {
      const Eigen::Vector3d left = step.Left();
      for (int i = 0; i < 3; ++i)
      {
        sources[this->PeriodRow(k)] += left[i] * load(step.triangle, i);
      }
    }
  }
  return sources;
}
}
