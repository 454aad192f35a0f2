/**
 * Seconds of every stage up to the field on the unit disk with eight holes, at 10,000, 100,000,
 * 1,000,000 and 4,000,000 triangles, and of complete runs at 10,000,000. For comparison the same
 * run measures, up to 1,000,000, a bare CHOLMOD factorisation (supernodal, AMD: analyse, factor,
 * two solves) of the scalar Crouzeix-Raviart matrix of the same mesh. `of_bare` is the ratio to it,
 * `growth` the exponent from the next smaller size. BenchQuads.cxx measures the stages from the map
 * to quads.
 *
 *   build/bin/benchStages
 */
#include "BenchDisk.h"
#include "BuiltinDomains.h"
#include "CrouzeixRaviart.h"
#include "DrillHoles.h"
#include "HField.h"
#include "MakePlanarDomain.h"
#include "PerforatedSolve.h"
#include "RenormalizedEnergy.h"
#include "Stopwatch.h"

#include <benchmark/benchmark.h>
#include <cholmod.h>
#include <nlohmann/json.hpp>

#include <sys/resource.h>
#include <unistd.h>

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <string>
#include <utility>

namespace
{
using namespace crossfield;

TriangleMesh MakeMesh(std::int64_t triangles, const Configuration& holes)
{
  BuiltinDomain disk;
  disk.edgeLength = MeshSizeFor(triangles);
  DrillOptions options;
  options.meshSize = disk.edgeLength;
  return DrillHoles(MakePlanarDomain(MakeBuiltinDomain(disk)), holes, options);
}

/// Returns the mesh of a size with eight holes, or without holes for eight points; shared by all
/// benchmarks.
const TriangleMesh& MeshOf(std::int64_t triangles, bool holes = true)
{
  static std::map<std::pair<std::int64_t, bool>, TriangleMesh> meshes;
  auto found = meshes.find({ triangles, holes });
  if (found == meshes.end())
  {
    found = meshes
              .emplace(std::pair(triangles, holes),
                MakeMesh(triangles, holes ? EightHoles() : Configuration()))
              .first;
  }
  return found->second;
}

/// Seconds of a row by its requested size.
using Row = std::map<std::int64_t, double>;

/// Returns the seconds of the bare factorisation in this run, with holes or without.
Row& BareSeconds(bool holes)
{
  static Row seconds[2];
  return seconds[holes ? 1 : 0];
}

/// Adds counters that compare the seconds of a row with those of the next smaller size and of the
/// factorisation alone.
void Compare(benchmark::State& state, const std::string& row, double seconds, bool holes = true)
{
  static std::map<std::string, Row> rows;
  Row& sizes = rows[row];
  const std::int64_t size = state.range(0);
  const auto next = sizes.lower_bound(size);
  if (next != sizes.begin())
  {
    const auto& [smaller, before] = *std::prev(next);
    state.counters["growth"] = std::log(seconds / before) /
      std::log(static_cast<double>(size) / static_cast<double>(smaller));
  }
  sizes[size] = seconds;
  const auto bare = BareSeconds(holes).find(size);
  if (bare != BareSeconds(holes).end())
  {
    state.counters["of_bare"] = seconds / bare->second;
  }
}

void Mesh(benchmark::State& state)
{
  for (auto _ : state)
  {
    Stopwatch stopwatch;
    const TriangleMesh mesh = MakeMesh(state.range(0), EightHoles());
    Compare(state, "mesh", stopwatch.Lap());
    state.counters["triangles"] = static_cast<double>(mesh.triangles.size());
  }
}

/// Factors the matrix of the free unknowns as an implementation of the paper would. Returns the
/// seconds.
double FactorBare(benchmark::State& state, const TriangleMesh& mesh)
{
  const EdgeNumbering edges = NumberEdges(mesh);
  std::vector<int> number(static_cast<std::size_t>(edges.Count()), 0);
  for (std::size_t i = 0; i < mesh.boundary.size(); ++i)
  {
    if (mesh.boundary[i].kind != BoundaryKind::Hole)
    {
      number[static_cast<std::size_t>(edges.ofBoundary[i])] = -1;
    }
  }
  int count = 0;
  for (int& n : number)
  {
    n = n < 0 ? -1 : count++;
  }
  const SparseMatrix all = CrouzeixRaviartStiffness(mesh, edges);
  std::vector<Eigen::Triplet<double>> entries;
  for (int column = 0; column < all.outerSize(); ++column)
  {
    for (SparseMatrix::InnerIterator entry(all, column); entry; ++entry)
    {
      const int i = number[static_cast<std::size_t>(entry.row())];
      const int j = number[static_cast<std::size_t>(column)];
      if (i >= j && j >= 0)
      {
        entries.emplace_back(i, j, entry.value());
      }
    }
  }
  SparseMatrix matrix(count, count);
  matrix.setFromTriplets(entries.begin(), entries.end());
  double seconds = 0.0;
  for (auto _ : state)
  {
    Stopwatch stopwatch;
    cholmod_common common;
    cholmod_start(&common);
    common.supernodal = CHOLMOD_SUPERNODAL;
    common.nmethods = 1;
    common.method[0].ordering = CHOLMOD_AMD;
    cholmod_sparse view = {};
    view.nrow = view.ncol = static_cast<std::size_t>(count);
    view.nzmax = static_cast<std::size_t>(matrix.nonZeros());
    view.p = matrix.outerIndexPtr();
    view.i = matrix.innerIndexPtr();
    view.x = matrix.valuePtr();
    view.stype = -1;
    view.itype = CHOLMOD_INT;
    view.xtype = CHOLMOD_REAL;
    view.dtype = CHOLMOD_DOUBLE;
    view.sorted = view.packed = 1;
    cholmod_factor* factor = cholmod_analyze(&view, &common);
    cholmod_factorize(&view, factor, &common);
    cholmod_dense* right = cholmod_ones(view.nrow, 2, CHOLMOD_REAL, &common);
    cholmod_dense* solution = cholmod_solve(CHOLMOD_A, factor, right, &common);
    benchmark::DoNotOptimize(solution->x);
    cholmod_free_dense(&solution, &common);
    cholmod_free_dense(&right, &common);
    cholmod_free_factor(&factor, &common);
    cholmod_finish(&common);
    seconds = stopwatch.Lap();
  }
  return seconds;
}

void BareCholmod(benchmark::State& state)
{
  BareSeconds(true)[state.range(0)] = FactorBare(state, MeshOf(state.range(0)));
}

/// Measures the same on the mesh without holes, for comparison with SolveH and
/// FurtherConfiguration.
void BareCholmodWithoutHoles(benchmark::State& state)
{
  BareSeconds(false)[state.range(0)] = FactorBare(state, MeshOf(state.range(0), false));
}

/// Measures H, its cross field and W of eight points. The time of the row is factor + solve.
void SolveH(benchmark::State& state)
{
  const TriangleMesh& mesh = MeshOf(state.range(0), false);
  for (auto _ : state)
  {
    const HField result = SolveHField(ShareTopology(mesh), EightHoles());
    const StageSeconds& seconds = result.field.seconds;
    state.SetIterationTime(seconds.factor + seconds.solve);
    Compare(state, "h", seconds.factor + seconds.solve, false);
    state.counters["assemble"] = seconds.assemble;
    state.counters["factor"] = seconds.factor;
    state.counters["solve"] = seconds.solve;
    state.counters["wrong"] = result.field.unwantedSingularities;
  }
}

/// Measures W and its gradient of a further configuration on a factored mesh.
void FurtherConfiguration(benchmark::State& state)
{
  const auto solver =
    std::make_shared<const PotentialSolver>(ShareTopology(MeshOf(state.range(0), false)));
  const PointPotential potential(solver, AlignWithBoundary(solver->GetTopology(), {}, 4));
  solver->GetDirichlet(); // the second factor of W, which the first configuration computes
  for (auto _ : state)
  {
    auto value = EvaluateRenormalizedEnergy(potential, potential.Solve(EightHoles()));
    benchmark::DoNotOptimize(value.energy);
  }
}

/// Measures a solve. The time of the row is factor + solve; assembling has its own counter.
void Solve(benchmark::State& state, PerforatedMethod method)
{
  const TriangleMesh& mesh = MeshOf(state.range(0));
  PerforatedOptions options;
  options.method = method;
  for (auto _ : state)
  {
    const SolvedField field = SolvePerforated(ShareTopology(mesh), options);
    state.SetIterationTime(field.seconds.factor + field.seconds.solve);
    Compare(state, method == PerforatedMethod::UnitNorm ? "unit norm" : "constrained",
      field.seconds.factor + field.seconds.solve);
    state.counters["assemble"] = field.seconds.assemble;
    state.counters["factor"] = field.seconds.factor;
    state.counters["solve"] = field.seconds.solve;
    state.counters["newton"] = field.seconds.newton;
    state.counters["iterations"] = field.iterations;
    state.counters["wrong"] = field.wrongDegrees + (field.converged ? 0 : 1);
  }
}

/// Returns holes of 32 edges and radius 0.01 on the unit disk, with alternating signs, on a spiral
/// of equal areas; the last ones complete the sum of four.
Configuration Spiral(std::int64_t count)
{
  Configuration configuration;
  std::int64_t missing = 4;
  for (std::int64_t i = 0; i < count; ++i)
  {
    const double angle = static_cast<double>(i) * Pi * (3.0 - std::sqrt(5.0));
    const double radius =
      0.9 * std::sqrt((static_cast<double>(i) + 0.5) / static_cast<double>(count));
    const int index = missing == count - i || i % 2 == 0 ? 1 : -1;
    missing -= index;
    configuration.push_back({ radius * Point(std::cos(angle), std::sin(angle)), index, 0.01 });
  }
  return configuration;
}

/// Measures the constrained method by the number of holes, on about 100,000 triangles: the global
/// minimum (`newton`), and the total of the default start. The time of the row is factor + solve.
void ManyHoles(benchmark::State& state, PerforatedStart start)
{
  const TriangleMesh mesh = MakeMesh(100000, Spiral(state.range(0)));
  PerforatedOptions options;
  options.start = start;
  for (auto _ : state)
  {
    const SolvedField field = SolvePerforated(ShareTopology(mesh), options);
    state.SetIterationTime(field.seconds.factor + field.seconds.solve);
    state.counters["triangles"] = static_cast<double>(mesh.triangles.size());
    state.counters["factor"] = field.seconds.factor;
    state.counters["solve"] = field.seconds.solve;
    state.counters["newton"] = field.seconds.newton;
    state.counters["iterations"] = field.iterations;
    state.counters["energy"] = field.energy;
    state.counters["converged"] = field.converged ? 1 : 0;
  }
}

/// Returns the processor seconds of the child processes that have ended.
double ChildrenSeconds()
{
  rusage usage = {};
  getrusage(RUSAGE_CHILDREN, &usage);
  const auto seconds = [](const timeval& time)
  { return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec); };
  return seconds(usage.ru_utime) + seconds(usage.ru_stime);
}

/// Measures whole runs of the program up to the .vtu on disk, with a choice of arrays.
void WholeRun(benchmark::State& state, const char* arrays)
{
  const std::string folder = "/tmp/crossfield-bench-" + std::to_string(getpid());
  const std::string csv = folder + ".csv";
  const std::string vtu = folder + ".vtu";
  const std::string json = folder + ".json";
  std::ofstream stream(csv);
  stream.precision(17);
  stream << "x,y,quarter_index,radius\n";
  for (const Singularity& singularity : EightHoles())
  {
    stream << singularity.position.x() << "," << singularity.position.y() << ","
           << singularity.quarterIndex << "," << singularity.radius << "\n";
  }
  stream.close();
  const std::string command = std::string(CROSSFIELD_PROGRAM) + " solve builtin:disk -s " + csv +
    " --size " + std::to_string(MeshSizeFor(state.range(0))) + " -o " + vtu + " --json " + json +
    " --arrays " + arrays;
  for (auto _ : state)
  {
    const double before = ChildrenSeconds();
    Stopwatch stopwatch;
    if (std::system(command.c_str()) != 0)
    {
      state.SkipWithError("the program failed");
      break;
    }
    Compare(state, arrays, stopwatch.Lap());
    state.counters["processor"] = ChildrenSeconds() - before;
    state.counters["file_MB"] = 1e-6 * static_cast<double>(std::filesystem::file_size(vtu));
    std::ifstream report(json);
    state.counters["write"] = nlohmann::json::parse(report)["seconds"]["write"].get<double>();
  }
  rusage usage = {};
  getrusage(RUSAGE_CHILDREN, &usage);
  state.counters["peak_GiB"] = static_cast<double>(usage.ru_maxrss) / (1024.0 * 1024.0);
  std::remove(csv.c_str());
  std::remove(vtu.c_str());
  std::remove(json.c_str());
}

/// Sets sizes up to four million triangles; the last size needs 3 GiB.
void SizesToFourMillion(benchmark::internal::Benchmark* benchmark)
{
  benchmark->Apply(Sizes)->Arg(4000000);
}

void HoleCounts(benchmark::internal::Benchmark* benchmark)
{
  for (const std::int64_t count : { 4, 16, 36, 64, 100, 300 })
  {
    benchmark->Arg(count);
  }
  benchmark->Unit(benchmark::kMillisecond)->Iterations(1)->MeasureProcessCPUTime()->UseManualTime();
}

BENCHMARK(Mesh)->Apply(SizesToFourMillion)->UseRealTime();
BENCHMARK(BareCholmod)->Apply(Sizes)->UseRealTime();
BENCHMARK_CAPTURE(Solve, Constrained, PerforatedMethod::Constrained)
  ->Apply(SizesToFourMillion)
  ->UseManualTime();
BENCHMARK_CAPTURE(Solve, UnitNorm, PerforatedMethod::UnitNorm)
  ->Apply(SizesToFourMillion)
  ->UseManualTime();
BENCHMARK(BareCholmodWithoutHoles)->Apply(Sizes)->UseRealTime();
BENCHMARK(SolveH)->Apply(SizesToFourMillion)->MeasureProcessCPUTime()->UseManualTime();
BENCHMARK(FurtherConfiguration)->Apply(Sizes)->UseRealTime();
BENCHMARK_CAPTURE(ManyHoles, Harmonic, PerforatedStart::Harmonic)->Apply(HoleCounts);
BENCHMARK_CAPTURE(ManyHoles, Best, PerforatedStart::Best)->Apply(HoleCounts);
// Ten million triangles take 7 GiB.
BENCHMARK_CAPTURE(WholeRun, All, "all")->Apply(Sizes)->UseRealTime();
BENCHMARK_CAPTURE(WholeRun, Display, "display")
  ->Apply(SizesToFourMillion)
  ->Arg(10000000)
  ->UseRealTime();
BENCHMARK_CAPTURE(WholeRun, Exact, "exact")->Apply(Sizes)->UseRealTime();
}
