#include "BoundaryCurves.h"

#include "Index.h"

namespace crossfield
{
BoundaryCurves::BoundaryCurves(const std::vector<Loop>& loops, const CurvedBoundary& boundary)
  : Arcs(loops.begin(), loops.end())
  , Curved(boundary, this->Arcs)
{
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
  if (!pair.slit)
  {
    return this->Nearest(loop, point);
  }
  const SideSpan& span = (*pair.slit)[side];
  return { loop, this->ArcOf(loop).NearestOnPart(point, span.start, span.length) };
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
