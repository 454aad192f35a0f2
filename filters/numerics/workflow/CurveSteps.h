#pragma once

#include "ResolvedRequest.h"

namespace crossfield
{
/// A domain and the request for its quads, with curves sampled (docs/method.md §17.4).
struct CurvedRequest
{
  PlanarDomain domain;
  ResolvedRequest request;
};

/// Finds the requested and given curves of a domain, samples them as finely as the triangles, and
/// places corners and singularities that are given on the boundary on them. Without curves the domain
/// and the request are unchanged. Throws Error as FindCurves and SampleCurves do.
CurvedRequest WithCurves(const PlanarDomain& domain, const ResolvedRequest& request);

/// Returns for each curve how many boundary edges it has and how far they are from the polyline that
/// was given.
std::vector<CurveReport> MeasureCurves(
  const PlanarDomain& given, const CurvedBoundary& boundary, const QuadMesh& mesh);
}
