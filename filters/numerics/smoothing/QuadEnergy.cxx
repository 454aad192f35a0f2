#include "QuadEnergy.h"

#include "Index.h"
#include "Parts.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace crossfield
{
namespace
{
/// Minimum number of quads in a part: their energy takes half a millisecond.
constexpr std::ptrdiff_t MinimumQuads = 10000;

/// The sides of a quad divided by their target lengths, two in each direction. Corner (i, j) is
/// between a_i and b_j.
struct QuadFrame
{
  std::array<Point, 2> a;
  std::array<Point, 2> b;
  double inverseA = 0.0;
  double inverseB = 0.0;

  double Determinant(std::size_t i, std::size_t j) const { return Cross(this->a[i], this->b[j]); }
};

QuadFrame FrameOf(const QuadMesh& mesh, const TangentFrames& frames,
  const Eigen::VectorXd& positions, std::size_t quad)
{
  const auto at = [&](std::size_t corner) -> Point
  {
    return frames.InQuad(
      quad, corner, positions.segment<2>(FirstUnknown(mesh.quads[quad][corner])));
  };
  const std::array<Point, 4> p = { at(0), at(1), at(2), at(3) };
  QuadFrame frame;
  frame.inverseA = 1.0 / mesh.targetLengths[quad][0];
  frame.inverseB = 1.0 / mesh.targetLengths[quad][1];
  frame.a = { Point(frame.inverseA * (p[1] - p[0])), Point(frame.inverseA * (p[2] - p[3])) };
  frame.b = { Point(frame.inverseB * (p[3] - p[0])), Point(frame.inverseB * (p[2] - p[1])) };
  return frame;
}

/// Returns χ = (D + root) / 2 with root = √(D² + ε²), without cancellation.
double Regularised(double determinant, double root, double epsilon)
{
  return determinant >= 0.0 ? 0.5 * (determinant + root)
                            : 0.5 * epsilon * epsilon / (root - determinant);
}
}

QuadEnergy::QuadEnergy(const QuadMesh& mesh, const BoundaryCurves& curves,
  const std::vector<bool>& moves, double sizePart, std::vector<double> weights,
  const SurfaceWalk* surface)
  : Mesh(mesh)
  , Curves(curves)
  , SizePart(sizePart)
  , Weights(std::move(weights))
  , Frames(mesh, surface)
{
  const auto size = 2 * static_cast<Eigen::Index>(mesh.points.size());
  this->Diagonal = Eigen::VectorXd::Zero(size);
  for (std::size_t q = 0; q < mesh.quads.size(); ++q)
  {
    this->Ideal += 8.0 * this->Weights[q];
    const double curvature = 1.0 / (mesh.targetLengths[q][0] * mesh.targetLengths[q][0]) +
      1.0 / (mesh.targetLengths[q][1] * mesh.targetLengths[q][1]);
    for (const int p : mesh.quads[q])
    {
      this->Diagonal.segment<2>(FirstUnknown(p)).array() += 4.0 * this->Weights[q] * curvature;
    }
  }
  this->FindImages(moves);
  std::vector<bool> isImage(mesh.points.size(), false);
  for (const Image& image : this->Images)
  {
    isImage[image.second] = true;
    this->Diagonal.segment<2>(FirstUnknown(image.first)) +=
      this->Diagonal.segment<2>(FirstUnknown(image.second));
  }
  for (int p = 0; p < static_cast<int>(mesh.points.size()); ++p)
  {
    if (!moves[p] || isImage[p])
    {
      this->Fixed.push_back(p);
      this->Diagonal.segment<2>(FirstUnknown(p)).setOnes();
    }
    else if (mesh.points[p].curve.loop >= 0)
    {
      this->OnBoundary.push_back(p);
      this->Diagonal[FirstUnknown(p) + 1] = 1.0;
    }
  }
}

void QuadEnergy::FindImages(const std::vector<bool>& moves)
{
  for (const PairedSides& pair : this->Mesh.periodic)
  {
    const RigidMotion& motion = pair.motion;
    for (const auto& [first, second] : pair.nodes)
    {
      if (moves[first] && moves[second] && first != second)
      {
        this->Images.push_back({ first, second, &pair, motion, motion.Rotation() });
      }
    }
  }
}

Eigen::VectorXd QuadEnergy::Unknowns() const
{
  Eigen::VectorXd unknowns(this->Diagonal.size());
  for (int p = 0; p < static_cast<int>(this->Mesh.points.size()); ++p)
  {
    unknowns.segment<2>(FirstUnknown(p)) =
      this->Frames.CoordinatesOf(p, this->Mesh.points[p].place);
  }
  for (const int p : this->OnBoundary)
  {
    unknowns.segment<2>(FirstUnknown(p)) << this->Mesh.points[p].curve.at, 0.0;
  }
  return unknowns;
}

void QuadEnergy::Tilt(const Eigen::VectorXd& tilt, const Eigen::VectorXd& origin)
{
  this->Slope = tilt;
  this->Origin = origin;
}

Eigen::VectorXd QuadEnergy::Masked(Eigen::VectorXd moves) const
{
  for (const int p : this->Fixed)
  {
    moves.segment<2>(FirstUnknown(p)).setZero();
  }
  return moves;
}

Eigen::VectorXd QuadEnergy::WithImages(Eigen::VectorXd moves) const
{
  for (const Image& image : this->Images)
  {
    moves.segment<2>(FirstUnknown(image.second)) << -moves[FirstUnknown(image.first)], 0.0;
  }
  return moves;
}

Eigen::VectorXd QuadEnergy::WithoutImages(Eigen::VectorXd gradient) const
{
  for (const Image& image : this->Images)
  {
    gradient[FirstUnknown(image.first)] -= gradient[FirstUnknown(image.second)];
    gradient.segment<2>(FirstUnknown(image.second)).setZero();
  }
  return gradient;
}

double QuadEnergy::Store(const Eigen::VectorXd& unknowns, QuadMesh& mesh) const
{
  std::vector<bool> slides(mesh.points.size(), false);
  for (const int p : this->OnBoundary)
  {
    slides[p] = true;
    QuadPoint& point = mesh.points[p];
    point.curve.at = unknowns[FirstUnknown(p)];
    this->Frames.MoveTo(p, this->Curves.PlaceAt(point.curve), point);
    point.triangle = this->Curves.TriangleAt(point.curve, point.triangle);
  }
  double farthest = 0.0;
  for (int p = 0; p < static_cast<int>(mesh.points.size()); ++p)
  {
    if (!slides[p])
    {
      const Eigen::Index first = FirstUnknown(p);
      const double distance = this->Frames.Move(p, unknowns.segment<2>(first), mesh.points[p]);
      // The diagonal is 32 / length² at a point of four squares.
      farthest = std::max(farthest, distance * std::sqrt(this->Diagonal[first] / 32.0));
    }
  }
  for (const Image& image : this->Images)
  {
    QuadPoint& point = mesh.points[image.second];
    const QuadPoint& first = mesh.points[image.first];
    this->Frames.MoveTo(image.second, image.motion.ImageOf(first.place), point);
    point.curve = this->Curves.ImageOn(*image.pair, 1, point.curve.loop, first.curve, point.place);
    point.triangle = this->Curves.TriangleAt(point.curve, point.triangle);
  }
  return farthest;
}

void QuadEnergy::SetPositions(const Eigen::VectorXd& unknowns)
{
  this->Positions.resize(unknowns.size());
  ForRanges(
    unknowns.size(),
    [&](int begin, int end)
    { this->Positions.segment(begin, end - begin) = unknowns.segment(begin, end - begin); },
    MinimumUnknowns);
  for (const int p : this->OnBoundary)
  {
    this->Positions.segment<2>(FirstUnknown(p)) =
      this->Frames.CoordinatesOf(p, this->Curves.PlaceAt(this->PlaceOf(p, unknowns)));
  }
  for (const Image& image : this->Images)
  {
    this->Positions.segment<2>(FirstUnknown(image.second)) = this->Curves.IsInPlane()
      ? Point(image.rotation * this->Positions.segment<2>(FirstUnknown(image.first)) +
          image.motion.shift)
      : this->Frames.CoordinatesOf(
          image.second, this->Curves.PlaceAt(this->PlaceOf(image.first, unknowns)));
  }
}

template <typename StoreQuad>
double QuadEnergy::RangeValue(int begin, int end, double epsilon, const StoreQuad& store) const
{
  double energy = 0.0;
  for (std::size_t q = Index(begin); q < Index(end); ++q)
  {
    const QuadFrame frame = FrameOf(this->Mesh, this->Frames, this->Positions, q);
    const double weight = this->Weights[q];
    std::array<Point, 2> byA = { Point::Zero(), Point::Zero() };
    std::array<Point, 2> byB = { Point::Zero(), Point::Zero() };
    for (std::size_t i = 0; i < 2; ++i)
    {
      for (std::size_t j = 0; j < 2; ++j)
      {
        const Point& a = frame.a[i];
        const Point& b = frame.b[j];
        const double determinant = frame.Determinant(i, j);
        if (epsilon <= 0.0 && !(determinant > 0.0))
        {
          return std::numeric_limits<double>::infinity();
        }
        const double root =
          epsilon <= 0.0 ? determinant : std::sqrt(determinant * determinant + epsilon * epsilon);
        double inverse = weight / Regularised(determinant, root, epsilon);
        double value = inverse *
          ((1.0 - this->SizePart) * (a.squaredNorm() + b.squaredNorm()) +
            this->SizePart * (determinant * determinant + 1.0));
        if (this->Power != 1.0)
        {
          // The derivative of 2/p (f/2)^p is (f/2)^(p − 1) times that of f.
          const double factor = std::pow(0.5 * value / weight, this->Power - 1.0);
          inverse *= factor;
          value *= factor;
        }
        energy += value / this->Power;
        // The derivative of Cross(a, b) is (b_y, −b_x) with respect to a and (−a_y, a_x) with
        // respect to b; ∂χ / ∂D = χ / root.
        const double byNorm = 2.0 * (1.0 - this->SizePart) * inverse;
        const double byDeterminant = 2.0 * this->SizePart * determinant * inverse - value / root;
        byA[i] += byNorm * a + byDeterminant * Point(b.y(), -b.x());
        byB[j] += byNorm * b + byDeterminant * TurnedLeft(a);
      }
    }
    std::array<Point, 4> gradient = { Point(-(frame.inverseA * byA[0] + frame.inverseB * byB[0])),
      Point(frame.inverseA * byA[0] - frame.inverseB * byB[1]),
      Point(frame.inverseA * byA[1] + frame.inverseB * byB[1]),
      Point(frame.inverseB * byB[0] - frame.inverseA * byA[1]) };
    for (std::size_t c = 0; c < 4; ++c)
    {
      gradient[c] = this->Frames.FromQuad(q, c, gradient[c]);
    }
    store(q, gradient);
  }
  return energy;
}

double QuadEnergy::QuadsValue(double epsilon, Eigen::VectorXd* gradient)
{
  const auto quads = static_cast<std::ptrdiff_t>(this->Mesh.quads.size());
  if (gradient == nullptr)
  {
    const auto none = [](std::size_t, const std::array<Point, 4>&) {};
    return SumOfRanges(
      quads, [&](int begin, int end) { return this->RangeValue(begin, end, epsilon, none); },
      MinimumQuads);
  }
  if (PartCount(quads, MinimumQuads) == 1)
  {
    gradient->setZero(this->Positions.size());
    return this->RangeValue(0, static_cast<int>(quads), epsilon,
      [&](std::size_t q, const std::array<Point, 4>& ofQuad)
      {
        for (std::size_t i = 0; i < 4; ++i)
        {
          gradient->segment<2>(FirstUnknown(this->Mesh.quads[q][i])) += ofQuad[i];
        }
      });
  }
  // The gradients of the quads, then their sum at each point, in the same order as above.
  gradient->resize(this->Positions.size());
  if (!this->Corners)
  {
    this->Corners.emplace(this->Mesh);
    this->OfQuads.resize(this->Mesh.quads.size());
  }
  const double energy = SumOfRanges(
    quads,
    [&](int begin, int end)
    {
      return this->RangeValue(begin, end, epsilon,
        [&](std::size_t q, const std::array<Point, 4>& ofQuad) { this->OfQuads[q] = ofQuad; });
    },
    MinimumQuads);
  if (std::isfinite(energy))
  {
    ForRanges(
      static_cast<std::ptrdiff_t>(this->Mesh.points.size()),
      [&](int begin, int end)
      {
        for (int p = begin; p < end; ++p)
        {
          auto sum = gradient->segment<2>(FirstUnknown(p));
          sum.setZero();
          for (int i = this->Corners->Begin(p); i < this->Corners->Begin(p + 1); ++i)
          {
            const int corner = this->Corners->Get(i);
            sum += this->OfQuads[corner / 4][corner % 4];
          }
        }
      },
      MinimumQuads);
  }
  return energy;
}

double QuadEnergy::Value(const Eigen::VectorXd& unknowns, double epsilon, Eigen::VectorXd* gradient)
{
  this->SetPositions(unknowns);
  double energy = this->QuadsValue(epsilon, gradient);
  if (this->Slope.size() > 0)
  {
    energy -= SumOfRanges(
      unknowns.size(),
      [&](int begin, int end)
      {
        const int size = end - begin;
        return this->Slope.segment(begin, size)
          .dot(unknowns.segment(begin, size) - this->Origin.segment(begin, size));
      },
      MinimumUnknowns);
  }
  if (gradient == nullptr || !std::isfinite(energy))
  {
    return energy + this->Order.Value(unknowns, nullptr);
  }
  const bool isInPlane = this->Curves.IsInPlane();
  for (std::size_t i = 0; isInPlane && i < this->Images.size(); ++i)
  {
    const Image& image = this->Images[i];
    gradient->segment<2>(FirstUnknown(image.first)) +=
      image.rotation.transpose() * gradient->segment<2>(FirstUnknown(image.second));
  }
  // The derivative by the arc length of a point with a gradient by its coordinates.
  const auto byLength = [&](int p, const SpacePoint& along)
  {
    const Point byCoordinates = gradient->segment<2>(FirstUnknown(p));
    return byCoordinates.dot(this->Frames.ComponentsOf(p, along));
  };
  for (const int p : this->OnBoundary)
  {
    const SpacePoint along = this->Curves.DirectionAt(this->PlaceOf(p, unknowns));
    gradient->segment<2>(FirstUnknown(p)) << byLength(p, along), 0.0;
  }
  for (std::size_t i = 0; !isInPlane && i < this->Images.size(); ++i)
  {
    const Image& image = this->Images[i];
    const SpacePoint along = this->Curves.DirectionAt(this->PlaceOf(image.first, unknowns));
    (*gradient)[FirstUnknown(image.first)] += byLength(image.second, along);
  }
  if (this->Slope.size() > 0)
  {
    ForRanges(
      unknowns.size(),
      [&](int begin, int end)
      { gradient->segment(begin, end - begin) -= this->Slope.segment(begin, end - begin); },
      MinimumUnknowns);
  }
  energy += this->Order.Value(unknowns, gradient);
  for (const int p : this->Fixed)
  {
    gradient->segment<2>(FirstUnknown(p)).setZero();
  }
  return energy;
}

void QuadEnergy::HoldOrderOnBoundary()
{
  std::vector<bool> isFixed(this->Mesh.points.size(), false);
  for (const int p : this->Fixed)
  {
    isFixed[p] = true;
  }
  std::vector<bool> isImage(this->Mesh.points.size(), false);
  for (const Image& image : this->Images)
  {
    isImage[image.second] = true;
  }
  this->Order = OrderEnergy(this->Mesh, this->Curves, isFixed, isImage);
}

double QuadEnergy::MinimumDeterminant(const Eigen::VectorXd& unknowns)
{
  this->SetPositions(unknowns);
  const auto quads = static_cast<std::ptrdiff_t>(this->Mesh.quads.size());
  std::vector<double> minima(
    PartCount(quads, MinimumQuads), std::numeric_limits<double>::infinity());
  ForParts(minima.size(),
    [&](std::size_t part)
    {
      double& minimum = minima[part];
      const auto [begin, end] = PartRange(quads, part, minima.size());
      for (std::size_t q = Index(begin); q < Index(end); ++q)
      {
        const QuadFrame frame = FrameOf(this->Mesh, this->Frames, this->Positions, q);
        minimum = std::min({ minimum, frame.Determinant(0, 0), frame.Determinant(0, 1),
          frame.Determinant(1, 0), frame.Determinant(1, 1) });
      }
    });
  return *std::min_element(minima.begin(), minima.end());
}
}
