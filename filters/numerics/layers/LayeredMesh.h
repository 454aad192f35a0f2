#pragma once

#include "QuadMesh.h"

#include <optional>
#include <string>

namespace crossfield
{
/// What a user prescribes for the boundary layer of a side.
struct LayerPrescription
{
  std::string name; ///< Of the side, for messages.
  /// Height of the first row, a length; none: rows are the quads themselves, free of irregular
  /// nodes.
  std::optional<double> first;
  double growth = 1.2; ///< Maximum ratio of the heights of neighbouring rows, at least 1.
  int rows = 0;        ///< Number of rows; 0: as many as the growth needs.
};

/// A quad mesh while its bands are divided.
struct LayeredMesh
{
  QuadMesh mesh;
  std::vector<LayerPrescription> prescriptions;
  std::vector<int> layerOfSide; ///< Per side of the boundary, its prescription, −1: none.
  std::vector<int> bands;       ///< Per edge of mesh.boundary, the number of its band, −1: none.
  /// Per quad, a number that differs between quads of different sets of divided bands; 0 for those
  /// outside all of them.
  std::vector<int> regions;

  /// Returns the prescription of the side of an edge of mesh.boundary, −1: none.
  int LayerAt(std::size_t edge) const
  {
    const int side = this->mesh.boundary[edge].side;
    return side < 0 ? -1 : this->layerOfSide[side];
  }
};
}
