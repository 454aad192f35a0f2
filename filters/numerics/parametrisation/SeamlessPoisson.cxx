#include "SeamlessPoisson.h"

#include "DissectedCholesky.h"
#include "Error.h"
#include "Index.h"
#include "P1Laplacian.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <limits>

namespace crossfield
{
namespace
{
using Complex = std::complex<double>;

/// Values at the corners of a triangle of a function with the derivative wanted: that at the centre,
/// times (ζ / ζ_c)^{−d/4} near a logarithm d log|ζ|, whose singular part the map then has exactly.
std::array<Complex, 3> LocalPrimitive(
  const std::array<Point, 3>& corners, Complex derivative, const LogSource* log)
{
  std::array<Complex, 3> values;
  const Point centre = (corners[0] + corners[1] + corners[2]) / 3.0;
  const auto complex = [](const Point& point) { return Complex(point.x(), point.y()); };
  for (std::size_t i = 0; i < 3; ++i)
  {
    if (log == nullptr)
    {
      values[i] = derivative * complex(corners[i] - corners[0]);
      continue;
    }
    const double power = 1.0 - 0.25 * log->strength;
    const Complex toCentre = complex(centre - log->position);
    const Complex ratio = complex(corners[i] - log->position) / toCentre;
    values[i] = ratio == 0.0 ? 0.0 : derivative * toCentre / power * std::pow(ratio, power);
  }
  return values;
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
  // Where sizes differ by more than 1e4 the smaller ones count as if they did not: with the range of
  // doubles used up by the weights, rounding would turn triangles over (docs/method.md §12.3).
  constexpr double SmallestPart = 1e-8;
  const double leastWeight = SmallestPart * std::exp(2.0 * frames.h.maxCoeff());
  auto near = frames.near.begin();
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
  {
    const auto here = static_cast<Eigen::Index>(t);
    const double weight = std::max(std::exp(2.0 * frames.h[here]), leastWeight);
    const Eigen::Matrix3d element = weight * P1ElementStiffness(mesh, t);
    const auto& v = mesh.triangles[t];
    const Complex derivative = std::polar(std::exp(-frames.h[here]), -frames.angle[here]);
    const LogSource* log = nullptr;
    if (near != frames.near.end() && near->triangle == static_cast<int>(t))
    {
      log = &near->log;
      ++near;
    }
    const std::array<Complex, 3> values = LocalPrimitive(
      { map.topology->PointAt(v[0]), map.topology->PointAt(v[1]), map.topology->PointAt(v[2]) },
      derivative, log);
    Eigen::Matrix<double, 3, 2> wanted;
    for (Eigen::Index i = 0; i < 3; ++i)
    {
      const Complex value = values[static_cast<std::size_t>(i)];
      wanted.row(i) << value.real(), value.imag();
    }
    problem.weights.push_back(weight);
    problem.wanted.push_back(wanted);
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

Eigen::MatrixX2d SeamlessPoisson::Residual(
  const FlatMap& map, const Eigen::VectorXd& unknowns) const
{
  const TriangleMesh& mesh = map.topology->mesh;
  Eigen::MatrixX2d residual = Eigen::MatrixX2d::Zero(this->sources.rows(), 2);
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
  {
    const auto& corners = map.corners[t];
    Eigen::Matrix<double, 3, 2> off = Eigen::Matrix<double, 3, 2>::Zero();
    for (int i = 1; i < 3; ++i)
    {
      off.row(i) = (this->wanted[t].row(i) - this->wanted[t].row(0)) -
        (unknowns.segment<2>(2 * corners[Index(i)]) - unknowns.segment<2>(2 * corners[0]))
          .transpose();
    }
    const Eigen::Matrix<double, 3, 2> flux = this->weights[t] * (P1ElementStiffness(mesh, t) * off);
    for (int i = 0; i < 3; ++i)
    {
      residual.row(corners[Index(i)]) += flux.row(i);
    }
  }
  return residual;
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
  // 1. The matrix for u and v in turn, in terms of the free unknowns: nearly all are free themselves, so every entry is
  // put where it belongs at once.
  using Rows = Eigen::SparseMatrix<double, Eigen::RowMajor>;
  const Eigen::Index all = prolongation.rows();
  const Eigen::Index freeCount = prolongation.cols();
  Eigen::VectorXd sources = Eigen::VectorXd::Zero(freeCount);
  std::vector<Eigen::Triplet<double>> entries;
  entries.reserve(2 * static_cast<std::size_t>(poisson.matrix.nonZeros()));
  for (Eigen::Index column = 0; column < poisson.matrix.cols(); ++column)
  {
    for (Eigen::Index part = 0; part < 2; ++part)
    {
      for (Rows::InnerIterator j(prolongation, 2 * column + part); j; ++j)
      {
        sources[j.col()] += j.value() * poisson.sources(column, part);
        for (Eigen::SparseMatrix<double>::InnerIterator entry(poisson.matrix, column); entry;
             ++entry)
        {
          for (Rows::InnerIterator i(prolongation, 2 * entry.row() + part); i; ++i)
          {
            entries.emplace_back(static_cast<int>(i.col()), static_cast<int>(j.col()),
              i.value() * entry.value() * j.value());
          }
        }
      }
    }
  }
  Eigen::SparseMatrix<double> matrix(freeCount, freeCount);
  matrix.setFromTriplets(entries.begin(), entries.end());
  entries = {};
  const Eigen::SparseMatrix<double> columns = prolongation;

  // 2. Unknowns that many others depend on come last. The two of one vertex that none depends on are
  // the origin, which is free.
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
  // u and v of a vertex.
  std::vector<int> partners(static_cast<std::size_t>(freeCount), -1);
  for (std::size_t vertex = 0; vertex < map.original.size(); ++vertex)
  {
    const int u = columnOf[2 * vertex];
    const int v = columnOf[2 * vertex + 1];
    if (u >= 0 && v >= 0)
    {
      partners[Index(u)] = v;
      partners[Index(v)] = u;
    }
  }
  const DissectedCholesky factor(matrix, places, trailing, ground, progress, partners);
  const auto solve = [&](const Eigen::VectorXd& freeSources) {
    return Eigen::VectorXd(prolongation * factor.Substitute(factor.Eliminate(freeSources)).col(0));
  };
  Eigen::VectorXd w = solve(sources);

  // 3. Iterative refinement: the first solve is off by rounding times the range of the weights, 1e-2 of the extent for hundreds
  // of random singularities. A correction by the part c leaves an error of about c² (docs/method.md §12.3).
  constexpr double NegligibleSquared = 1e-8;
  constexpr int MostCorrections = 5;
  double largest = std::numeric_limits<double>::infinity();
  for (int i = 0; i < MostCorrections; ++i)
  {
    const Eigen::MatrixX2d residual = poisson.Residual(map, w);
    Eigen::VectorXd full = Eigen::VectorXd::Zero(all);
    for (Eigen::Index vertex = 0; vertex < residual.rows(); ++vertex)
    {
      full.segment<2>(2 * vertex) = residual.row(vertex).transpose();
    }
    const Eigen::VectorXd correction = solve(prolongation.transpose() * full);
    const double part = correction.lpNorm<Eigen::Infinity>() / w.lpNorm<Eigen::Infinity>();
    if (!(part < largest))
    {
      break; // rounding is reached, or the map is told not to be injective
    }
    w += correction;
    largest = part;
    if (part <= NegligibleSquared)
    {
      break;
    }
  }
  return w;
}
}
