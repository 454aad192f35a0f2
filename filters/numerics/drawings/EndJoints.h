#pragma once

#include "Drawing.h"

#include <string>
#include <vector>

namespace crossfield
{
/// An end of a piece.
struct PieceEnd
{
  std::size_t piece = 0;
  bool isLast = false;
};

/// The joints between the ends of pieces: ends at exactly the same point, then pairs of other ends
/// within a tolerance. Lines that close such gaps, between pieces that are much longer, are left
/// out: they may lead back.
class EndJoints
{
public:
  /// `used` are the indices of the pieces to join, which must stay valid.
  EndJoints(
    const std::vector<DrawingPiece>& pieces, std::vector<std::size_t> used, double tolerance);

  /// Throws Error with the first place where the pieces do not form closed curves.
  void RequireClosed() const;

  /// Returns whether ends are joined in pairs, as in closed curves.
  bool IsClosed() const;
  /// Returns the number of ends that are joined with an end, itself included.
  std::size_t CountAt(const PieceEnd& end) const
  {
    return this->Members[this->GroupOf[2 * end.piece + (end.isLast ? 1 : 0)]].size();
  }

  /// Returns whether a piece is not left out because it is shorter than the tolerance.
  bool IsUsed(std::size_t piece) const { return this->Used[piece]; }
  /// Returns the end that an end is joined to, if RequireClosed does not throw.
  PieceEnd PartnerOf(const PieceEnd& end) const;
  /// Returns the maximum distance between joined ends.
  double LargestGap() const { return this->Widest; }
  /// Adds sentences about closed gaps and about pieces that are left out.
  void AddWarnings(std::vector<std::string>& warnings) const;

private:
  using Index = std::size_t; // twice the piece, plus 1 for its last end

  const Point& PlaceOf(Index end) const;
  bool IsOpen(Index end) const { return this->Members[this->GroupOf[end]].size() == 1; }
  void JoinExactly();
  void LeaveOutClosures(double tolerance);
  void JoinWithin(double tolerance);
  void Join(Index a, Index b);
  void JoinGap(Index a, Index b);
  void LeaveOutShort(double tolerance);
  /// Returns the ends of used pieces to which no other end is joined.
  std::vector<Index> OpenEnds() const;
  [[noreturn]] void ReportOpen(Index end) const;
  /// Returns the end of a remedy that offers the layers whose curves are closed; empty if they are
  /// none, or not closed together.
  std::string OfferLayers() const;
  /// Returns the piece on which an open end is located, other than its own; −1 if there is none.
  long PieceUnder(Index end) const;
  /// Returns a tolerance that closes all chains, 0 if none is found.
  double ToleranceThatCloses() const;

  const std::vector<DrawingPiece>& Pieces;
  std::vector<std::size_t> Given;
  double Tolerance;
  std::vector<bool> Used;
  std::vector<std::size_t> GroupOf;        ///< For each end.
  std::vector<std::vector<Index>> Members; ///< Ends that are joined.
  double Widest = 0.0;
  Point WidestPlace = Point::Zero();
  std::size_t Gaps = 0;
  std::size_t Short = 0;
};
}
