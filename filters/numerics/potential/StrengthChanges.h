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
  };

  StrengthChanges(
    std::shared_ptr<const PositionEnergy> energy, const Configuration& configuration);

  /// Computes the responses for places that have none yet. Returns their number.
  std::size_t Prepare(const std::vector<Place>& places);
  bool IsPrepared(const Place& place) const { return this->Columns.count(KeyOf(place)) != 0; }

  /// Returns W of the configuration with changed quarter indices, whose changes must add up to zero.
  /// All places must have been prepared.
  Value Evaluate(const std::vector<Change>& changes) const;

private:
  using Key = std::tuple<int, double, double>;
  static Key KeyOf(const Place& place);

  /// One quarter of index at a place.
  struct Column
  {
    LogSource log;
    double present = 0.0;     ///< Strength of the logarithm that is there already.
    Eigen::VectorXd flux;     ///< Through each half. Adds up to 0: the sum is taken from the first.
    Eigen::VectorXd mean;     ///< On each half.
    Eigen::VectorXd response; ///< 𝓡 flux on each half.
    Eigen::VectorXd defects;  ///< Change of the holonomy defects.
  };

  /// Returns the logarithm of a place, with its flow.
  Column MakeColumn(const Place& place) const;
  void ComputeResponses(const std::vector<Column*>& columns) const;

  std::shared_ptr<const PositionEnergy> Energy;
  std::map<int, std::size_t> EntryOf; ///< Entry of mesh.boundary that starts at a vertex.
  std::map<int, double> BoundaryStrength;
  std::vector<LogSource> Logs; ///< Of the given configuration.
  PositionEnergy::Flows Given;
  Eigen::VectorXd Regular; ///< R on each half.
  Eigen::VectorXd Growth;  ///< Growth of the phase along each half.
  Eigen::VectorXd Defects;
  Value Base;
  double SingleValued = 0.0; ///< Single-valued W.
  std::array<std::vector<std::vector<Point>>, 2> Paths; ///< Along strips: polygon, curve.
  std::map<Key, Column> Columns;
};
}
