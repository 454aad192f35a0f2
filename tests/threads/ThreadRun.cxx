/**
 * Parallel loops, the elimination of a matrix and solves with one factor, in several threads of the
 * host at once: the program for the thread sanitizer (tests/threads/run.sh). Exits with 0 if all
 * threads find the same solution. With an argument, a loop with an error, which must be reported.
 */
#include "Candidates.h"
#include "DenseCholesky.h"
#include "DissectedCholesky.h"
#include "Parts.h"
#include "SymmetricAssembly.h"

#include <omp.h>

#include <cstdio>
#include <thread>

namespace
{
using namespace crossfield;

/// Returns the five-point Laplacian plus 1/100 on a grid, and stores the grid points in `places`.
Eigen::SparseMatrix<double> Grid(int side, std::vector<SpacePoint>& places)
{
  std::vector<SymmetricEntry> entries;
  for (int i = 0; i < side * side; ++i)
  {
    places.emplace_back(i % side, i / side, 0.0);
    if ((i + 1) % side != 0)
    {
      entries.push_back({ i, i + 1, -1.0 });
    }
    if (i + side < side * side)
    {
      entries.push_back({ i, i + side, -1.0 });
    }
  }
  return AssembleSymmetric(Eigen::VectorXd::Constant(side * side, 4.01), entries);
}

/// Factors a matrix, solves with it in several threads, and returns a number that depends on all
/// solutions.
double Run()
{
  std::vector<SpacePoint> places;
  const Eigen::SparseMatrix<double> matrix = Grid(180, places);
  const DissectedCholesky factor(matrix, places, { 7, 5000, 31000 }, { 3 });
  std::vector<double> sums(3);
  std::vector<std::thread> threads;
  for (std::size_t i = 0; i < sums.size(); ++i)
  {
    threads.emplace_back(
      [&, i]
      {
        const Eigen::MatrixXd load =
          Eigen::MatrixXd::Ones(matrix.rows(), i == 0 ? 40 : static_cast<Eigen::Index>(i));
        sums[i] = factor.Substitute(factor.Eliminate(load)).squaredNorm();
      });
  }
  std::vector<Eigen::SparseMatrix<double>> blocks;
  for (int block = 0; block < 5; ++block)
  {
    blocks.emplace_back(matrix.rows(), 2);
    blocks.back().insert(3000 * block + 10, 0) = 1.0;
    blocks.back().insert(6000 * block + 20, 1) = -1.0;
    blocks.back().makeCompressed();
  }
  const auto columns = factor.EliminateSparse(blocks);
  double sum = columns.nodes.back().rows.squaredNorm();
  for (std::thread& thread : threads)
  {
    thread.join();
  }
  // A search, the candidates of which have parts themselves.
  AcceptFirst(
    9, 4,
    [](std::size_t candidate)
    {
      return SumOfRanges(30000,
        [candidate](int begin, int end) { return static_cast<double>(candidate) * (end - begin); });
    },
    [&sum](std::size_t candidate, double value)
    {
      sum += value;
      return candidate == 6;
    });
  Eigen::MatrixXd dense = Eigen::MatrixXd::Constant(900, 900, 0.5);
  dense.diagonal().array() += 3.0;
  sum += DenseCholesky<double>(dense).Inverse().squaredNorm();
  return sum + sums[0] + sums[1] + sums[2];
}

/// Adds to one number in all parts at once: the sanitizer must report it.
double Race()
{
  volatile double sum = 0.0;
  ForParts(64,
    [&](std::size_t part)
    {
      for (int i = 0; i < 100000; ++i)
      {
        sum = sum + 1e-9 * static_cast<double>(part);
      }
    });
  return sum;
}
}

int main(int count, char**)
{
  omp_set_num_threads(4);
  if (count > 1)
  {
    std::printf("sum with a race: %g\n", Race());
    return 0;
  }
  std::vector<double> results(2);
  std::vector<std::thread> hosts;
  for (double& result : results)
  {
    hosts.emplace_back([&result] { result = Run(); });
  }
  for (std::thread& host : hosts)
  {
    host.join();
  }
  const bool isEqual = results[0] == results[1] && results[0] == Run();
  std::printf("%s: %.17g\n", isEqual ? "equal" : "DIFFERENT", results[0]);
  return isEqual ? 0 : 1;
}
