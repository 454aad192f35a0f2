#include "DrawingOutline.h"

#include "DomainExtent.h"
#include "Error.h"
#include "PieceChains.h"
#include "PieceSampling.h"

#include <algorithm>
#include <map>

namespace crossfield
{
namespace
{
/// Distance from a curve, as a share of the extent, above which a vertex does not belong to it.
constexpr double OffCurve = 5e-7;

/// Samples chains of pieces.
class OutlineTracer
{
public:
  OutlineTracer(const Drawing& drawing, double extent, double turn, DrawingOutline& outline)
    : Pieces(drawing.pieces)
    , Extent(extent)
    , Outline(outline)
  {
    constexpr double Distance = 1e-4;
    constexpr double Shortest = 1e-6;
    this->Rule.turn = turn;
    this->Rule.distance = Distance * extent;
    this->Rule.shortest = Shortest * extent;
  }

  void Trace(const std::vector<ChainedPiece>& chain)
  {
    std::size_t segments = 0;
    std::vector<std::vector<double>> parameters;
    for (const ChainedPiece& link : chain)
    {
      parameters.push_back(SampleParameters(this->Pieces[link.piece], this->Rule));
      segments += parameters.back().size() - 1;
    }
    OutlineLoop loop;
    for (std::size_t i = 0; i < chain.size(); ++i)
    {
      const DrawingPiece& piece = this->Pieces[chain[i].piece];
      // A segment of a circle and its chord need one more point to enclose an area.
      if (segments < 3 && piece.curve.kind != PlaneCurve::Kind::Line)
      {
        this->Halve(parameters[i]);
      }
      const ChainedPiece& before = chain[(i + chain.size() - 1) % chain.size()];
      const ChainedPiece& after = chain[(i + 1) % chain.size()];
      const Point start = this->JointOf(before, chain[i]);
      const Point stop = this->JointOf(chain[i], after);
      const int curve = this->CurveOf(chain[i], start, stop);
      this->Append(piece, chain[i].isReversed, parameters[i], start, curve, loop);
    }
    this->Outline.loops.push_back(std::move(loop));
  }

private:
  static void Halve(std::vector<double>& parameters)
  {
    std::vector<double> halved = { parameters.front() };
    for (std::size_t i = 1; i < parameters.size(); ++i)
    {
      halved.push_back(0.5 * (parameters[i - 1] + parameters[i]));
      halved.push_back(parameters[i]);
    }
    parameters = std::move(halved);
  }

  const Point& StartOf(const ChainedPiece& link) const
  {
    const DrawingPiece& piece = this->Pieces[link.piece];
    return link.isReversed ? piece.last : piece.first;
  }

  const Point& StopOf(const ChainedPiece& link) const
  {
    const DrawingPiece& piece = this->Pieces[link.piece];
    return link.isReversed ? piece.first : piece.last;
  }

  bool IsLine(const ChainedPiece& link) const
  {
    return this->Pieces[link.piece].curve.kind == PlaneCurve::Kind::Line;
  }

  /// Returns the vertex between two pieces of a chain.
  const Point& JointOf(const ChainedPiece& before, const ChainedPiece& after) const
  {
    const bool isFirst = this->IsLine(before) == this->IsLine(after) ? before.piece < after.piece
                                                                     : this->IsLine(after);
    return isFirst ? this->StopOf(before) : this->StartOf(after);
  }

  /// Returns the index of the curve of a piece; records it when it is new.
  int CurveOf(const ChainedPiece& link, const Point& start, const Point& stop)
  {
    const DrawingPiece& piece = this->Pieces[link.piece];
    if (this->IsLine(link))
    {
      if (!piece.isExact)
      {
        return -1;
      }
      if (this->LineCurve < 0)
      {
        this->LineCurve = static_cast<int>(this->Outline.curves.size());
        this->Outline.curves.emplace_back();
      }
      return this->LineCurve;
    }
    const double reach = OffCurve * this->Extent;
    if ((this->StartOf(link) - start).norm() > reach || (this->StopOf(link) - stop).norm() > reach)
    {
      return -1;
    }
    this->Outline.curves.push_back(piece.curve);
    return static_cast<int>(this->Outline.curves.size()) - 1;
  }

  static void Append(const DrawingPiece& piece, bool isReversed, std::vector<double> parameters,
    const Point& start, int curve, OutlineLoop& loop)
  {
    if (isReversed)
    {
      std::reverse(parameters.begin(), parameters.end());
    }
    for (std::size_t i = 0; i + 1 < parameters.size(); ++i)
    {
      loop.points.push_back(i == 0 ? start : PointAt(piece, parameters[i]));
      loop.segments.push_back({ curve, piece.name });
    }
  }

  const std::vector<DrawingPiece>& Pieces;
  double Extent;
  DrawingOutline& Outline;
  SamplingRule Rule;
  int LineCurve = -1;
};
}

DrawingOutline TraceOutline(const Drawing& drawing, double tolerance, double turn)
{
  const double extent = ExtentOf(drawing.pieces);
  RequireExtent(extent);
  if (!(extent > 0.0))
  {
    throw Error("The drawing has no curves; draw the boundary of the domain.");
  }
  const PieceChains chains =
    ChainPieces(drawing.pieces, tolerance > 0.0 ? tolerance : DefaultJoinTolerance(drawing.pieces));
  DrawingOutline outline;
  outline.largestGap = chains.largestGap;
  outline.warnings = drawing.warnings;
  outline.warnings.insert(outline.warnings.end(), chains.warnings.begin(), chains.warnings.end());
  OutlineTracer tracer(drawing, extent, turn, outline);
  for (const std::vector<ChainedPiece>& chain : chains.chains)
  {
    tracer.Trace(chain);
  }
  return outline;
}
}
