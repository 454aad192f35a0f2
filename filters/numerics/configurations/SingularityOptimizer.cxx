#include "SingularityOptimizer.h"

#include "OptimizerRun.h"

namespace crossfield
{
OptimizerResult OptimizeSingularities(const PlanarDomain& domain, const Configuration& start,
  const OptimizerOptions& options, const Progress& progress)
{
  OptimizerResult result;
  OptimizerRun run(domain, options, result);
  run.Start(start, progress);
  OptimizerEnd end = run.Move(progress.Part(0.2, options.evenSizes ? 0.6 : 1.0));
  if (options.evenSizes && end != OptimizerEnd::Aborted)
  {
    end = run.Even(progress.Part(0.6, 1.0));
  }
  run.Finish(end);
  return result;
}
}
