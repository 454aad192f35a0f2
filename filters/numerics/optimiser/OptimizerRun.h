#pragma once

#include "ConfigurationChange.h"
#include "OptimizerResult.h"
#include "Progress.h"

#include <set>
#include <string>

namespace crossfield
{
/// The optimiser between its meshes: the stage, the place on it, and what has happened
/// (docs/method.md §5.5).
class OptimizerRun
{
public:
  /// What happens is told to the result. Throws Error when the clearance is negative.
  OptimizerRun(
    const PlanarDomain& domain, const OptimizerOptions& options, OptimizerResult& result);

  void Start(const Configuration& start, const Progress& progress);
  /// To the least of what is minimised, from mesh to mesh and from change to change.
  OptimizerEnd Move(const Progress& progress);
  /// From the least W on to the evenest sizes, with the singularities that there are.
  OptimizerEnd Even(const Progress& progress);
  /// Then adds up to so many pairs of opposite signs, as long as they bring something, and moves all to the
  /// evenest sizes with each (docs/method.md §5.8). Returns how the last move ended, or `end` before that.
  OptimizerEnd AddPairs(int most, OptimizerEnd end, const Progress& progress);
  void Finish(OptimizerEnd end);

private:
  void Say(const std::string& sentence) { this->Result.events.push_back(sentence); }
  void Begin(const TrackedConfiguration& tracked, const Progress& progress);
  /// Leaves symmetric places at which the energy is least among symmetric ones only.
  bool LeaveSaddle();
  /// Changes are made one after the other, and the singularities go on in between. What is about as
  /// symmetric as the start after them goes on from the symmetric place next to it.
  bool RestoreSymmetry();
  /// Whether singularities have met or been pressed for so many steps that they will stay so.
  bool Persists(const OptimizerPlace& place);
  /// Makes one change that the singularities want, if there is one that helps.
  bool Change();
  /// Goes on from a change if the energy with cores is lower after a few steps.
  bool Try(const ConfigurationChange& change);
  void AddToFront();

  const PlanarDomain& Domain;
  int MostIterations;
  bool KeepAll;
  OptimizerResult& Result;
  StageOptions Stages;
  OptimizerStage Stage;
  OptimizerPlace Here;
  OptimizerIteration Iteration;
  std::set<std::string> Refused; ///< Changes that were tried in vain.
  int Slides = 0;
  Eigen::VectorXd Last; ///< Where the singularities were a step ago.
  int Wanted = 0;       ///< Steps for which a change has been wanted.
  bool Changed = false;
  bool StartsSymmetric = false;
  bool Restored = false; ///< Whether RestoreSymmetry had its turn.
};
}
