#include "ClosedPolyline.h"

#include <algorithm>
#include <cmath>

namespace crossfield
{
template <typename Place>
ClosedPolyline<Place>::ClosedPolyline(std::vector<Place> vertices)
  : Polyline(std::move(vertices))
  , Starts{ 0.0 }
{
  for (std::size_t i = 0; i < this->Polyline.size(); ++i)
  {
    this->Starts.push_back(this->Starts.back() + (this->End(i) - this->Polyline[i]).norm());
  }
}

template <typename Place>
double ClosedPolyline<Place>::Wrap(double length) const
{
  const double wrapped = std::fmod(length, this->Length());
  return wrapped < 0.0 ? wrapped + this->Length() : wrapped;
}

template <typename Place>
std::pair<std::size_t, double> ClosedPolyline<Place>::SideAt(double length) const
{
  const double wrapped = this->Wrap(length);
  const auto after = std::upper_bound(this->Starts.begin(), this->Starts.end(), wrapped);
  const std::size_t side =
    std::min(static_cast<std::size_t>(after - this->Starts.begin()), this->Polyline.size()) - 1;
  const double extent = this->Starts[side + 1] - this->Starts[side];
  return { side, extent > 0.0 ? (wrapped - this->Starts[side]) / extent : 0.0 };
}

template <typename Place>
Place ClosedPolyline<Place>::At(double length) const
{
  const auto [side, part] = this->SideAt(length);
  return this->Polyline[side] + part * (this->End(side) - this->Polyline[side]);
}

template <typename Place>
Place ClosedPolyline<Place>::Tangent(double length) const
{
  const std::size_t side = this->SideAt(length).first;
  return (this->End(side) - this->Polyline[side]).normalized();
}

template <typename Place>
std::size_t ClosedPolyline<Place>::NearestVertex(double length) const
{
  const auto [side, part] = this->SideAt(length);
  return part > 0.5 ? (side + 1) % this->Polyline.size() : side;
}

template class ClosedPolyline<Point>;
template class ClosedPolyline<SpacePoint>;
}
