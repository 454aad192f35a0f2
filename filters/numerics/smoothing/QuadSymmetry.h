#pragma once

#include "QuadMesh.h"
#include "QuadSmoothing.h"

#include "PlanarDomain.h"

namespace crossfield
{
/// Makes a mesh as symmetric as its domain (docs/method.md §14.5). Uses those symmetries of the
/// boundary that take quads to quads, and fixed points to fixed points of the same index within
/// 1e-9 of the diagonal. Every other point moves to the mean of its images, on the boundary to the
/// nearest point of the polyline. The displacement corresponds to the asymmetry of the triangles of
/// the map. Cost: linear in points, times the number of symmetries.
///
/// `released` means that inner singularities are not fixed. Returns the number of symmetries, 1 if
/// there is none but the identity.
int MakeSymmetric(
  QuadMesh& mesh, const BoundaryCurves& curves, const PlanarDomain& domain, bool released);

/// Does the same and sets SmoothingReport::symmetries; but if nodes of periodic sides do not match
/// afterwards, the mesh stays as it is, with `isAsymmetric`. Uses SmoothingReport::released.
void MakeSymmetricAndPeriodic(QuadMesh& mesh, const BoundaryCurves& curves,
  const PlanarDomain& domain, SmoothingReport& report);
}
