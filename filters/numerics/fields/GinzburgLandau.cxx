#include "GinzburgLandau.h"

#include "Error.h"
#include "FieldSingularities.h"
#include "PenaltySolve.h"
#include "Stopwatch.h"
#include "TriangleArea.h"

#include <string>
#include <utility>

namespace crossfield
{
namespace
{
void RequireNoHoles(const PlanarTopology& topology)
{
  if (topology.LoopCount(BoundaryKind::Hole) > 0)
  {
    throw Error("The mesh has holes for singularities, but the Ginzburg-Landau method places "
                "singularities by itself; use a mesh without holes for singularities.");
  }
}

ComplexVector Start(const GinzburgLandauOptions& options, const GinzburgLandauEnergy& energy,
  const EdgeNumbering& edges)
{
  ComplexVector u;
  switch (options.start)
  {
  case GinzburgLandauStart::Harmonic:
    return energy.HarmonicField();
  case GinzburgLandauStart::Constant:
    u = ComplexVector::Ones(edges.Count());
    break;
  case GinzburgLandauStart::Zero:
    u = ComplexVector::Zero(edges.Count());
    break;
  case GinzburgLandauStart::Given:
    if (options.given.size() != edges.Count() || !options.given.allFinite())
    {
      throw Error("The field to start from has " + std::to_string(options.given.size()) +
        " values or some that are not finite; give one finite value for each of the " +
        std::to_string(edges.Count()) + " edges.");
    }
    u = options.given;
    break;
  }
  energy.Align(u);
  return u;
}

}

double ResolveEpsilon(const GinzburgLandauOptions& options, const PlanarTopology& topology)
{
  if (options.epsilon != 0.0)
  {
    return options.epsilon;
  }
  double area = 0.0;
  double sum = 0.0;
  const EdgeNumbering& edges = topology.edges;
  for (std::size_t t = 0; t < topology.mesh.triangles.size(); ++t)
  {
    const double here = TriangleArea(topology.mesh, topology.mesh.triangles[t]);
    for (const int edge : edges.ofTriangle[t])
    {
      const auto& [from, to] = edges.vertices[edge];
      area += here;
      sum += here * (topology.PointAt(to) - topology.PointAt(from)).norm();
    }
  }
  return sum / area;
}

GinzburgLandauField SolveGinzburgLandau(const SharedPlanarTopology& topology,
  const GinzburgLandauOptions& options, const Progress& progress)
{
  Stopwatch stopwatch;
  RequireNoHoles(*topology);
  GinzburgLandauField field;
  field.topology = topology;
  field.count = CountMeshQuarters(*topology);
  field.epsilon = ResolveEpsilon(options, *topology);
  const GinzburgLandauEnergy energy(*topology, field.epsilon, options.pinning);
  field.seconds.assemble = stopwatch.Lap();
  progress.Report(0.05);

  field.u = Start(options, energy, topology->edges);
  field.seconds.factor = stopwatch.Lap();
  progress.Report(0.1);

  MinimiserOptions minimiser;
  minimiser.maximumIterations = options.maximumIterations;
  minimiser.tolerance = options.tolerance;
  MinimiserResult result =
    SolveWithPenalty(energy, {}, field.u, minimiser, progress.Part(0.1, 0.95));
  field.u = std::move(result.x);
  field.iterations = result.iterations;
  field.residual = result.residual;
  field.converged = result.converged;
  field.energies = std::move(result.values);
  field.convexifiedSteps = result.convexifiedSteps;
  field.saddlesLeft = result.saddlesLeft;
  field.gradientEnergy = energy.GradientPart(field.u);
  field.penaltyEnergy = energy.PenaltyPart(field.u);
  field.energy = field.gradientEnergy + field.penaltyEnergy;
  static_cast<FieldReading&>(field) = ReadField(field, { field.count, {}, false, true });
  field.count.givenInteriorQuarters = 0;
  for (const FieldSingularity& singularity : FindFieldSingularities(field))
  {
    field.count.givenInteriorQuarters += singularity.quarterIndex;
  }
  field.seconds.solve = stopwatch.Lap();
  progress.Report(1.0);
  return field;
}
}
