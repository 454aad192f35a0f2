#include "EndJoints.h"

#include "EndGrid.h"
#include "Error.h"
#include "PieceSampling.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <limits>
#include <map>
#include <sstream>
#include <tuple>
#include <utility>

namespace crossfield
{
namespace
{
/// Returns the distance of a point from a segment.
double Distance(const Point& point, const Point& first, const Point& last)
{
  const Point along = last - first;
  const double squared = along.squaredNorm();
  const double part =
    squared > 0.0 ? std::clamp((point - first).dot(along) / squared, 0.0, 1.0) : 0.0;
  return (point - first - part * along).norm();
}
}

EndJoints::EndJoints(
  const std::vector<DrawingPiece>& pieces, std::vector<std::size_t> used, double tolerance)
  : Pieces(pieces)
  , Given(std::move(used))
  , Tolerance(tolerance)
  , Used(pieces.size(), false)
  , GroupOf(2 * pieces.size(), 0)
{
  for (const std::size_t piece : this->Given)
  {
    this->Used[piece] = true;
  }
  this->JoinExactly();
  this->LeaveOutClosures(tolerance);
  this->JoinWithin(tolerance);
  this->LeaveOutShort(tolerance);
}

const Point& EndJoints::PlaceOf(Index end) const
{
  const DrawingPiece& piece = this->Pieces[end / 2];
  return end % 2 == 0 ? piece.first : piece.last;
}

void EndJoints::JoinExactly()
{
  std::map<std::pair<double, double>, std::size_t> groups;
  for (const std::size_t piece : this->Given)
  {
    for (const Index end : { 2 * piece, 2 * piece + 1 })
    {
      const Point& place = this->PlaceOf(end);
      this->GroupOf[end] =
        groups.emplace(std::pair(place.x(), place.y()), groups.size()).first->second;
      this->Members.resize(groups.size());
      this->Members[this->GroupOf[end]].push_back(end);
    }
  }
}

std::vector<EndJoints::Index> EndJoints::OpenEnds() const
{
  std::vector<Index> open;
  for (const std::size_t piece : this->Given)
  {
    for (const Index end : { 2 * piece, 2 * piece + 1 })
    {
      if (this->Used[piece] && this->IsOpen(end))
      {
        open.push_back(end);
      }
    }
  }
  return open;
}

void EndJoints::Join(Index a, Index b)
{
  this->Members[this->GroupOf[b]].clear();
  this->GroupOf[b] = this->GroupOf[a];
  this->Members[this->GroupOf[a]].push_back(b);
}

void EndJoints::JoinWithin(double tolerance)
{
  constexpr std::size_t MostPairs = 10000000;
  EndGrid grid(tolerance);
  std::vector<std::tuple<double, Index, Index>> pairs;
  for (const Index end : this->OpenEnds())
  {
    const Point& place = this->PlaceOf(end);
    for (const Index other : grid.Near(place))
    {
      const double distance = (this->PlaceOf(other) - place).norm();
      // A piece that is not much longer than the gap between its ends is no closed curve.
      const bool isOwn = other / 2 == end / 2;
      if (distance <= tolerance &&
        !(isOwn && ApproximateLength(this->Pieces[end / 2]) < 4.0 * distance))
      {
        pairs.emplace_back(distance, other, end);
      }
      if (pairs.size() > MostPairs)
      {
        throw Error("The join tolerance " + FormatNumber(tolerance) +
          " joins too many ends of curves; set it to less.");
      }
    }
    grid.Add(place, end);
  }
  std::sort(pairs.begin(), pairs.end());
  for (const auto& [unused, a, b] : pairs)
  {
    if (this->IsOpen(a) && this->IsOpen(b))
    {
      this->JoinGap(a, b);
    }
  }
}

void EndJoints::JoinGap(Index a, Index b)
{
  this->Join(a, b);
  ++this->Gaps;
  const double distance = (this->PlaceOf(a) - this->PlaceOf(b)).norm();
  if (distance > this->Widest)
  {
    this->Widest = distance;
    this->WidestPlace = this->PlaceOf(a);
  }
}

void EndJoints::LeaveOutClosures(double tolerance)
{
  constexpr double MuchLonger = 10.0; // segments of fine polylines are not
  const auto neighbourOf = [this](Index end)
  {
    const std::vector<Index>& members = this->Members[this->GroupOf[end]];
    return members.size() != 2 ? end : members[members[0] == end ? 1 : 0];
  };
  for (const std::size_t piece : this->Given)
  {
    const DrawingPiece& line = this->Pieces[piece];
    const Index before = neighbourOf(2 * piece);
    const Index after = neighbourOf(2 * piece + 1);
    const double length = (line.last - line.first).norm();
    const auto isLong = [&](Index end)
    {
      return end / 2 != piece && this->Used[end / 2] &&
        ApproximateLength(this->Pieces[end / 2]) > MuchLonger * length;
    };
    if (line.curve.kind == PlaneCurve::Kind::Line && length <= tolerance && isLong(before) &&
      isLong(after))
    {
      this->Used[piece] = false;
      this->Members[this->GroupOf[before]] = { before };
      this->Members[this->GroupOf[after]] = { after };
      this->JoinGap(before, after);
    }
  }
}

void EndJoints::LeaveOutShort(double tolerance)
{
  for (const Index end : this->OpenEnds())
  {
    const std::size_t piece = end / 2;
    if (end % 2 == 0 && this->IsOpen(end + 1) &&
      ApproximateLength(this->Pieces[piece]) <= tolerance)
    {
      this->Used[piece] = false;
      ++this->Short;
    }
  }
}

bool EndJoints::IsClosed() const
{
  return std::all_of(this->Members.begin(), this->Members.end(),
    [this](const std::vector<Index>& members)
    { return members.empty() || members.size() == 2 || !this->Used[members.front() / 2]; });
}

void EndJoints::RequireClosed() const
{
  for (const std::vector<Index>& members : this->Members)
  {
    if (members.size() > 2)
    {
      throw Error("More than two curves of the drawing meet at " +
        Describe(this->PlaceOf(members[0])) + ", among them " +
        this->Pieces[members[0] / 2].origin + ", " + this->Pieces[members[1] / 2].origin + " and " +
        this->Pieces[members[2] / 2].origin + "; remove those that are no part of the boundary" +
        this->OfferLayers() + ".");
    }
  }
  const std::vector<Index> open = this->OpenEnds();
  if (!open.empty())
  {
    this->ReportOpen(open.front());
  }
}

long EndJoints::PieceUnder(Index end) const
{
  constexpr int Segments = 32;
  const Point& place = this->PlaceOf(end);
  for (const std::size_t other : this->Given)
  {
    const DrawingPiece& piece = this->Pieces[other];
    Point before = piece.first;
    for (int i = 1; other != end / 2 && i <= Segments; ++i)
    {
      const Point here = PointAt(
        piece, i == Segments ? piece.end : piece.begin + (piece.end - piece.begin) * i / Segments);
      // The sagitta of a segment of a half circle is 1/800 of its length.
      const double sagitta =
        piece.curve.kind == PlaneCurve::Kind::Line ? 0.0 : 0.05 * (here - before).norm();
      if (Distance(place, before, here) <= this->Tolerance + sagitta)
      {
        return static_cast<long>(other);
      }
      before = here;
    }
  }
  return -1;
}

double EndJoints::ToleranceThatCloses() const
{
  constexpr std::size_t MostEnds = 2000; // all pairs are compared
  const std::vector<Index> open = this->OpenEnds();
  double largest = 0.0;
  for (const Index end : open)
  {
    double nearest = std::numeric_limits<double>::max();
    for (const Index other : open)
    {
      nearest = open.size() <= MostEnds && other != end
        ? std::min(nearest, (this->PlaceOf(other) - this->PlaceOf(end)).norm())
        : nearest;
    }
    largest = std::max(largest, nearest);
  }
  Eigen::AlignedBox2d box;
  for (const std::size_t piece : this->Given)
  {
    box.extend(this->Pieces[piece].first);
    box.extend(this->Pieces[piece].last);
  }
  // A wider gap is rather a missing part of the boundary.
  constexpr double WidestGap = 0.02;
  if (!(largest <= WidestGap * box.diagonal().norm()))
  {
    return 0.0;
  }
  // Rounded up to two digits, as the message shows it.
  std::ostringstream text;
  text.precision(2);
  text << 1.1 * largest;
  const double rounded = std::stod(text.str());
  const EndJoints wider(this->Pieces, this->Given, rounded);
  return wider.IsClosed() && wider.Short == this->Short ? rounded : 0.0;
}

std::string EndJoints::OfferLayers() const
{
  std::map<std::string, std::vector<std::size_t>> layers;
  for (const std::size_t piece : this->Given)
  {
    layers[this->Pieces[piece].name].push_back(piece);
  }
  std::vector<std::size_t> closed;
  std::string names;
  std::string options;
  for (const auto& [name, pieces] : layers)
  {
    if (EndJoints(this->Pieces, pieces, this->Tolerance).IsClosed())
    {
      closed.insert(closed.end(), pieces.begin(), pieces.end());
      const std::string quoted = "'" + (name.empty() ? "0" : name) + "'"; // as in KeepLayers
      names += (names.empty() ? "" : ", ") + quoted;
      options += " --drawing-layer " + quoted;
    }
  }
  return closed.empty() || !EndJoints(this->Pieces, closed, this->Tolerance).IsClosed()
    ? std::string()
    : ", or use the layers " + names + " alone (Layers," + options + ")";
}

void EndJoints::ReportOpen(Index end) const
{
  const Point& place = this->PlaceOf(end);
  const std::string& origin = this->Pieces[end / 2].origin;
  const double tolerance = this->ToleranceThatCloses();
  if (tolerance > 0.0)
  {
    throw Error("The drawing is open at " + Describe(place) + ", an end of " + origin +
      "; close the gap there, or set the join tolerance to " + FormatNumber(tolerance) +
      ", which closes all gaps.");
  }
  const std::string layers = this->OfferLayers();
  const long under = this->PieceUnder(end);
  if (under >= 0)
  {
    throw Error("At " + Describe(place) + " " + origin + " ends on " + this->Pieces[under].origin +
      "; remove what is no part of the boundary" + layers + ".");
  }
  throw Error("The drawing is open at " + Describe(place) + ", an end of " + origin +
    ", and no other open end is near; draw the missing part of the boundary, or remove this one" +
    layers + ".");
}

PieceEnd EndJoints::PartnerOf(const PieceEnd& end) const
{
  const Index index = 2 * end.piece + (end.isLast ? 1 : 0);
  const std::vector<Index>& members = this->Members[this->GroupOf[index]];
  const Index partner = members[0] == index ? members[1] : members[0];
  return { partner / 2, partner % 2 == 1 };
}

void EndJoints::AddWarnings(std::vector<std::string>& warnings) const
{
  // Rounding errors of coordinates are no gaps: 1e-3 of the default tolerance.
  constexpr double ShareOfTolerance = 1e-3;
  if (this->Widest > ShareOfTolerance * this->Tolerance)
  {
    warnings.push_back("Gaps between the curves of the drawing were closed; the widest of " +
      std::to_string(this->Gaps) + ", at " + Describe(this->WidestPlace) + ", was " +
      FormatNumber(this->Widest) + " wide.");
  }
  if (this->Short > 0)
  {
    warnings.push_back(std::to_string(this->Short) +
      " pieces of the drawing that join nothing and are shorter than " +
      FormatNumber(this->Tolerance) + " were left out.");
  }
}
}
