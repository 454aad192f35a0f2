#pragma once

#include "Layout.h"
#include "SurfaceCones.h"

namespace crossfield
{
/// Joins the layouts of the faces of a body, whose pairs are the two sides of each line of sharp edges: side 2 i
/// is that of line i with the face on its left, 2 i + 1 the other. The T-mesh has nodes at the ends of lines.
LayoutSet JoinFaces(const SurfaceBody& body, const std::vector<Layout>& layouts);
}
