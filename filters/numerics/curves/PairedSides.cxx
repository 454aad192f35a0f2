#include "PairedSides.h"

#include "CurvedLoops.h"
#include "Error.h"

#include <algorithm>
#include <cmath>

namespace crossfield
{
namespace
{
std::string Quoted(const std::string& name)
{
  return "'" + name + "'";
}

/// Finds the motion of one pair.
class MotionSearch
{
public:
  MotionSearch(const std::vector<LoopArc>& loops, const CurvedLoops& curved, const SideSpan& from,
    const SideSpan& to, double reach)
    : Loops(loops)
    , Curved(curved)
    , From(from)
    , To(to)
    , Reach(reach)
  {
    std::vector<double> parts = this->PartsOf(from);
    for (const double part : this->PartsOf(to))
    {
      parts.push_back(1.0 - part);
    }
    for (const double part : parts)
    {
      this->Points.push_back(this->At(from, part));
      this->Images.push_back(this->At(to, 1.0 - part));
    }
  }

  /// Returns the motion, preferably a translation.
  RigidMotion Find()
  {
    RigidMotion translation;
    for (std::size_t i = 0; i < this->Points.size(); ++i)
    {
      translation.shift +=
        (this->Images[i] - this->Points[i]) / static_cast<double>(this->Points.size());
    }
    this->Measure(translation);
    if (this->IsFound())
    {
      return translation;
    }
    const RigidMotion motion = FitMotion(this->Points, this->Images);
    this->Measure(motion);
    return motion;
  }

  bool IsFound() const { return this->Worst <= this->Reach; }

  double Worst = 0.0;               ///< Largest distance of an image.
  Point WorstPoint = Point::Zero(); ///< Of the first side.
  Point WorstImage = Point::Zero();

private:
  const LoopArc& ArcOf(const SideSpan& span) const { return this->Loops[span.loop]; }

  /// Returns the positions of the vertices of a side, between 0 and 1.
  std::vector<double> PartsOf(const SideSpan& span) const
  {
    const LoopArc& arc = this->ArcOf(span);
    std::vector<double> parts = { 0.0, 1.0 };
    for (std::size_t i = 0; i < arc.Vertices().size(); ++i)
    {
      double part = arc.Start(i) - span.start;
      part = (part - arc.Length() * std::floor(part / arc.Length())) / span.length;
      if (part > 0.0 && part < 1.0)
      {
        parts.push_back(part);
      }
    }
    return parts;
  }

  Point At(const SideSpan& span, double part) const
  {
    return this->Curved.At(
      this->ArcOf(span), static_cast<std::size_t>(span.loop), span.start + part * span.length);
  }

  /// Returns the distance of a point from the point at a position of a side or, if that is too far and
  /// not an end, from the side.
  double Distance(const SideSpan& span, const Point& place, double part) const
  {
    const double direct = (this->At(span, part) - place).norm();
    if (part == 0.0 || part == 1.0 || direct <= this->Reach)
    {
      return direct;
    }
    const LoopArc& arc = this->ArcOf(span);
    const auto loop = static_cast<std::size_t>(span.loop);
    return (this->Curved.At(arc, loop, this->Curved.Nearest(arc, loop, place)) - place).norm();
  }

  void Measure(const RigidMotion& motion)
  {
    this->Worst = -1.0;
    const auto add = [this](double distance, const Point& point, const Point& image)
    {
      if (distance > this->Worst)
      {
        this->Worst = distance;
        this->WorstPoint = point;
        this->WorstImage = image;
      }
    };
    for (const double part : this->PartsOf(this->From))
    {
      const Point point = this->At(this->From, part);
      add(this->Distance(this->To, motion(point), 1.0 - part), point, motion(point));
    }
    const RigidMotion back = motion.Inverse();
    for (const double part : this->PartsOf(this->To))
    {
      const Point image = this->At(this->To, part);
      add(this->Distance(this->From, back(image), 1.0 - part), back(image), image);
    }
  }

  const std::vector<LoopArc>& Loops;
  const CurvedLoops& Curved;
  const SideSpan From;
  const SideSpan To;
  const double Reach;
  std::vector<Point> Points; ///< At equal parts of the lengths of both sides.
  std::vector<Point> Images;
};

/// Throws Error if a side is in two pairs.
void RequireOnce(const std::vector<std::array<std::string, 2>>& pairs)
{
  std::vector<std::string> used;
  for (const std::array<std::string, 2>& pair : pairs)
  {
    if (pair[0] == pair[1])
    {
      throw Error("The side " + Quoted(pair[0]) +
        " is paired with itself; give two sides that are images of each other.");
    }
    for (const std::string& name : pair)
    {
      if (std::find(used.begin(), used.end(), name) != used.end())
      {
        throw Error("The side " + Quoted(name) + " is in two periodic pairs; leave one out.");
      }
      used.push_back(name);
    }
  }
}
}

SideSpan FindSpan(const BoundarySides& sides, const std::vector<LoopArc>& loops, int side)
{
  const SidesAlong along(sides, loops);
  const std::string& name = sides.names[side];
  SideSpan span;
  int pieces = 0;
  for (std::size_t loop = 0; loop < loops.size(); ++loop)
  {
    const std::vector<LoopSide>& starts = along.On(loop);
    for (std::size_t i = 0; i < starts.size(); ++i)
    {
      if (starts[i].side != side)
      {
        continue;
      }
      if (starts.size() == 1)
      {
        throw Error("The side " + Quoted(name) +
          " is a closed curve, which has no image on the boundary; leave the periodic pair out.");
      }
      const double end =
        i + 1 < starts.size() ? starts[i + 1].at : starts[0].at + loops[loop].Length();
      span = { static_cast<int>(loop), starts[i].at, end - starts[i].at };
      ++pieces;
    }
  }
  if (pieces != 1)
  {
    throw Error("The periodic side " + Quoted(name) + " has " + std::to_string(pieces) +
      " pieces; give each piece a name of its own, and pair these.");
  }
  return span;
}

std::vector<PairedSides> FindPairedSides(const PlanarDomain& domain, const BoundarySides& sides,
  const CurvedBoundary& curves, const std::vector<std::array<std::string, 2>>& pairs)
{
  std::vector<PairedSides> found;
  if (pairs.empty())
  {
    return found;
  }
  RequireOnce(pairs);
  const std::vector<LoopArc> loops(domain.loops.begin(), domain.loops.end());
  const CurvedLoops curved(curves, loops);
  const double reach = PairReach * domain.Diagonal();
  for (const std::array<std::string, 2>& names : pairs)
  {
    for (const std::string& name : names)
    {
      RequireSide(sides.names, name, " for a periodic pair");
    }
    PairedSides pair;
    pair.first = sides.Find(names[0]);
    pair.second = sides.Find(names[1]);
    MotionSearch search(loops, curved, FindSpan(sides, loops, pair.first),
      FindSpan(sides, loops, pair.second), reach);
    pair.motion = search.Find();
    if (!search.IsFound())
    {
      throw Error("The sides " + Quoted(names[0]) + " and " + Quoted(names[1]) +
        " are not images of each other: the best translation or rotation takes " +
        Describe(search.WorstPoint) + " to " + Describe(search.WorstImage) + ", which is " +
        FormatNumber(search.Worst, 2) +
        " beside the other side; make both sides congruent, or leave the pair out.");
    }
    pair.name = "The periodic pair " + names[0] + ":" + names[1];
    found.push_back(pair);
  }
  return found;
}
}
