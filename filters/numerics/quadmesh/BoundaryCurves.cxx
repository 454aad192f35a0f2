#include "BoundaryCurves.h"

#include "Index.h"

#include <cmath>
#include <utility>

namespace crossfield
{
BoundaryCurves::BoundaryCurves(const std::vector<Loop>& loops, const CurvedBoundary& boundary)
  : Arcs(loops.begin(), loops.end())
  , Curved(boundary, this->Arcs)
{
}

BoundaryCurves::BoundaryCurves(std::vector<ClosedPolyline<SpacePoint>> loops)
  : InSpace(std::move(loops))
{
}

SpacePoint BoundaryCurves::PlaceAt(const CurvePlace& place) const
{
  return this->IsInPlane() ? crossfield::InSpace(this->At(place))
                           : this->InSpace[place.loop].At(place.at);
}

SpacePoint BoundaryCurves::DirectionAt(const CurvePlace& place) const
{
  return this->IsInPlane() ? crossfield::InSpace(this->Tangent(place))
                           : this->InSpace[place.loop].Tangent(place.at);
}

double BoundaryCurves::Length(int loop) const
{
  return this->IsInPlane() ? this->ArcOf(loop).Length() : this->InSpace[loop].Length();
}

double BoundaryCurves::StartOf(int loop, std::size_t vertex) const
{
  return this->IsInPlane() ? this->ArcOf(loop).Start(vertex) : this->InSpace[loop].Start(vertex);
}

std::size_t BoundaryCurves::SideAt(const CurvePlace& place) const
{
  return (this->IsInPlane() ? this->ArcOf(place.loop).SideAt(place.at)
                            : this->InSpace[place.loop].SideAt(place.at))
    .first;
}

int BoundaryCurves::TriangleAt(const CurvePlace& place, int otherwise) const
{
  return this->Triangles.empty() ? otherwise : this->Triangles[place.loop][this->SideAt(place)];
}

Point BoundaryCurves::At(const CurvePlace& place) const
{
  return this->Curved.At(this->ArcOf(place.loop), Index(place.loop), place.at);
}

CurvePlace BoundaryCurves::Nearest(int loop, const Point& point) const
{
  return { loop, this->Curved.Nearest(this->ArcOf(loop), Index(loop), point) };
}

CurvePlace BoundaryCurves::NearestOn(
  const PairedSides& pair, std::size_t side, int loop, const Point& point) const
{
  if (!pair.spans)
  {
    return this->Nearest(loop, point);
  }
  const SideSpan& span = (*pair.spans)[side];
  return { loop, this->ArcOf(loop).NearestOnPart(point, span.start, span.length) };
}

CurvePlace BoundaryCurves::ImageOn(const PairedSides& pair, std::size_t side, int loop,
  const CurvePlace& other, const SpacePoint& image) const
{
  if (this->IsInPlane())
  {
    return this->NearestOn(pair, side, loop, image.head<2>());
  }
  const SideSpan& own = (*pair.spans)[side];
  const SideSpan& opposite = (*pair.spans)[1 - side];
  // From the middle of the other side, in the shorter direction.
  const double fromMiddle =
    std::remainder(other.at - opposite.start - 0.5 * opposite.length, this->Length(opposite.loop));
  return { own.loop, own.start + 0.5 * own.length - fromMiddle };
}

Point BoundaryCurves::Tangent(const CurvePlace& place) const
{
  return this->Curved.Derivative(this->ArcOf(place.loop), Index(place.loop), place.at);
}

int BoundaryCurves::CurveAt(const CurvePlace& place) const
{
  return this->Curved.CurveAt(this->ArcOf(place.loop), Index(place.loop), place.at);
}
}
