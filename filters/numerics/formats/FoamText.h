#pragma once

#include "MeshText.h"

#include <string>
#include <string_view>

namespace crossfield
{
/// Adds the header of a file of OpenFOAM in ASCII. The note may be empty.
void AddFoamHeader(MeshText& text, std::string_view type, std::string_view location,
  std::string_view object, std::string_view note = "");
}
