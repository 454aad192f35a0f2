#pragma once

#include "BoundaryAbsorption.h"
#include "OptimizerResult.h"
#include "Progress.h"

#include <optional>
#include <set>
#include <string>

namespace crossfield
{
/// Run of the optimiser over several meshes: the present stage, the positions on it, and the events
/// so far (docs/method.md §5.5).
class OptimizerRun
{
public:
  /// Stores events in `result`. Throws Error if the clearance is negative.
  OptimizerRun(
    const PlanarDomain& domain, const OptimizerOptions& options, OptimizerResult& result);

  void Start(const Configuration& start, const Progress& progress);
  /// Returns OptimizerResult::objective at present.
  double Objective() const;
  /// Minimises the objective, meshing again and changing the configuration where necessary.
  OptimizerEnd Minimise(const Progress& progress);
  /// Continues the optimisation from the minimum of W to the most uniform sizes, with the present
  /// singularities.
  OptimizerEnd MakeSizesUniform(const Progress& progress);
  /// Adds up to `maximumPairs` pairs of opposite signs, as long as each is an improvement, and
  /// minimises after each (docs/method.md §5.8). Returns how the last minimisation ended, or `end`
  /// if there was none.
  OptimizerEnd AddPairs(int maximumPairs, OptimizerEnd end, const Progress& progress);
  void WriteResult(OptimizerEnd end);

private:
  void AddEvent(const std::string& sentence) { this->Result.events.push_back(sentence); }
  /// Moves singularities away from the boundary and from each other. If there is not enough space,
  /// reduces the factors of the clearance, and then the clearance.
  void EnforceClearances(double requested, Configuration& singularities);
  void StartStage(const TrackedConfiguration& tracked, const Progress& progress);
  /// Moves off a stationary point that is a minimum among symmetric configurations only. Returns
  /// whether it did.
  bool LeaveSaddle();
  /// Goes back to the symmetric point that LeaveSaddle left, if little was gained since.
  void ReturnToSaddle();
  /// Restores the symmetry of the start. Changes are made one after the other, and the
  /// singularities move in between; if the configuration is approximately symmetric again after
  /// them, the iteration continues from the nearest symmetric one. Returns whether it does.
  bool RestoreSymmetry();
  /// Returns whether singularities have met or been stopped at the boundary for several steps, so
  /// that the configuration should be changed.
  bool IsChangeDue(const OptimizerState& state);
  /// Makes one change of the configuration that lowers the energy, if there is one.
  bool MakeChange();
  /// Tries a change, and accepts it if the energy with cores is lower after a few steps. Returns
  /// whether it was accepted.
  bool TryChange(const ConfigurationChange& change);
  void AddToFront();

  /// A stationary point among symmetric configurations.
  struct SymmetricStop
  {
    OptimizerStage stage;
    OptimizerState current;
  };

  const PlanarDomain& Domain;
  int MaximumIterations;
  bool KeepAll;
  OptimizerResult& Result;
  StageOptions Options;
  OptimizerStage Stage;
  OptimizerState Current;
  OptimizerIteration Iteration;
  std::optional<SymmetricStop> Saddle; ///< Where LeaveSaddle left the symmetry.
  std::set<std::string> Rejected;      ///< Keys of changes that did not lower the energy.
  BoundaryTargets Targets;             ///< On the present stage.
  int BoundaryMoves = 0;
  int FailedAbsorptions = 0;         ///< Since the last change.
  Eigen::VectorXd PreviousPositions; ///< Positions one step ago.
  int StepsDue = 0;                  ///< Number of successive steps for which a change was due.
  bool Changed = false;
  double DefectBefore = 0.0; ///< Largest holonomy defect at the start, radians.
  bool StartsSymmetric = false;
  bool SymmetryTried = false; ///< Whether RestoreSymmetry has been tried.
};
}
