#pragma once

#include "LayerReport.h"
#include "QuadMesher.h"

namespace crossfield
{
/// Throws Error if a prescription has impossible numbers, heights that coordinates of a domain of
/// this extent cannot have, or is for none of the sides.
void RequireLayers(const std::vector<LayerPrescription>& layers,
  const std::vector<std::string>& sides, double extent);

/// Returns the number of rows of quads beside a side that must be free of irregular nodes.
int RowsBeside(const LayerPrescription& layer);

/// Divides the bands of quads beside sides of a mesh into rows whose heights grow from the wall
/// (docs/method.md §16). Points outside the bands, valences and the irregular points stay as they
/// are. The blocks are divided along the bands. `domain` is that of the mesh, whose symmetries the
/// result keeps.
///
/// Throws Error as RequireLayers does, if the first height of a side is not less than the rows
/// there, if periodic sides have different numbers of nodes afterwards, and, of kind LackOfRows, if
/// too few rows beside it are free of irregular points. With `takesFewRows` those that are free are
/// replaced instead, and the report says so; heights then differ much behind the layer, and first
/// heights may not hold.
std::vector<LayerReport> AddLayers(const PlanarDomain& domain, const BoundaryCurves& curves,
  const std::vector<LayerPrescription>& prescriptions, bool takesFewRows, QuadResult& quads);
}
