#pragma once

#include "QuadMesh.h"

#include <string>

namespace crossfield
{
/// What a user prescribes for the boundary layer of a side.
struct LayerPrescription
{
  std::string name;    ///< Of the side, for messages.
  double first = 0.0;  ///< Height of the first row, a length.
  double growth = 1.2; ///< Maximum ratio of the heights of neighbouring rows, above 1.
  int rows = 0;        ///< Number of rows; 0: as many as the growth needs.
};

/// A quad mesh while its bands are divided.
struct LayeredMesh
{
  QuadMesh mesh;
  std::vector<LayerPrescription> prescriptions;
  std::vector<int> layers; ///< Per edge of mesh.boundary, the prescription of its side, −1: none.
  std::vector<int> names;  ///< Per edge of mesh.boundary, the number of its side.
  std::vector<int> bands;  ///< Per edge of mesh.boundary, the number of its band, −1: none.
  /// Per quad, a number that differs between quads of different sets of divided bands; 0 for those
  /// outside all of them.
  std::vector<int> regions;
};
}
