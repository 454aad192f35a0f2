#include "TraceGraph.h"

#include "Error.h"
#include "Index.h"
#include "SeparatrixTies.h"

#include <algorithm>
#include <cmath>
#include <queue>
#include <tuple>

namespace crossfield
{
namespace
{
/// Separatrices have different delays, up to this fraction of the extent, so that in symmetric
/// domains no two arrive anywhere at the same time. The delays are irregular and much larger than
/// SameIsoline.
constexpr double LargestDelay = 1e-6;
constexpr double GoldenRatio = 0.6180339887498949;
/// Separatrices whose lengths at a point differ by less than this, relative to the extent, arrive
/// at the same time: far above the rounding errors of symmetric maps, and far below the delays.
constexpr double SameTime = 1e-9;
/// Bound on the length of a separatrix, in extents; real ones have a few (docs/method.md §13.1).
constexpr double LongestLine = 1000.0;

/// An event in the simultaneous advance of all separatrices.
struct Event
{
  enum Kind
  {
    Advance,  ///< `line` enters the next triangle, or ends on the boundary.
    Crossing, ///< `line` arrives at `other`, which passed there before.
    Meeting   ///< `line` and `other` meet head-on; `length` is that of both together.
  };
  double time = 0.0;
  int number = 0; ///< Order in which events were found, which breaks ties.
  Kind kind = Advance;
  int line = 0;
  int other = 0;
  double length = 0.0;
  double otherLength = 0.0;
  int segment = 0; ///< Segment of `line`.
  int otherSegment = 0;

  bool operator<(const Event& event) const // the priority queue has the greatest on top
  {
    return this->time > event.time || (this->time == event.time && this->number > event.number);
  }
};

/// Traces all separatrices of a map.
class Tracer
{
public:
  /// Constructs a tracer that lets separatrices continue at the given ties.
  Tracer(const SeamlessMap& map, const std::vector<SeparatrixTie>& ties, const Progress& progress)
    : Ties(ties)
    , Map(map)
    , Topology(*map.topology)
    , Walk(map)
    , Extent(map.Extent())
    , Tolerance(SameIsoline * Extent)
    , Latest(map.topology->mesh.triangles.size(), -1)
    , Reports(progress)
  {
  }

  TraceGraph Run()
  {
    const auto departures = FindDepartures(this->Map);
    for (std::size_t cone = 0; cone < departures.size(); ++cone)
    {
      for (std::size_t i = 0; i < departures[cone].size(); ++i)
      {
        TracedSeparatrix line;
        line.cone = static_cast<int>(cone);
        // Slot 0 of a corner is the side that starts there.
        line.slot = static_cast<int>(i) + (this->Map.cones[cone].onBoundary ? 1 : 0);
        line.segments.push_back(this->Walk.Start(departures[cone][i]));
        this->Add(std::move(line));
      }
    }
    this->TraceAll();
    for (int position = this->FreeLoop(); position >= 0; position = this->FreeLoop())
    {
      TracedSeparatrix line;
      line.startPosition = position;
      line.segments.push_back(this->Walk.StartFromSide(position));
      line.delay = this->Now; // all others have passed
      ++this->Graph.extraSeparatrices;
      this->Add(std::move(line));
      this->TraceAll();
    }
    return std::move(this->Graph);
  }

private:
  /// A segment in the linked list of its triangle.
  struct Entry
  {
    int line;
    int segment;
    int next;
  };

  void Add(TracedSeparatrix line)
  {
    const auto number = static_cast<int>(this->Graph.separatrices.size());
    line.delay += LargestDelay * this->Extent * std::fmod((number + 1) * GoldenRatio, 1.0);
    this->Graph.separatrices.push_back(std::move(line));
    this->Enter(number);
  }

  double Time(int line, double length) const
  {
    return length + this->Graph.separatrices[line].delay;
  }

  void Push(Event event)
  {
    event.number = this->EventCount++;
    this->Events.push(event);
  }

  void TraceAll()
  {
    while (!this->Events.empty())
    {
      const Event event = this->Events.top();
      this->Events.pop();
      this->Now = event.time;
      if (this->Graph.separatrices[event.line].end != SeparatrixEnd::None)
      {
        continue;
      }
      if (event.kind == Event::Advance)
      {
        this->Advance(event.line);
      }
      else if (event.kind == Event::Crossing)
      {
        this->Cross(event);
      }
      else
      {
        this->Meet(event);
      }
    }
  }

  void Advance(int number)
  {
    TracedSeparatrix& line = this->Graph.separatrices[number];
    const LineSegment& last = line.segments.back();
    if (this->Walk.Beyond(last) < 0)
    {
      const int edge = this->Topology.EdgeOf(last.triangle, last.exit.side);
      line.end = SeparatrixEnd::Boundary;
      line.length = last.exitLength;
      line.endPosition = this->BoundaryPosition(edge);
      line.lastSegment = static_cast<int>(line.segments.size()) - 1;
      line.endDirection = last.direction;
      return;
    }
    if (last.exitLength > LongestLine * this->Extent)
    {
      throw Error("A separatrix of the seamless map does not end", "use a finer mesh",
        Error::Kind::CoarseMesh);
    }
    line.segments.push_back(this->Walk.Continue(last));
    this->Enter(number);
  }

  /// Throws Error if separatrices wind around a narrow part of the map again and again.
  void RequireProgress(const LineSegment& segment) const
  {
    // Per triangle of the mesh; 70 random rings and plates need at most 1.
    constexpr std::size_t MaximumComparisons = 500;
    if (this->Comparisons > MaximumComparisons * this->Latest.size())
    {
      throw Error("The separatrices of the seamless map wind around a narrow part of the "
                  "domain near " +
          this->Topology.Where(this->Topology.mesh.triangles[segment.triangle][0]) +
          " too often to be traced",
        "use a finer mesh, or move singularities away from each other and from the boundary",
        Error::Kind::CoarseMesh);
    }
  }

  /// Finds the separatrices that one meets in the triangle that it has entered.
  void Enter(int number)
  {
    const TracedSeparatrix& line = this->Graph.separatrices[number];
    const auto segment = static_cast<int>(line.segments.size()) - 1;
    const LineSegment& mine = line.segments.back();
    this->RequireProgress(mine);
    for (int e = this->Latest[mine.triangle]; e >= 0; e = this->Entries[e].next)
    {
      const Entry& entry = this->Entries[e];
      ++this->Comparisons;
      const LineSegment& theirs = this->Graph.separatrices[entry.line].segments[entry.segment];
      if ((mine.direction - theirs.direction) % 2 != 0)
      {
        if (this->Interleave(mine, number, theirs, entry.line))
        {
          this->FindCrossing(number, segment, entry.line, entry.segment);
        }
      }
      else
      {
        this->FindMeeting(number, mine, entry);
      }
    }
    // Two lines along a side in opposite directions are in the triangles on either side of it.
    if (const std::optional<LineSegment> beside = this->Walk.Beside(mine, this->Tolerance))
    {
      for (int e = this->Latest[beside->triangle]; e >= 0; e = this->Entries[e].next)
      {
        this->FindMeeting(number, *beside, this->Entries[e]);
      }
    }
    this->Entries.push_back({ number, segment, this->Latest[mine.triangle] });
    this->Latest[mine.triangle] = static_cast<int>(this->Entries.size()) - 1;
    this->Push({ this->Time(number, mine.exitLength), 0, Event::Advance, number });
  }

  /// A position on the outline of a triangle: side, fraction, and a rank of the line that orders
  /// lines at one point consistently from both sides of an edge. The end of a side is before the
  /// start of the next one, although both are at one vertex.
  using Position = std::tuple<int, double, int>;

  Position OnOutline(int triangle, const OutlinePoint& point, int line) const
  {
    const auto& v = this->Topology.mesh.triangles[triangle];
    const bool upwards = v[point.side] < v[(point.side + 1) % 3];
    return { point.side, point.fraction, upwards ? line : -line };
  }

  /// Returns whether two lines cross in a triangle: their entries and exits alternate around it.
  bool Interleave(const LineSegment& a, int lineA, const LineSegment& b, int lineB) const
  {
    // Lines from one vertex meet only there.
    const auto atCorner = [](const LineSegment& s)
    { return s.entryLength == 0.0 && s.entry.fraction == 0.0; };
    if (atCorner(a) && atCorner(b) && a.entry.side == b.entry.side)
    {
      return false;
    }
    auto start = this->OnOutline(a.triangle, a.entry, lineA);
    auto end = this->OnOutline(a.triangle, a.exit, lineA);
    if (end < start)
    {
      std::swap(start, end);
    }
    const auto between = [&start, &end](const Position& x) { return start < x && x < end; };
    return between(this->OnOutline(b.triangle, b.entry, lineB)) !=
      between(this->OnOutline(b.triangle, b.exit, lineB));
  }

  void FindCrossing(int a, int segmentA, int b, int segmentB)
  {
    const LineSegment& first = this->Graph.separatrices[a].segments[segmentA];
    const LineSegment& second = this->Graph.separatrices[b].segments[segmentB];
    const double lengthA =
      std::clamp(first.LengthAt(second.level), first.entryLength, first.exitLength);
    const double lengthB =
      std::clamp(second.LengthAt(first.level), second.entryLength, second.exitLength);
    Event event;
    event.kind = Event::Crossing;
    const bool firstIsLater = this->Time(a, lengthA) >= this->Time(b, lengthB);
    event.line = firstIsLater ? a : b;
    event.other = firstIsLater ? b : a;
    event.length = firstIsLater ? lengthA : lengthB;
    event.otherLength = firstIsLater ? lengthB : lengthA;
    event.segment = firstIsLater ? segmentA : segmentB;
    event.otherSegment = firstIsLater ? segmentB : segmentA;
    event.time = this->Time(event.line, event.length);
    this->Push(event);
  }

  /// Returns the length that a separatrix has reached or may still reach. Where two meet head-on,
  /// no other can pass between them.
  double Reach(const TracedSeparatrix& line) const
  {
    return line.end == SeparatrixEnd::None ? this->Extent * 2.0 * LongestLine
      : line.end == SeparatrixEnd::HeadOn  ? line.length + this->Tolerance
                                           : line.length;
  }

  void Cross(const Event& event)
  {
    TracedSeparatrix& line = this->Graph.separatrices[event.line];
    if (this->Reach(this->Graph.separatrices[event.other]) < event.otherLength)
    {
      return; // the other one stops before this point
    }
    if (this->IsTie(event, this->Ties))
    {
      // Two lines through one vertex may be found to cross in several triangles around it.
      if (!this->IsTie(event, this->Graph.ties))
      {
        this->Graph.ties.push_back({ { event.line, event.other },
          { event.length, event.otherLength }, { event.segment, event.otherSegment } });
      }
      return;
    }
    line.end = SeparatrixEnd::Line;
    line.length = event.length;
    line.other = event.other;
    line.otherLength = event.otherLength;
    line.lastSegment = event.segment;
    line.endDirection = line.segments[event.segment].direction;
    line.otherDirection =
      this->Graph.separatrices[event.other].segments[event.otherSegment].direction;
  }

  /// Returns whether a crossing is one of some ties.
  bool IsTie(const Event& event, const std::vector<SeparatrixTie>& ties) const
  {
    const double reach = SameTime * this->Extent;
    return std::any_of(ties.begin(), ties.end(),
      [&](const SeparatrixTie& tie)
      {
        const std::size_t first = tie.lines[0] == event.line ? 0 : 1;
        return tie.lines[first] == event.line && tie.lines[1 - first] == event.other &&
          std::abs(tie.lengths[first] - event.length) <= reach &&
          std::abs(tie.lengths[1 - first] - event.otherLength) <= reach;
      });
  }

  /// Adds the event that a line meets another one head-on, if it does: `mine` is its segment, in
  /// the chart of the other one's triangle.
  void FindMeeting(int number, const LineSegment& mine, const Entry& entry)
  {
    const TracedSeparatrix& other = this->Graph.separatrices[entry.line];
    const LineSegment& theirs = other.segments[entry.segment];
    const double together = mine.offset + theirs.offset;
    if ((mine.direction - theirs.direction) % 4 == 0 ||
      (mine.direction - theirs.direction) % 2 != 0 ||
      std::abs(mine.level - theirs.level) > this->Tolerance || number == entry.line ||
      together <= this->Tolerance) // they move apart
    {
      return;
    }
    Event event;
    event.kind = Event::Meeting;
    event.line = number;
    event.other = entry.line;
    event.length = together;
    event.time =
      std::max(this->Now, 0.5 * (together + this->Graph.separatrices[number].delay + other.delay));
    this->Push(event);
  }

  void Meet(const Event& event)
  {
    TracedSeparatrix& line = this->Graph.separatrices[event.line];
    TracedSeparatrix& other = this->Graph.separatrices[event.other];
    if (other.end != SeparatrixEnd::None)
    {
      return;
    }
    line.length = std::clamp(event.time - line.delay, 0.0, event.length);
    other.length = event.length - line.length;
    const auto close = [&event](TracedSeparatrix& one, int partner)
    {
      one.end = SeparatrixEnd::HeadOn;
      one.other = partner;
      one.headOnLength = event.length;
      one.lastSegment = static_cast<int>(one.segments.size()) - 1;
      while (one.lastSegment > 0 && one.segments[one.lastSegment].entryLength > one.length)
      {
        --one.lastSegment;
      }
    };
    close(line, event.other);
    close(other, event.line);
    ++this->Graph.headOn;
  }

  int BoundaryPosition(int edge)
  {
    if (this->PositionOfEdge.empty())
    {
      this->PositionOfEdge.assign(Index(this->Topology.edges.Count()), -1);
      for (std::size_t i = 0; i < this->Topology.edges.ofBoundary.size(); ++i)
      {
        this->PositionOfEdge[this->Topology.edges.ofBoundary[i]] = static_cast<int>(i);
      }
    }
    return this->PositionOfEdge[edge];
  }

  /// Returns an edge of a loop without corners at which no separatrix starts or ends; −1 if there
  /// is none.
  int FreeLoop() const
  {
    std::vector<bool> met(this->Topology.mesh.boundary.size(), false);
    std::vector<bool> corner(Index(this->Topology.VertexCount()), false);
    for (const Cone& cone : this->Map.cones)
    {
      corner[cone.vertex] = true;
    }
    for (const TracedSeparatrix& line : this->Graph.separatrices)
    {
      for (const int position : { line.startPosition, line.endPosition })
      {
        if (position >= 0)
        {
          met[position] = true;
        }
      }
    }
    for (const BoundaryLoop& loop : this->Topology.loops)
    {
      const bool isMet = std::any_of(loop.edges.begin(), loop.edges.end(),
        [&](int position)
        { return met[position] || corner[this->Topology.BoundaryAt(position).vertices[0]]; });
      if (!isMet)
      {
        return loop.edges.front();
      }
    }
    return -1;
  }

  const std::vector<SeparatrixTie>& Ties;
  const SeamlessMap& Map;
  const MeshTopology& Topology;
  const LineWalk Walk;
  const double Extent;
  const double Tolerance;
  std::vector<int> Latest;     ///< Latest entry of every triangle.
  std::size_t Comparisons = 0; ///< Of segments in the same triangle.
  std::vector<Entry> Entries;
  std::priority_queue<Event> Events;
  std::vector<int> PositionOfEdge;
  double Now = 0.0;
  int EventCount = 0;
  Progress Reports;
  TraceGraph Graph;
};
}

TraceGraph TraceSeparatrices(const SeamlessMap& map, const Progress& progress)
{
  progress.Report(0.0);
  // Separatrices that continue may tie with others, so ties are searched until there are no new
  // ones. Most maps have none, and few need more than two rounds.
  std::vector<SeparatrixTie> ties;
  for (;;)
  {
    TraceGraph graph = Tracer(map, ties, progress).Run();
    const std::vector<SeparatrixTie> found = FindTies(graph, SameTime * map.Extent());
    if (found.empty())
    {
      progress.Report(1.0);
      return graph;
    }
    ties.insert(ties.end(), found.begin(), found.end());
  }
}

std::vector<LineSegment> TraceStreamline(
  const SeamlessMap& map, int triangle, const Point& w, int direction, double longest)
{
  const LineWalk walk(map);
  std::vector<LineSegment> segments = { walk.StartInside(triangle, w, direction) };
  while (segments.back().exitLength < longest && walk.Beyond(segments.back()) >= 0)
  {
    segments.push_back(walk.Continue(segments.back()));
  }
  return segments;
}
}
