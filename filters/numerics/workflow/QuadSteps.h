#pragma once

#include "ResolvedRequest.h"

namespace crossfield
{
/// The steps from a request of WithSizeTargets to its quads, without trying remedies: singularities,
/// their layout, quads. A copy that is made after Place continues from there.
class QuadSteps
{
public:
  /// `seconds` receives the times of all steps, also of copies and of steps that throw. Throws
  /// Error as RequireLayers does.
  QuadSteps(const PlanarDomain& domain, ResolvedRequest request, QuadSeconds& seconds);

  /// Chooses singularities unless they are given, splits indices and repairs the holonomy on
  /// request. Throws Error as ChooseSingularities, RequireNodes and RepairForMap do.
  void Place(const Progress& progress);
  /// Returns the number of configurations that were chosen, 1 if singularities are given.
  std::size_t CountChoices() const { return 1 + this->Others.size(); }
  /// Continues with another configuration, 0 for the first. Throws Error as Place does.
  void UseChoice(std::size_t choice);
  /// Returns AutomaticConfiguration::rank of a choice.
  int RankOf(std::size_t choice) const { return choice == 0 ? 0 : this->Others[choice - 1].rank; }
  /// Repairs the holonomy although that was not requested. Throws Error if that is impossible, or
  /// there is nothing to repair.
  void RepairHolonomy(const Progress& progress);
  /// Moves given singularities towards a minimum of the renormalised energy. Throws Error as
  /// MinimiseEnergy does.
  void MoveToMinimumEnergy(const Progress& progress);
  /// Meshes with edges divided by `refinement` (MeshThroughPoints), solves for the map, traces the
  /// separatrices, makes quads, merges blocks and adds layers. Throws Error as MeshThroughPoints,
  /// LayOut, MakeQuads and AddLayers do.
  QuadWorkflowResult MakeQuads(double refinement, const Progress& progress);

  /// Continues with the singularities at other positions.
  void MoveTo(Configuration singularities);
  /// Meshes, solves for the map and traces the separatrices only. Throws Error as MakeQuads does.
  Layout LayOutOnly(double refinement, const Progress& progress);
  /// Returns what is known about singularities and corners so far.
  const QuadWorkflowResult& GetResult() const { return this->Result; }

  /// Makes quads without merging blocks, whatever the request says.
  void DoNotMerge();
  /// Makes layers that replace as few rows as are free of irregular nodes.
  void TakeFewRows() { this->Request.takesFewRows = true; }

private:
  void Choose(const Progress& progress);
  void AddPairs(const Progress& progress);
  void Use(AutomaticConfiguration choice);
  void Split();
  void RepairOnRequest(const Progress& progress);
  SharedPlanarTopology MakeMesh(double refinement, const Progress& progress);
  Layout MakeLayout(double refinement, const Progress& progress);
  void MakeQuadsOf(Layout layout, const Progress& progress);
  int CountAddedNodes() const;
  std::vector<CountedCorner> CornersOn(const PlanarTopology& topology) const;
  void Describe(const Layout& layout);
  void AddEvent(const std::string& event) { this->Result.events.push_back(event); }
  void AddEvents(const std::vector<std::string>& events);
  void UseRepair(HolonomyRepair repair);
  std::optional<HolonomyRepair> FindRepair(const Progress& progress = {});
  void AddWarnings();
  double SideLength() const;

  const PlanarDomain& Domain;
  /// The request; with layers, quadCount is the number of quads before they are added.
  ResolvedRequest Request;
  const int Total; ///< Requested number of quads.
  SeamlessMapOptions MapOptions;
  std::vector<AutomaticConfiguration> Others; ///< Chosen besides the one that is used.
  Configuration Start;        ///< The singularities that were given or chosen, split on request.
  Configuration BeforeRepair; ///< The singularities before the holonomy was repaired.
  std::string Motion;         ///< Where singularities were moved without request, in words.
  QuadWorkflowResult Result;
  QuadSeconds& Seconds;
};
}
