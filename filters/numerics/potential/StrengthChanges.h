#pragma once

#include "PositionEnergy.h"

#include <map>
#include <memory>
#include <tuple>
#include <vector>

namespace crossfield
{
/// W of configurations on one mesh that differ from a given one in a few quarter indices
/// (docs/method.md §5.9). W is a quadratic function of the strengths of the logarithms, so a change
/// needs only the response of R to the logarithms whose strengths change. It is computed once for
/// each place, for many places together, and no configuration needs a solve of its own.
///
/// The values are those of PositionEnergy up to rounding.
class StrengthChanges
{
public:
  /// Place of a logarithm: a vertex of the boundary or a position inside.
  struct Place
  {
    Point position = Point::Zero();
    int vertex = -1; ///< Vertex of the mesh; −1 inside.
  };
  /// Quarters that are added to the index at a place.
  struct Change
  {
    Place place;
    int quarters = 0;
  };
  struct Value
  {
    double energy = 0.0; ///< W with the harmonic field of the holonomy defects.
    double logarithmCoefficient = 0.0;
    double largestDefect = 0.0; ///< Largest holonomy defect, radians.
  };

  StrengthChanges(std::shared_ptr<const PositionEnergy> energy, const Configuration& configuration);

  /// Computes the responses for places that have none yet. Returns their number.
  std::size_t Prepare(const std::vector<Place>& places);
  bool IsPrepared(const Place& place) const { return this->Columns.count(KeyOf(place)) != 0; }

  /// Returns W of the configuration with changed quarter indices, whose changes must add up to zero.
  /// All places must have been prepared.
  Value Evaluate(const std::vector<Change>& changes) const;
  /// Energy at a core radius as a quadratic function of the changes δ of the quarter indices at
  /// places (docs/method.md §5.10): linear · δ + ½ δ · matrix δ for all δ with sum zero, without the
  /// harmonic field of the holonomy defects. These are `defects` + `defectChanges` δ, and the energy
  /// of their field is ½ d · defectEnergy d.
  struct Form
  {
    Eigen::VectorXd linear;
    Eigen::MatrixXd matrix;
    Eigen::VectorXd defects;
    Eigen::MatrixXd defectChanges; ///< A row for each inner loop.
    Eigen::MatrixXd defectEnergy;
  };
  /// Returns the form for places, which need not be prepared. `regular`, if given, receives R of a
  /// quarter at each place at all vertices, single-valued, a column for each.
  Form FormAt(
    const std::vector<Place>& places, double coreRadius, Eigen::MatrixXd* regular = nullptr) const;

  /// Makes the changed configuration the given one.
  void Accept(const std::vector<Change>& changes);

private:
  using Key = std::tuple<int, double, double>;
  static Key KeyOf(const Place& place);

  /// One quarter of index at a place.
  struct Column
  {
    LogSource log;
    Eigen::VectorXd flux;     ///< Through each half. Adds up to 0: the sum is taken from the first.
    Eigen::VectorXd mean;     ///< On each half.
    Eigen::VectorXd response; ///< 𝓡 flux on each half.
    Eigen::VectorXd defects;  ///< Change of the holonomy defects.
  };

  /// Sum of the columns of changes.
  struct Sum
  {
    double interaction = 0.0; ///< Change of the interaction of the logarithms.
    double coefficient = 0.0; ///< Change of the logarithm coefficient.
    Column column;            ///< Without a logarithm.
  };
  Sum Add(const std::vector<Change>& changes) const;
  /// Returns the change of the single-valued W.
  double EnergyOf(const Sum& sum) const;

  /// Returns the strength of the given logarithms at a position.
  double StrengthAt(const Point& position) const;
  /// Returns the logarithm of a place, with its flow.
  Column MakeColumn(const Place& place) const;
  /// Computes the responses of columns. `atVertices`, if given, receives 𝓡 flux at all vertices, a
  /// column for each.
  void ComputeResponses(
    const std::vector<Column*>& columns, Eigen::MatrixXd* atVertices = nullptr) const;

  std::shared_ptr<const PositionEnergy> Energy;
  std::map<int, std::size_t> EntryOf; ///< Entry of mesh.boundary that starts at a vertex.
  std::vector<LogSource> Logs;        ///< Of the given configuration.
  PositionEnergy::Flows Given;
  Eigen::VectorXd Regular; ///< R on each half.
  Eigen::VectorXd Growth;  ///< Growth of the phase along each half.
  Eigen::VectorXd Defects;
  Eigen::MatrixXd
    DefectEnergy; ///< The harmonic field of defects d has energy ½ d · DefectEnergy d.
  Eigen::MatrixXd PeriodBasis; ///< PointPotential::GetPeriodBasis on each half.
  double SingleValued = 0.0;   ///< Single-valued W.
  double Coefficient = 0.0;    ///< Logarithm coefficient.
  std::array<std::vector<std::vector<Point>>, 2> Paths; ///< Along strips: polygon, curve.
  std::map<Key, Column> Columns;
};
}
