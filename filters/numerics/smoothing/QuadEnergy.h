#pragma once

#include "OrderEnergy.h"
#include "PointCorners.h"
#include "QuadMesh.h"

#include <Eigen/Core>

#include <array>
#include <cstddef>
#include <optional>

namespace crossfield
{
/// Minimum number of unknowns in a part: a pass over vectors does little with each.
constexpr std::ptrdiff_t MinimumUnknowns = 20000;

/// The shape energy of a quad mesh (docs/method.md §14.5; Garanzha et al. 2021): at each corner of
/// each quad, with J the map from the target rectangle and D = det J,
///   f = (1 − a) |J|² / χ + a (D² + 1) / χ,  χ = (D + √(D² + ε²)) / 2.
/// The minimum is 2, where J is a rotation. The energy is the sum of 2/p (f/2)^p, p = 1 unless
/// SetPower changes it: the larger p, the more evenly it distributes a deviation that cannot vanish.
///
/// There are two unknowns per point: inside, its coordinates (TangentFrames); on the boundary, the length along
/// the polyline, and 0. On a surface, corners are seen in the planes of their quads. Fixed points have unknowns
/// as well, with zero gradient, and so have images of points of periodic sides, which move with these points.
class QuadEnergy
{
public:
  /// Constructs the energy of a mesh. `moves` marks the points that are not fixed, `sizePart` is a,
  /// `weights` are factors of the quads, `surface` is null in the plane.
  QuadEnergy(const QuadMesh& mesh, const BoundaryCurves& curves, const std::vector<bool>& moves,
    double sizePart, std::vector<double> weights, const SurfaceWalk* surface = nullptr);

  /// Returns the unknowns of the mesh as it is.
  Eigen::VectorXd Unknowns() const;
  void SetPower(double power) { this->Power = power; }
  /// Adds an OrderEnergy: points that slide along the boundary keep their order.
  void HoldOrderOnBoundary();
  /// Subtracts tilt · (unknowns − origin) from the energy, to prescribe the gradient at the origin.
  void Tilt(const Eigen::VectorXd& tilt, const Eigen::VectorXd& origin);
  /// Returns displacements with those of fixed points set to 0.
  Eigen::VectorXd Masked(Eigen::VectorXd moves) const;
  /// Returns displacements with those of images along the boundary, which lead backwards.
  Eigen::VectorXd WithImages(Eigen::VectorXd moves) const;
  /// Applies the transpose of WithImages to a gradient.
  Eigen::VectorXd WithoutImages(Eigen::VectorXd gradient) const;
  /// Moves the points of a mesh to the given unknowns. Returns how far a point is at most from where its tangent plane
  /// has it, in parts of its edges.
  double Store(const Eigen::VectorXd& unknowns, QuadMesh& mesh) const;
  const TangentFrames& GetFrames() const { return this->Frames; }
  /// Returns the energy if all quads are their target rectangles, the minimum possible.
  double IdealValue() const { return this->Ideal / this->Power; }
  /// Returns the energy, and its gradient if requested. With ε = 0 it is infinite if a corner is
  /// not positive; then the gradient is not set. Bitwise the same for any number of threads.
  double Value(const Eigen::VectorXd& unknowns, double epsilon, Eigen::VectorXd* gradient);
  /// Returns the minimum of D over all corners.
  double MinimumDeterminant(const Eigen::VectorXd& unknowns);
  /// Returns an approximate diagonal of the Hessian: per unknown, the inverse squares of the
  /// lengths that it changes; 1 for fixed unknowns.
  const Eigen::VectorXd& Curvature() const { return this->Diagonal; }

private:
  /// A point whose position is the image of that of another point.
  struct Image
  {
    int first;
    int second;
    const PairedSides* pair;
    RigidMotion motion;
    Eigen::Matrix2d rotation;
  };

  /// Collects the images, of points that move.
  void FindImages(const std::vector<bool>& moves);
  /// Returns the position of a point on the boundary.
  CurvePlace PlaceOf(int point, const Eigen::VectorXd& unknowns) const
  {
    return { this->Mesh.points[point].curve.loop, unknowns[FirstUnknown(point)] };
  }
  /// Sets Positions.
  void SetPositions(const Eigen::VectorXd& unknowns);
  /// Returns the energy of a range of the quads. Calls store(quad, gradients at its four points) for
  /// each of them.
  template <typename StoreQuad>
  double RangeValue(int begin, int end, double epsilon, const StoreQuad& store) const;
  /// Returns the energy of all quads, and sets its gradient by the coordinates if requested.
  double QuadsValue(double epsilon, Eigen::VectorXd* gradient);
  const QuadMesh& Mesh;
  const BoundaryCurves& Curves;
  const double SizePart;
  const std::vector<double> Weights;
  const TangentFrames Frames;
  double Power = 1.0;
  double Ideal = 0.0;     ///< With p = 1.
  std::vector<int> Fixed; ///< Fixed points and images.
  std::vector<Image> Images;
  std::vector<int> OnBoundary; ///< Points that move along the boundary.
  OrderEnergy Order;
  Eigen::VectorXd Diagonal;
  Eigen::VectorXd Slope;                     ///< The tilt, empty if there is none.
  Eigen::VectorXd Origin;                    ///< Unknowns at which the tilt vanishes.
  Eigen::VectorXd Positions;                 ///< Coordinates of all points.
  std::vector<std::array<Point, 4>> OfQuads; ///< Gradients of the quads, if they are in parts.
  std::optional<PointCorners> Corners;       ///< Made for gradients in several parts.
};
}
