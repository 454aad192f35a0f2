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
  const bool even = options.sizes.sizing != Sizing::Conformal || options.pairs > 0;
  const double share = options.pairs > 0 ? 0.4 : even ? 0.6 : 1.0;
  OptimizerEnd end = run.Move(progress.Part(0.2, share));
  if (even && end != OptimizerEnd::Aborted)
  {
    end = run.Even(progress.Part(share, options.pairs > 0 ? 0.6 : 1.0));
    end = run.AddPairs(options.pairs, end, progress.Part(0.6, 1.0));
  }
  run.Finish(end);
  return result;
}
}
