#pragma once

#include "IndexForm.h"
#include "SizeSearchOptions.h"

#include <memory>

namespace crossfield
{
/// Returns the number of quads of target sizes where these change.
double CountGradedQuads(const PlanarDomain& domain, const SizeFunction& size);

/// How far the sizes of fields are from target sizes, as a quadratic form in the quarter indices at
/// sites (docs/method.md §5.11). With H the logarithm of the size of a field, s the target size,
/// D = H − log s, and weights of the vertices that count half by area and half by quads,
///   w_v = ½ m_v / Σ m + ½ (m_v / s_v²) / Σ (m / s²),
/// and at least a fifth where sizes change, its value is
///   10⁴ ½ |D − D̄|²_w + ε W + λ |δ|²,
/// with W for cores of the size s and δ the holonomy defects.
class SizeForm
{
public:
  /// The form at some sites.
  struct AtSites
  {
    IndexForm form;
    Eigen::VectorXd weights;  ///< w.
    Eigen::VectorXd constant; ///< D − D̄ without indices at the sites, at the vertices.
    Eigen::MatrixXd columns;  ///< Change of D − D̄ by a quarter at each site.

    /// Returns |D − D̄|_w.
    double SpreadOf(const Eigen::VectorXi& indices) const;
  };

  /// Meshes a domain so finely that target sizes are resolved. Throws Error where a size is not
  /// positive.
  SizeForm(const PlanarDomain& domain, const SizeSearchOptions& options, const Progress& progress);

  /// Returns the form at sites with λ = `defectWeight`.
  AtSites FormAt(const std::vector<Point>& sites, double defectWeight) const;

  const TriangleMesh& Mesh() const { return this->Topology->mesh; }

private:
  /// Returns H from R and the logarithms, with means over the cells of the vertices.
  Eigen::VectorXd LogSizes(
    const Eigen::VectorXd& regular, const std::vector<LogSource>& logs) const;

  SizeFunction Size;
  SharedPlanarTopology Topology;
  int Total = 0;                ///< Sum of the quarter indices at sites.
  Point Anchor = Point::Zero(); ///< Place that has all of them without indices at sites.
  std::unique_ptr<const StrengthChanges> Changes;
  Eigen::VectorXd Weights;
  Eigen::VectorXd SquaredCores; ///< Squared smoothing radii of logarithms.
  Eigen::VectorXd Given;        ///< D with the given singularities and all indices at the anchor.
};
}
