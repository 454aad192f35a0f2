/**
 * Makes a domain with holes and singularities from the bytes of the fuzzer and runs every part of
 * the numerics on it: check, drill, solve by both methods, size field H and energies. Each step
 * throws crossfield::Error with a sentence, or its result has the properties that its header
 * states.
 */
#include "ConfigurationEnergy.h"
#include "CornerClassification.h"
#include "DrillHoles.h"
#include "Error.h"
#include "FieldCheck.h"
#include "HField.h"
#include "MakePlanarDomain.h"
#include "PerforatedSolve.h"
#include "PoincareHopf.h"

#include <fuzzer/FuzzedDataProvider.h>

#include <cstdio>
#include <cstdlib>
#include <functional>

namespace
{
using namespace crossfield;

void Require(bool condition, const char* what)
{
  if (!condition)
  {
    std::fprintf(stderr, "violated property: %s\n", what);
    std::abort();
  }
}

/** Returns whether the step completes; otherwise its error must be one sentence. */
bool Succeeds(const std::function<void()>& step)
{
  try
  {
    step();
    return true;
  }
  catch (const Error& error)
  {
    const std::string sentence = error.what();
    Require(sentence.size() > 20 && sentence.back() == '.', "an error is a sentence");
    Require(sentence.find('\n') == std::string::npos, "an error is one line");
    return false;
  }
}

/** Returns a multiple of 1/64, so that points often coincide or are collinear. */
double Coordinate(FuzzedDataProvider& bytes)
{
  return bytes.ConsumeIntegralInRange<int>(-64, 64) / 64.0;
}

Point Place(FuzzedDataProvider& bytes)
{
  const double x = Coordinate(bytes);
  return { x, Coordinate(bytes) };
}

/** Returns any polygon, or a star-shaped one around a centre, which does not cross itself. */
Loop Polygon(FuzzedDataProvider& bytes, const Point& centre, double radius)
{
  const bool star = bytes.ConsumeIntegralInRange<int>(0, 7) > 0;
  const int count = bytes.ConsumeIntegralInRange<int>(3, 24);
  Loop loop;
  for (int i = 0; i < count; ++i)
  {
    if (star)
    {
      const double angle = 2.0 * Pi * i / count;
      const double distance = radius * bytes.ConsumeIntegralInRange<int>(8, 64) / 64.0;
      loop.push_back(centre + distance * Point(std::cos(angle), std::sin(angle)));
    }
    else
    {
      loop.push_back(Place(bytes));
    }
  }
  return loop;
}

struct Problem
{
  std::vector<Loop> loops;
  Configuration configuration;
};

Problem MakeProblem(FuzzedDataProvider& bytes)
{
  Problem problem;
  problem.loops.push_back(Polygon(bytes, Point::Zero(), 1.0));
  for (int i = bytes.ConsumeIntegralInRange<int>(0, 2); i > 0; --i)
  {
    const Point centre = Place(bytes);
    problem.loops.push_back(Polygon(bytes, centre, 0.25));
  }
  for (int i = bytes.ConsumeIntegralInRange<int>(0, 4); i > 0; --i)
  {
    Singularity singularity;
    singularity.position = Place(bytes);
    singularity.quarterIndex = bytes.ConsumeIntegralInRange<int>(-4, 4);
    singularity.radius = bytes.ConsumeIntegralInRange<int>(1, 64) / 256.0;
    problem.configuration.push_back(singularity);
  }
  // Changes the unit and moves the domain far from the origin. Results must stay the same, or an
  // error must be thrown.
  const double scale = std::pow(10.0, bytes.ConsumeIntegralInRange<int>(-8, 8));
  const Point shift =
    scale * bytes.PickValueInArray({ 0.0, 0.0, 1.0, 1e3, 1e6, 1e9 }) * Point(1.0, 2.0);
  for (Loop& loop : problem.loops)
  {
    for (Point& point : loop)
    {
      point = scale * point + shift;
    }
  }
  for (Singularity& singularity : problem.configuration)
  {
    singularity.position = scale * singularity.position + shift;
    singularity.radius *= scale;
  }
  return problem;
}

/** Checks the degrees of holes and the sum of all indices, which both methods guarantee. */
void RequireSolved(const TriangleMesh& mesh, PerforatedMethod method)
{
  SolvedField field;
  PerforatedOptions options;
  options.method = method;
  if (!Succeeds([&] { field = SolvePerforated(ShareTopology(mesh), options); }))
  {
    return;
  }
  Require(field.u.allFinite() && std::isfinite(field.energy), "a field is finite");
  Require(field.energy >= 0.0, "the energy is not negative");
  // Inside imprinted circles other singularities may appear, which balance any sum.
  Require(field.count.Consistent() || !mesh.imprinted.empty(),
    "with holes, only consistent configurations have a field");
  if (method == PerforatedMethod::UnitNorm)
  {
    Require((field.u.cwiseAbs().array() - 1.0).abs().maxCoeff() < 1e-9, "|u| = 1");
    Require(!field.converged || field.wrongDegrees == 0, "unit norm: all degrees are correct");
  }
  for (const HoleReading& hole : field.holes)
  {
    Require(std::isfinite(hole.minimumNorm) && std::isfinite(hole.maximumNorm), "norms are finite");
  }
  if (field.converged)
  {
    FieldCheck check;
    Require(Succeeds(
              [&] {
                check = CheckField({ ShareTopology(mesh), field.u });
              }),
      "a field can be checked");
    Require(check.count.Consistent(), "the indices of a field add up to the required sum");
  }
}
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  FuzzedDataProvider bytes(data, size);
  Problem problem = MakeProblem(bytes);
  PlanarDomain domain;
  if (!Succeeds([&] { domain = MakePlanarDomain(problem.loops); }))
  {
    return 0;
  }
  Succeeds([&] { ClassifyCorners(domain); });
  if (!problem.configuration.empty() && bytes.ConsumeBool())
  {
    // Adjusts the last index so that the sum is the required one.
    const PoincareHopfCount count =
      CountQuarters(domain.loops, TotalQuarters(problem.configuration));
    problem.configuration.back().quarterIndex +=
      count.requiredInteriorQuarters - count.givenInteriorQuarters;
  }
  TriangleMesh mesh;
  DrillOptions options;
  options.meshSize = domain.Diagonal() / 6.0;
  options.mode = bytes.PickValueInArray(
    { DrillMode::Perforate, DrillMode::Perforate, DrillMode::Imprint, DrillMode::Triangle });
  if (Succeeds([&] { mesh = DrillHoles(domain, problem.configuration, options); }))
  {
    Require(!mesh.triangles.empty(), "a mesh has triangles");
    RequireSolved(mesh, PerforatedMethod::Constrained);
    RequireSolved(mesh, PerforatedMethod::UnitNorm);
  }
  HField h;
  if (Succeeds(
        [&] {
          h = SolveHField(ShareTopology(DrillHoles(domain, {}, options)), problem.configuration);
        }))
  {
    Require(h.h.allFinite(), "H is finite");
  }
  std::vector<ConfigurationEnergy> energies;
  ConfigurationEnergyOptions energyOptions;
  energyOptions.meshSize = options.meshSize;
  if (Succeeds([&]
        { energies = CompareConfigurations(domain, { problem.configuration }, energyOptions); }))
  {
    Require(energies.size() == 1, "an energy for each configuration");
    Require(!energies.front().consistent || std::isfinite(energies.front().renormalized.energy),
      "W is finite");
  }
  return 0;
}
