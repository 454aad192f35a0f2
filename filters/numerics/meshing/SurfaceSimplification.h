#pragma once

#include "FeatureEdges.h"

namespace crossfield
{
/// A surface with its sharp edges, without regions and names of lines.
struct SimplifiedSurface
{
  SurfaceMesh surface;
  FeatureEdges features;
};

/// Returns a surface of about `count` triangles near a connected, oriented manifold surface: edges are collapsed, those
/// first that change volume and boundary least (Lindstrom and Turk, 1998). Edges of the boundary and sharp ones stay, so
/// that more triangles may remain. A surface that has no more is returned as it is.
SimplifiedSurface Simplified(const SurfaceMesh& surface, const FeatureEdges& features, int count);
}
