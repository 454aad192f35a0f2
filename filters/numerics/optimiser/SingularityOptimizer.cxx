#include "SingularityOptimizer.h"

#include "OptimizerRun.h"

namespace crossfield
{
PreparedOptimization::PreparedOptimization(const PlanarDomain& domain, const Configuration& start,
  const OptimizerOptions& options, const Progress& progress)
  : Options(options)
  , Optimizer(std::make_unique<OptimizerRun>(domain, options, Result))
{
  this->Optimizer->Start(start, progress);
}

PreparedOptimization::~PreparedOptimization() = default;

double PreparedOptimization::StartObjective() const
{
  return this->Optimizer->Objective();
}

OptimizerResult PreparedOptimization::Run(double maximumStart, const Progress& progress)
{
  OptimizerRun& run = *this->Optimizer;
  if (this->StartObjective() > maximumStart)
  {
    run.WriteResult(OptimizerEnd::NoDescent);
    return this->Result;
  }
  const OptimizerOptions& options = this->Options;
  const bool uniform = options.sizes.sizing != Sizing::Conformal || options.pairs > 0;
  const double share = options.pairs > 0 ? 0.4 : uniform ? 0.6 : 1.0;
  OptimizerEnd end = run.Minimise(progress.Part(0.2, share));
  if (uniform && end != OptimizerEnd::Aborted)
  {
    end = run.MakeSizesUniform(progress.Part(share, options.pairs > 0 ? 0.6 : 1.0));
    end = run.AddPairs(options.pairs, end, progress.Part(0.6, 1.0));
  }
  run.WriteResult(end);
  return this->Result;
}

OptimizerResult OptimizeSingularities(const PlanarDomain& domain, const Configuration& start,
  const OptimizerOptions& options, const Progress& progress)
{
  return PreparedOptimization(domain, start, options, progress).Run(options.maximumStart, progress);
}
}
