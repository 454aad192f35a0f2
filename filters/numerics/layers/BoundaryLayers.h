#pragma once

#include "Error.h"
#include "LayerReport.h"
#include "QuadMesher.h"

namespace crossfield
{
/// Thrown if irregular points leave too few rows beside a side for its layer.
class LackOfRows : public Error
{
public:
  using Error::Error;
};

/// Throws Error if a prescription has impossible numbers.
void RequireLayers(const std::vector<LayerPrescription>& layers);

/// Divides the bands of quads beside sides of a mesh into rows whose heights grow from the wall
/// (docs/method.md §15). Points outside the bands, valences and the irregular points stay as they
/// are. The blocks are divided along the bands. `layers` has per edge of mesh.boundary the
/// prescription of its side, −1 where there is none; `names` has the numbers of all sides.
///
/// Throws Error if a side does not exist, if its first height is not less than the rows there, or
/// LackOfRows if too few rows beside it are free of irregular points.
std::vector<LayerReport> AddLayers(QuadResult& quads, const BoundaryCurves& curves,
  const std::vector<LayerPrescription>& prescriptions, const std::vector<int>& layers,
  const std::vector<int>& names);
}
