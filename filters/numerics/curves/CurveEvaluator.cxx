#include "CurveEvaluator.h"

#include "Error.h"
#include "Index.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace crossfield
{
namespace
{
void RequireNurbs(const PlaneCurve& curve)
{
  const std::size_t count = curve.points.size();
  const bool isValid = curve.degree >= 1 && curve.degree <= MaximumDegree &&
    count > Index(curve.degree) && curve.weights.size() == count &&
    curve.knots.size() == count + Index(curve.degree) + 1 &&
    std::is_sorted(curve.knots.begin(), curve.knots.end()) &&
    curve.knots[curve.degree] < curve.knots[count] &&
    std::all_of(
      curve.weights.begin(), curve.weights.end(), [](double weight) { return weight > 0.0; });
  if (!isValid)
  {
    throw Error(
      "A NURBS curve of the boundary has numbers of knots, points and weights that do not "
      "match, or weights that are not positive; correct the drawing.");
  }
}
}

CurveEvaluator::CurveEvaluator(PlaneCurve curve)
  : Data(std::move(curve))
  , End(2.0 * Pi)
{
  if (this->Data.kind == PlaneCurve::Kind::Line)
  {
    throw Error("A line of the boundary has no curve to evaluate; use its segments.");
  }
  if (this->Data.kind == PlaneCurve::Kind::Nurbs)
  {
    RequireNurbs(this->Data);
    this->Start = this->Data.knots[this->Data.degree];
    this->End = this->Data.knots[this->Data.points.size()];
    this->Closed = false;
  }
  this->TakeSamples();
  if (!(this->Extent > 0.0))
  {
    throw Error("A curve of the boundary has no length; correct the drawing.");
  }
  if (this->Data.kind == PlaneCurve::Kind::Nurbs &&
    (this->Samples.front() - this->Samples.back()).norm() <= 1e-12 * this->Extent)
  {
    this->Closed = true;
    this->Samples.pop_back(); // the first sample again
    this->Parameters.pop_back();
  }
  this->FormBlocks();
}

void CurveEvaluator::TakeSamples()
{
  if (this->Data.kind == PlaneCurve::Kind::Nurbs)
  {
    // Each span between two knots has several samples between its inflections, of which there are
    // less than its degree.
    const int perSpan = 2 * (this->Data.degree + 1);
    for (std::size_t k = Index(this->Data.degree); k < this->Data.points.size(); ++k)
    {
      const double from = this->Data.knots[k];
      const double to = this->Data.knots[k + 1];
      for (int i = 0; i < perSpan && to > from; ++i)
      {
        this->Parameters.push_back(from + (to - from) * i / perSpan);
      }
    }
    this->Parameters.push_back(this->End);
  }
  else
  {
    constexpr int Count = 64;
    for (int i = 0; i < Count; ++i)
    {
      this->Parameters.push_back(2.0 * Pi * i / Count);
    }
  }
  Point low = Point::Constant(std::numeric_limits<double>::infinity());
  Point high = -low;
  for (const double parameter : this->Parameters)
  {
    this->Samples.push_back(this->FrameAt(parameter).place);
    low = low.cwiseMin(this->Samples.back());
    high = high.cwiseMax(this->Samples.back());
  }
  this->Extent = (high - low).norm();
}

void CurveEvaluator::FormBlocks()
{
  const std::size_t count = this->Samples.size();
  const auto size = static_cast<std::size_t>(std::sqrt(static_cast<double>(count))) + 1;
  for (std::size_t first = 0; first < count; first += size)
  {
    SampleBlock block;
    block.first = first;
    block.end = std::min(first + size, count);
    for (std::size_t i = block.first; i < block.end; ++i)
    {
      block.centre += this->Samples[i] / static_cast<double>(block.end - block.first);
      this->Spacing =
        std::max(this->Spacing, (this->Samples[(i + 1) % count] - this->Samples[i]).norm());
    }
    for (std::size_t i = block.first; i < block.end; ++i)
    {
      block.radius = std::max(block.radius, (this->Samples[i] - block.centre).norm());
    }
    this->Blocks.push_back(block);
  }
}

std::vector<std::size_t> CurveEvaluator::SamplesNear(const Point& place) const
{
  // The nearest point of the curve is within half the spacing of a sample, so that sample is at
  // most the spacing farther away than the nearest one.
  double smallest = std::numeric_limits<double>::infinity();
  for (const SampleBlock& block : this->Blocks)
  {
    smallest = std::min(smallest, (block.centre - place).norm() + block.radius);
  }
  const auto isNear = [&](const SampleBlock& block)
  { return (block.centre - place).norm() - block.radius <= smallest + this->Spacing; };
  const auto distanceOf = [&](std::size_t i) { return (this->Samples[i] - place).norm(); };
  for (const SampleBlock& block : this->Blocks)
  {
    for (std::size_t i = block.first; i < block.end && isNear(block); ++i)
    {
      smallest = std::min(smallest, distanceOf(i));
    }
  }
  const std::size_t count = this->Samples.size();
  std::vector<std::size_t> minima;
  for (const SampleBlock& block : this->Blocks)
  {
    for (std::size_t i = block.first; i < block.end && isNear(block); ++i)
    {
      const double distance = distanceOf(i);
      const bool isFirst = i == 0 && !this->Closed;
      const bool isLast = i + 1 == count && !this->Closed;
      if (distance <= smallest + this->Spacing &&
        (isFirst || distance <= distanceOf((i + count - 1) % count)) &&
        (isLast || distance <= distanceOf((i + 1) % count)))
      {
        minima.push_back(i);
      }
    }
  }
  const std::size_t kept = std::min<std::size_t>(3, minima.size());
  std::partial_sort(minima.begin(), minima.begin() + static_cast<std::ptrdiff_t>(kept),
    minima.end(), [&](std::size_t a, std::size_t b) { return distanceOf(a) < distanceOf(b); });
  minima.resize(kept);
  return minima;
}

double CurveEvaluator::Limit(double parameter) const
{
  if (!this->Closed)
  {
    return std::clamp(parameter, this->Start, this->End);
  }
  if (parameter >= this->Start && parameter <= this->End)
  {
    return parameter;
  }
  const double period = this->Period();
  const double turns = std::floor((parameter - this->Start) / period);
  return std::clamp(parameter - turns * period, this->Start, this->End);
}

CurveFrame CurveEvaluator::FrameAt(double parameter) const
{
  return FrameOf(this->Data, this->Limit(parameter));
}

Point CurveEvaluator::At(double parameter) const
{
  return this->FrameAt(parameter).place;
}

double CurveEvaluator::Curvature(double parameter) const
{
  const CurveFrame frame = this->FrameAt(parameter);
  return Cross(frame.first, frame.second) / std::pow(frame.first.norm(), 3.0);
}

double CurveEvaluator::NearestFrom(const Point& place, double guess) const
{
  // Newton's method converges quadratically; halved steps only occur far from the curve.
  constexpr int MaximumSteps = 50;
  double t = this->Closed ? guess : std::clamp(guess, this->Start, this->End);
  CurveFrame frame = this->FrameAt(t);
  double distance = (frame.place - place).squaredNorm();
  for (int step = 0; step < MaximumSteps; ++step)
  {
    const Point offset = frame.place - place;
    const double slope = offset.dot(frame.first);
    const double speed = frame.first.squaredNorm();
    const double curved = speed + offset.dot(frame.second);
    double move = -slope / (curved > 0.1 * speed ? curved : speed);
    // No step leads across more than an eighth of the curve.
    move = std::clamp(move, -0.125 * this->Period(), 0.125 * this->Period());
    double next = t;
    CurveFrame there;
    double reached = std::numeric_limits<double>::infinity();
    for (int halving = 0; halving < 30; ++halving, move *= 0.5)
    {
      next = this->Closed ? t + move : std::clamp(t + move, this->Start, this->End);
      there = this->FrameAt(next);
      reached = (there.place - place).squaredNorm();
      // Squared distances are exact to rounding of the extent only.
      if (reached <= distance + 1e-15 * this->Extent * std::sqrt(distance) ||
        std::abs(move) <= 1e-14 * this->Period())
      {
        break;
      }
    }
    const bool isDone = std::abs(next - t) <= 4.0 * std::numeric_limits<double>::epsilon() *
        std::max({ std::abs(t), std::abs(this->Start), std::abs(this->End) });
    t = next;
    frame = there;
    distance = reached;
    if (isDone)
    {
      break;
    }
  }
  return t;
}

double CurveEvaluator::Nearest(const Point& place) const
{
  if (this->Data.kind == PlaneCurve::Kind::Circle)
  {
    const Point offset = place - this->Data.centre;
    return offset.norm() > 0.0 ? AngleBetween(this->Data.axis, offset) : 0.0;
  }
  double best = this->Start;
  double smallest = std::numeric_limits<double>::infinity();
  const auto tryFrom = [&](double guess)
  {
    const double found = this->NearestFrom(place, guess);
    const double distance = (this->At(found) - place).squaredNorm();
    if (distance < smallest)
    {
      smallest = distance;
      best = found;
    }
  };
  for (const std::size_t sample : this->SamplesNear(place))
  {
    tryFrom(this->Parameters[sample]);
    if (this->MayBeCorner(sample))
    {
      // The derivative there is that of the curve after it.
      tryFrom(sample > 0 ? 0.5 * (this->Parameters[sample - 1] + this->Parameters[sample])
                         : 0.5 * (this->Parameters.back() + this->End));
    }
  }
  return best;
}

bool CurveEvaluator::MayBeCorner(std::size_t sample) const
{
  if (this->Data.kind != PlaneCurve::Kind::Nurbs)
  {
    return false;
  }
  if (sample == 0)
  {
    return this->Closed;
  }
  const auto [first, last] =
    std::equal_range(this->Data.knots.begin(), this->Data.knots.end(), this->Parameters[sample]);
  return last - first >= this->Data.degree;
}

double CurveEvaluator::Unwrap(double parameter, double near) const
{
  return this->Closed ? parameter + this->Period() * std::round((near - parameter) / this->Period())
                      : parameter;
}
}
