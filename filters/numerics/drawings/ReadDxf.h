#pragma once

#include "Drawing.h"

#include <string>
#include <string_view>

namespace crossfield
{
/// Reads an ASCII .dxf file. Curves of the model space become pieces (DxfCurves.h); blocks are
/// inserted. The layer is the name of the side; curves on layer 0 have no name, those inserted on
/// layer 0 of a block have the layer of the insertion. Curves of layers that are off or frozen, and
/// other entities, are left out and counted in a warning. The unit is that of $INSUNITS.
///
/// Throws Error if the text is not a complete .dxf file or an entity is not valid, or if the
/// curves have different z coordinates.
Drawing ReadDxf(std::string_view text, const std::string& file);
}
