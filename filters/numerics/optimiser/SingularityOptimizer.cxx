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
  if (run.IsAbove(options.maximumStart))
  {
    run.WriteResult(OptimizerEnd::NoDescent);
    return result;
  }
  const bool uniform = options.sizes.sizing != Sizing::Conformal || options.pairs > 0;
  const double share = options.pairs > 0 ? 0.4 : uniform ? 0.6 : 1.0;
  OptimizerEnd end = run.Minimise(progress.Part(0.2, share));
  if (uniform && end != OptimizerEnd::Aborted)
  {
    end = run.MakeSizesUniform(progress.Part(share, options.pairs > 0 ? 0.6 : 1.0));
    end = run.AddPairs(options.pairs, end, progress.Part(0.6, 1.0));
  }
  run.WriteResult(end);
  return result;
}
}
