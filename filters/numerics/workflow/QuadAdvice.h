#pragma once

#include "BoundaryCorners.h"
#include "Error.h"
#include "HolonomyRepair.h"
#include "PlanarDomain.h"
#include "QuadMesher.h"
#include "ResolvedRequest.h"

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace crossfield
{
/// A size with which no quads are inverted, and the number of quads.
struct SmallerSize
{
  double size = 0.0;
  std::size_t quads = 0;
  bool keepsSingularities =
    false; ///< With the chosen singularities; otherwise they are chosen again.
};

/// What smaller sizes led to.
struct SizeTrials
{
  int tried = 0;                    ///< Number of sizes tried.
  std::optional<SmallerSize> valid; ///< The last one, if no quads are inverted with it.
};

/// Throws Error if an interior singularity has a quarter index above 2, for which there is no node.
void RequireNodes(const PlanarDomain& domain, const Configuration& singularities);

/// Returns a sentence for every interior singularity of quarter index 2: its node has two quads,
/// with an angle of 180° each.
std::vector<std::string> DescribeFlatNodes(
  const PlanarDomain& domain, const Configuration& singularities);

/// Returns a sentence for every interior singularity of quarter index −2 or below, whose node has
/// six quads or more.
std::vector<std::string> DescribeCrowdedNodes(
  const PlanarDomain& domain, const Configuration& singularities);

/// Tries a half and a quarter of the size of quads, rounded to four digits, until no quads are
/// inverted. Sizes of more than 50,000 quads, and T-meshes of more than 2,000 arcs, are not tried.
/// `mesh` makes the quads of a size.
SizeTrials TrySmallerSizes(
  const QuadResult& quads, const std::function<QuadResult(double size)>& mesh);

/// Returns a length for which the domain with a smoothed boundary (SmoothBoundary.h) has quads,
/// rounded to four digits; 0 if none of 1/400 to 1/50 of the diagonal has. The boundary stays in
/// place at the points `kept`. `mesh` makes the quads of a domain, or throws Error.
double FindSmoothing(const PlanarDomain& domain, const std::vector<Point>& kept,
  const std::function<void(const PlanarDomain& domain)>& mesh);

/// Returns, without a full stop, the number of inverted quads and the place of the worst one.
std::string CountInverted(const QuadQuality& quality);

/// Returns a sentence about inverted quads. The remedy is a size with which there are none, if one
/// was found, otherwise other positions of given singularities.
std::string DescribeInverted(
  const QuadQuality& quality, const SizeTrials& smaller, bool singularitiesAreGiven);

/// Returns a warning if the number of quads is not the requested one within the tolerance,
/// otherwise an empty text. `isPrescribed`: there are prescriptions that it may follow from.
std::string DescribeCount(const QuadRequest& request, bool isPrescribed, const QuadResult& quads);

/// Returns a warning about sides that have no edges, otherwise an empty text.
std::string DescribeLostSides(const QuadMesh& mesh);

/// Returns a sentence about very different sizes of quads, which have a standard deviation of more
/// than their mean, or 1 in their logarithms, and the option that may make them more equal; an
/// empty text for others, or if the request prescribes sizes.
std::string DescribeSizes(const ResolvedRequest& request, const QuadResult& quads);

/// Returns a sentence about the area that is lost, or covered beyond the boundary, where edges cut
/// off curves; an empty text if this is less than AcceptableAreaError.
std::string DescribeArea(const QuadResult& quads);

/// Returns a sentence about the region whose area its quads miss most, by their regions and the areas and names
/// of regions; an empty text if this is less than an octagon misses of a circle.
std::string DescribeRegionAreas(const QuadMesh& mesh, const std::vector<int>& region,
  const std::vector<double>& areas, const std::vector<std::string>& names);

/// Returns the clause that offers a repair of the holonomy that was found to work.
std::string RepairAdvice(const HolonomyRepair& repair);

/// Returns an error that a finer mesh did not cure, with a remedy: smoothing with a length that was
/// found to work or, if it is 0, other singularities.
Error WithSmoothing(const Error& error, double length, bool singularitiesAreGiven);
}
