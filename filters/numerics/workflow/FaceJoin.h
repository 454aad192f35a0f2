#pragma once

#include "Layout.h"
#include "SurfaceCones.h"

namespace crossfield
{
/// Joins the layouts of the faces of a body, whose pairs are the two sides of each line between faces: side 2 i
/// is that of line i with the face on its left whose region has the lower number, 2 i + 1 the other. The T-mesh has
/// nodes at the ends of lines and where names of the boundary change. Lines are called by their names, by their two
/// regions (`A+B`), or `features`.
LayoutSet JoinFaces(
  const SurfaceBody& body, const SurfaceNames& names, const std::vector<Layout>& layouts);
}
