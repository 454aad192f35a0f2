#include "SmoothBoundary.h"

#include "BoundaryCorners.h"
#include "Error.h"
#include "LoopArc.h"
#include "MakePlanarDomain.h"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <utility>

namespace crossfield
{
namespace
{
constexpr std::size_t SamplesPerLength = 8; ///< Samples per wave of the given length.
constexpr std::size_t SamplesPerSide = 2;
constexpr double Deviation = 0.4; ///< Standard deviation of the Gaussian, in lengths.
/// Maximum number of smoothing rounds; three or four are enough for a coastline.
constexpr int MaximumRounds = 20;
/// Relative change of a curve's length below which no further round follows.
constexpr double Settled = 0.05;
/// Minimum length of a smoothed loop, in lengths; shorter loops would shrink.
constexpr double ShortestLoop = 4.0;
/// Displacement, in lengths, up to which a curve counts as smooth already.
constexpr double Unmoved = 1e-3;

/// Part of a loop between two fixed points, or an entire loop.
struct Curve
{
  /// Samples, including both ends of a part; `at` may exceed the loop's length.
  std::vector<ArcVertex> samples;
  bool isClosed = false;
};

/// Returns a sample. Beyond the ends of a part the curve continues as its point reflection in the
/// end point, so ends stay fixed and straight lines stay straight.
Point Extended(const Curve& curve, std::ptrdiff_t i)
{
  const auto count = static_cast<std::ptrdiff_t>(curve.samples.size());
  const auto place = [&](std::ptrdiff_t at) -> const Point& { return curve.samples[at].place; };
  if (curve.isClosed)
  {
    return place(((i % count) + count) % count);
  }
  const std::ptrdiff_t last = count - 1;
  // For a part shorter than the Gaussian's reach the reflections repeat, each displaced by twice
  // the vector between the ends.
  const std::ptrdiff_t period = 2 * last;
  const std::ptrdiff_t turns = (i >= 0 ? i : i - period + 1) / period;
  const std::ptrdiff_t rest = i - turns * period;
  const Point shift = 2.0 * static_cast<double>(turns) * (place(last) - place(0));
  return shift + (rest <= last ? place(rest) : Point(2.0 * place(last) - place(period - rest)));
}

/// Returns the mean with Gaussian weights at each sample.
std::vector<Point> Blurred(const Curve& curve)
{
  const double deviation = Deviation * SamplesPerLength; // in samples
  const auto reach = static_cast<std::ptrdiff_t>(std::ceil(4.0 * deviation));
  std::vector<double> weights;
  double sum = 0.0;
  for (std::ptrdiff_t i = -reach; i <= reach; ++i)
  {
    const double x = static_cast<double>(i) / deviation;
    weights.push_back(std::exp(-0.5 * x * x));
    sum += weights.back();
  }
  std::vector<Point> means;
  for (std::size_t i = 0; i < curve.samples.size(); ++i)
  {
    Point mean = Point::Zero();
    for (std::ptrdiff_t j = -reach; j <= reach; ++j)
    {
      mean += weights[j + reach] * Extended(curve, static_cast<std::ptrdiff_t>(i) + j);
    }
    means.push_back(mean / sum);
  }
  return means;
}

/// Smooths a curve by the filter 2 G − G². Unlike G alone, its displacement is of fourth order in
/// the curvature, so it preserves circles.
Curve Smoothed(const Curve& curve)
{
  Curve rest = curve;
  const std::vector<Point> means = Blurred(curve);
  for (std::size_t i = 0; i < means.size(); ++i)
  {
    rest.samples[i].place -= means[i];
  }
  const std::vector<Point> more = Blurred(rest);
  Curve smooth = curve;
  for (std::size_t i = 0; i < means.size(); ++i)
  {
    smooth.samples[i].place = means[i] + more[i];
  }
  return smooth;
}

/// Resamples a curve at equal distances of at most `spacing`; `round` is the length of the loop.
Curve Resample(const Curve& curve, double spacing, double round)
{
  std::vector<ArcVertex> points = curve.samples;
  if (curve.isClosed)
  {
    points.push_back(points.front());
    points.back().at += round;
  }
  std::vector<double> starts{ 0.0 };
  for (std::size_t i = 1; i < points.size(); ++i)
  {
    starts.push_back(starts.back() + (points[i].place - points[i - 1].place).norm());
  }
  const std::size_t count = std::max<std::size_t>(curve.isClosed ? 8 : 1,
    static_cast<std::size_t>(std::ceil(starts.back() / spacing / SamplesPerSide)) * SamplesPerSide);
  Curve result;
  result.isClosed = curve.isClosed;
  std::size_t side = 0;
  for (std::size_t i = 0; i < (curve.isClosed ? count : count + 1); ++i)
  {
    const double at = starts.back() * static_cast<double>(i) / static_cast<double>(count);
    while (side + 2 < points.size() && starts[side + 1] < at)
    {
      ++side;
    }
    const double extent = starts[side + 1] - starts[side];
    const double part = extent > 0.0 ? std::min(1.0, (at - starts[side]) / extent) : 0.0;
    result.samples.push_back({ points[side].at + part * (points[side + 1].at - points[side].at),
      points[side].place + part * (points[side + 1].place - points[side].place) });
  }
  return result;
}

double LengthOf(const Curve& curve)
{
  double length = 0.0;
  for (std::size_t i = 1; i < curve.samples.size(); ++i)
  {
    length += (curve.samples[i].place - curve.samples[i - 1].place).norm();
  }
  return length +
    (curve.isClosed ? (curve.samples.front().place - curve.samples.back().place).norm() : 0.0);
}

/// Returns the vertices of the smoothed curve, without the end of a part; none if the curve is
/// smooth already.
std::vector<ArcVertex> SmoothCurve(const Curve& given, double length, double round)
{
  const double spacing = length / SamplesPerLength;
  Curve curve = Resample(given, spacing, round);
  for (int i = 0; i < MaximumRounds; ++i)
  {
    const Curve smooth = Smoothed(curve);
    double moved = 0.0;
    for (std::size_t j = 0; j < smooth.samples.size(); ++j)
    {
      moved = std::max(moved, (smooth.samples[j].place - curve.samples[j].place).norm());
    }
    if (i == 0 && moved <= Unmoved * length)
    {
      return {};
    }
    const bool isSettled = LengthOf(smooth) > (1.0 - Settled) * LengthOf(curve);
    // The wavelength measured along a ragged curve exceeds the true one, so the curve is resampled
    // by its new length.
    curve = Resample(smooth, spacing, round);
    if (isSettled)
    {
      break;
    }
  }
  std::vector<ArcVertex> vertices;
  const std::size_t count = curve.samples.size() - (curve.isClosed ? 0 : 1);
  for (std::size_t i = 0; i < count; i += SamplesPerSide)
  {
    vertices.push_back(curve.samples[i]);
  }
  return vertices;
}

/// Returns the arc lengths of the fixed points of a loop: given points, and corners farther than a
/// length from all others.
std::vector<double> FindKept(
  const LoopArc& arc, const std::vector<double>& given, double length, double cornerAngle)
{
  const std::vector<double> corners = arc.Corners(cornerAngle);
  std::vector<double> kept = given;
  for (std::size_t i = 0; i < corners.size(); ++i)
  {
    const double before = i > 0 ? corners[i - 1] : corners.back() - arc.Length();
    const double after = i + 1 < corners.size() ? corners[i + 1] : corners.front() + arc.Length();
    if (corners[i] - before > length && after - corners[i] > length)
    {
      kept.push_back(corners[i]);
    }
  }
  std::sort(kept.begin(), kept.end());
  const double rounding = 1e-9 * arc.Length();
  kept.erase(
    std::unique(kept.begin(), kept.end(), [&](double a, double b) { return b - a <= rounding; }),
    kept.end());
  return kept;
}

/// Returns the vertices of a loop from one arc length to another, including both ends.
std::vector<ArcVertex> Between(const LoopArc& arc, double from, double to)
{
  std::vector<ArcVertex> vertices{ { from, arc.At(from) } };
  const double rounding = 1e-9 * arc.Length();
  for (const double start : { 0.0, arc.Length() })
  {
    for (std::size_t i = 0; i < arc.Vertices().size(); ++i)
    {
      const double at = arc.Start(i) + start;
      if (at > from + rounding && at < to - rounding)
      {
        vertices.push_back({ at, arc.Vertices()[i] });
      }
    }
  }
  vertices.push_back({ to, arc.At(to) });
  return vertices;
}

std::vector<ArcVertex> SmoothLoop(
  const LoopArc& arc, const std::vector<double>& kept, double length)
{
  std::vector<ArcVertex> vertices;
  const auto add = [&](const Curve& curve)
  {
    std::vector<ArcVertex> smooth = SmoothCurve(curve, length, arc.Length());
    if (smooth.empty())
    {
      smooth = curve.samples;
      smooth.resize(smooth.size() - (curve.isClosed ? 0 : 1));
    }
    vertices.insert(vertices.end(), smooth.begin(), smooth.end());
  };
  if (kept.empty())
  {
    Curve curve;
    curve.isClosed = true;
    curve.samples = Between(arc, 0.0, arc.Length());
    curve.samples.pop_back();
    add(curve);
  }
  for (std::size_t i = 0; i < kept.size(); ++i)
  {
    const double end = i + 1 < kept.size() ? kept[i + 1] : kept[0] + arc.Length();
    add({ Between(arc, kept[i], end), false });
  }
  for (ArcVertex& vertex : vertices)
  {
    vertex.at = std::fmod(vertex.at, arc.Length());
  }
  std::sort(vertices.begin(), vertices.end(),
    [](const ArcVertex& a, const ArcVertex& b) { return a.at < b.at; });
  return vertices;
}
}

//------------------------------------------------------------------------------
SimplifiedBoundary SmoothBoundary(
  const PlanarDomain& domain, double length, const std::vector<Point>& keep, double cornerAngle)
{
  SimplifiedBoundary result;
  std::vector<Loop> loops;
  for (const Loop& loop : domain.loops)
  {
    const LoopArc arc(loop);
    if (arc.Length() < ShortestLoop * length)
    {
      loops.push_back(loop);
      continue;
    }
    const std::vector<double> given = arc.FindAll(keep, BoundaryReach * domain.Diagonal());
    const std::vector<ArcVertex> vertices =
      SmoothLoop(arc, FindKept(arc, given, length, cornerAngle), length);
    result.moved = std::max(result.moved, LargestDistance(arc, vertices));
    loops.push_back(PositionsOf(vertices));
  }
  try
  {
    result.domain = MakePlanarDomain(std::move(loops));
  }
  catch (const Error&)
  {
    std::ostringstream text;
    text << "The boundary, smoothed by " << length
         << ", crosses itself or lies beyond an inner loop; give a shorter length.";
    throw Error(text.str());
  }
  return result;
}
}
