#include "SeamlessPoisson.h"

#include "DissectedCholesky.h"
#include "Error.h"
#include "P1Laplacian.h"

#include <cmath>

namespace crossfield
{
namespace
{
std::size_t Index(int i)
{
  return static_cast<std::size_t>(i);
}
}

SeamlessPoisson AssemblePoisson(const FlatMap& map, const TriangleFrames& frames)
{
  const TriangleMesh& mesh = map.topology->mesh;
  const auto count = static_cast<Eigen::Index>(map.original.size());
  SeamlessPoisson problem;
  problem.sources = Eigen::MatrixX2d::Zero(count, 2);
  std::vector<Eigen::Triplet<double>> entries;
  entries.reserve(9 * mesh.triangles.size());
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
  {
    const auto here = static_cast<Eigen::Index>(t);
    const double weight = std::exp(2.0 * frames.h[here]);
    const Eigen::Matrix3d element = weight * P1ElementStiffness(mesh, t);
    const auto& v = mesh.triangles[t];
    // The linear function of x whose gradient is wanted: w = e^{−(H + iθ)} z.
    const double size = std::exp(-frames.h[here]);
    const double cosine = size * std::cos(frames.angle[here]);
    const double sine = size * std::sin(frames.angle[here]);
    Eigen::Matrix<double, 3, 2> wanted;
    for (int i = 0; i < 3; ++i)
    {
      const Point z = map.topology->PointAt(v[Index(i)]) - map.topology->PointAt(v[0]);
      wanted.row(i) << cosine * z.x() + sine * z.y(), cosine * z.y() - sine * z.x();
    }
    const Eigen::Matrix<double, 3, 2> flux = element * wanted;
    problem.constant += wanted.cwiseProduct(flux).sum();
    for (int i = 0; i < 3; ++i)
    {
      const int row = map.corners[t][Index(i)];
      problem.sources.row(row) += flux.row(i);
      for (int j = 0; j < 3; ++j)
      {
        entries.emplace_back(row, map.corners[t][Index(j)], element(i, j));
      }
    }
  }
  problem.matrix.resize(count, count);
  problem.matrix.setFromTriplets(entries.begin(), entries.end());
  return problem;
}

double SeamlessPoisson::Misfit(const Eigen::VectorXd& unknowns) const
{
  double misfit = this->constant;
  for (Eigen::Index part = 0; part < 2; ++part)
  {
    const Eigen::VectorXd values = Eigen::Map<const Eigen::VectorXd, 0, Eigen::InnerStride<2>>(
      unknowns.data() + part, this->matrix.cols());
    misfit += values.dot(this->matrix * values) - 2.0 * values.dot(this->sources.col(part));
  }
  return misfit;
}

Eigen::VectorXd SolveSeamless(const FlatMap& map, const SeamlessPoisson& poisson,
  const Eigen::SparseMatrix<double, Eigen::RowMajor>& prolongation, const Progress& progress)
{
  // 1. The matrix for u and v in turn, in terms of the free unknowns.
  std::vector<Eigen::Triplet<double>> entries;
  entries.reserve(2 * static_cast<std::size_t>(poisson.matrix.nonZeros()));
  const Eigen::Index all = prolongation.rows();
  Eigen::VectorXd sources = Eigen::VectorXd::Zero(all);
  for (Eigen::Index column = 0; column < poisson.matrix.cols(); ++column)
  {
    const auto c = static_cast<int>(column);
    for (int part = 0; part < 2; ++part)
    {
      sources[2 * c + part] = poisson.sources(c, part);
      for (Eigen::SparseMatrix<double>::InnerIterator entry(poisson.matrix, column); entry; ++entry)
      {
        entries.emplace_back(
          2 * static_cast<int>(entry.row()) + part, 2 * c + part, entry.value());
      }
    }
  }
  Eigen::SparseMatrix<double> both(all, all);
  both.setFromTriplets(entries.begin(), entries.end());
  entries = {};
  const Eigen::SparseMatrix<double> columns = prolongation;
  const Eigen::SparseMatrix<double> transposed = columns.transpose();
  const Eigen::SparseMatrix<double> matrix = transposed * Eigen::SparseMatrix<double>(both * columns);

  // 2. Unknowns that many others depend on come last. The two of one vertex that none depends on are
  // the origin, which is free.
  const Eigen::Index freeCount = columns.cols();
  std::vector<Point> places(static_cast<std::size_t>(freeCount), Point::Zero());
  std::vector<int> trailing;
  std::vector<int> ground;
  // A vertex in a chain has its copy beside it.
  constexpr int ManyDependents = 4;
  const auto dependents = [&columns](Eigen::Index j)
  { return columns.outerIndexPtr()[j + 1] - columns.outerIndexPtr()[j]; };
  std::vector<int> columnOf(static_cast<std::size_t>(all), -1);
  for (Eigen::Index j = 0; j < freeCount; ++j)
  {
    for (Eigen::SparseMatrix<double>::InnerIterator entry(columns, j); entry; ++entry)
    {
      const auto vertex = static_cast<std::size_t>(entry.row()) / 2;
      if (vertex < map.original.size())
      {
        places[static_cast<std::size_t>(j)] = map.topology->PointAt(map.original[vertex]);
        columnOf[static_cast<std::size_t>(entry.row())] =
          dependents(j) == 1 ? static_cast<int>(j) : -1;
        break;
      }
    }
    if (dependents(j) > ManyDependents)
    {
      trailing.push_back(static_cast<int>(j));
    }
  }
  for (std::size_t vertex = 0; vertex < map.original.size() && ground.empty(); ++vertex)
  {
    if (columnOf[2 * vertex] >= 0 && columnOf[2 * vertex + 1] >= 0)
    {
      ground = { columnOf[2 * vertex], columnOf[2 * vertex + 1] };
    }
  }
  if (ground.empty())
  {
    throw Error("The mesh is too coarse for a flat map: no vertex is off the seams and the "
                "boundary; use a finer mesh.");
  }
  const DissectedCholesky factor(matrix, places, trailing, ground, progress);
  return prolongation * factor.Substitute(factor.Eliminate(transposed * sources)).col(0);
}
}
