#pragma once

#include "BoundaryPieces.h"
#include "LayeredMesh.h"
#include "SidePrescription.h"

#include <optional>
#include <string>

namespace crossfield
{
/// What is prescribed for the side of a name, besides what rows do at its corners (CornerRule). Several
/// requests may be for one side, but prescribe nothing twice.
struct SideRequest
{
  std::string side;
  int count = 0; ///< Number of edges; 0: not prescribed.
  std::optional<Progression> progression;
  double size = 0.0;   ///< Length of the edges; 0: not prescribed.
  double inside = 0.0; ///< Target size of quads in what the side encloses; 0: not prescribed.
  std::optional<CurveDeclaration::Kind> curve;
  std::optional<LayerPrescription> layer; ///< Its name is that of the side.
  std::string partner;                    ///< Side whose nodes are images of those of this one.
};
}
