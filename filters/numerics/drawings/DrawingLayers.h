#pragma once

#include "Drawing.h"

#include <string>
#include <vector>

namespace crossfield
{
/// Removes the pieces of a drawing whose names are not in a list; "0" stands for pieces without a name, as on layer 0 of
/// a .dxf file. A warning counts them. Without names all pieces stay. Throws Error with the names that there are if no piece
/// has one of the names.
void KeepLayers(const std::vector<std::string>& names, Drawing& drawing);
}
