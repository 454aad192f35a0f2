#include "QuadBand.h"

#include "Error.h"
#include "Index.h"

#include <algorithm>
#include <set>

namespace crossfield
{
namespace
{
/// Returns the number of a row through a quad, in the direction of one of its sides.
std::size_t RowThrough(int side)
{
  return Index(side / 4 * 2 + side % 2);
}

class Finder
{
public:
  Finder(const LayeredMesh& layered, const QuadWalk& walk)
    : Layered(layered)
    , Walk(walk)
    , LayerOfSide(4 * layered.mesh.quads.size(), -1)
    , IsTaken(2 * layered.mesh.quads.size(), false)
    , IsFree(layered.mesh.points.size(), false)
    , Walls(walk.OfBoundary())
  {
    this->MarkPoints();
  }

  std::vector<QuadBand> Find(int maximumRows)
  {
    std::vector<QuadBand> bands = this->FirstRows();
    std::vector<bool> grows(bands.size(), true);
    for (int row = 1; row < maximumRows; ++row)
    {
      for (std::size_t b = 0; b < bands.size(); ++b)
      {
        grows[b] = grows[b] && this->AddRow(bands[b]);
      }
    }
    return bands;
  }

  /// Returns the band with a layered edge, with a number of rows that it has.
  QuadBand FindOne(std::size_t edge, int rows)
  {
    QuadBand band = this->FirstRow(this->Walls[edge]);
    while (static_cast<int>(band.rows.size()) < rows)
    {
      if (!this->AddRow(band))
      {
        throw Error("The layer of '" + this->NameOf(band) + "' has no room near " +
          Describe(band.place) + " beside other layers; use smaller quads.");
      }
    }
    return band;
  }

  std::optional<QuadBand> FindBehind(
    const std::vector<DividedBand>& divided, int maximumRows, double ratio)
  {
    std::vector<QuadBand> bands;
    for (const DividedBand& one : divided)
    {
      bands.push_back(this->FindOne(one.edge, one.rows));
    }
    for (const QuadBand& band : bands)
    {
      const std::vector<int>& row = band.rows[0];
      for (std::size_t i = 0; i < row.size(); ++i)
      {
        const int behind = this->Walk.Twin(row[i]);
        if (behind < 0 || this->IsTaken[RowThrough(behind)])
        {
          continue;
        }
        QuadBand found;
        found.growth = band.growth;
        if (this->FollowBehind(behind, std::set<int>(row.begin(), row.end()), ratio, found))
        {
          while (static_cast<int>(found.rows.size()) < maximumRows && this->AddRow(found))
          {
          }
          return found;
        }
      }
    }
    return std::nullopt;
  }

private:
  /// Sets the first row of a band behind other sides, and the heights of these. Returns whether all
  /// of the row is behind them, free, and one of its quads higher by more than a ratio.
  bool FollowBehind(int wall, const std::set<int>& sides, double ratio, QuadBand& band)
  {
    const std::vector<int> row = this->Walk.RowThrough(wall);
    double largest = 0.0;
    for (const int side : row)
    {
      if (sides.count(this->Walk.Twin(side)) == 0)
      {
        return false;
      }
      const double height = this->Walk.Height(this->Walk.Twin(side));
      largest = std::max(largest, this->Walk.Height(side) / height);
      band.heights.push_back(height);
    }
    band.closed = this->Walk.Forward(row.back()) == row.front();
    if (largest <= ratio || band.closed || !this->Take(row, band))
    {
      return false;
    }
    // From columns to the lines between them.
    std::vector<double> lines = { band.heights.front() };
    for (std::size_t i = 1; i < row.size(); ++i)
    {
      lines.push_back(0.5 * (band.heights[i - 1] + band.heights[i]));
    }
    lines.push_back(band.heights.back());
    band.heights = std::move(lines);
    band.layers.assign(row.size(), -1);
    band.rows = { row };
    return true;
  }

  const QuadPoint& PointOf(int point) const { return this->Layered.mesh.points[point]; }

  /// Marks the points that the inner lines of a band may have: regular ones, and not corners or
  /// ends of sides.
  void MarkPoints()
  {
    const QuadMesh& mesh = this->Layered.mesh;
    for (std::size_t p = 0; p < mesh.points.size(); ++p)
    {
      const QuadPoint& point = mesh.points[p];
      this->IsFree[p] = point.valence == (point.curve.loop < 0 ? 4 : 2) && !point.fixed;
    }
    std::vector<int> nameAt(mesh.points.size(), -1);
    for (std::size_t e = 0; e < mesh.boundary.size(); ++e)
    {
      nameAt[mesh.boundary[e].points[0]] = mesh.boundary[e].side;
    }
    for (std::size_t e = 0; e < mesh.boundary.size(); ++e)
    {
      this->LayerOfSide[this->Walls[e]] = this->Layered.LayerAt(e);
      const std::size_t end = Index(mesh.boundary[e].points[1]);
      this->IsFree[end] = this->IsFree[end] && nameAt[end] == mesh.boundary[e].side;
    }
  }

  /// Returns the bands with their first rows, which need no regular points.
  std::vector<QuadBand> FirstRows()
  {
    std::vector<QuadBand> bands;
    std::vector<bool> isVisited(this->LayerOfSide.size(), false);
    for (std::size_t e = 0; e < this->Layered.mesh.boundary.size(); ++e)
    {
      if (this->Layered.LayerAt(e) < 0 || isVisited[this->Walls[e]])
      {
        continue;
      }
      bands.push_back(this->FirstRow(this->Walls[e]));
      for (const int side : bands.back().rows[0])
      {
        isVisited[side] = true;
      }
    }
    return bands;
  }

  /// Returns the band with a wall, with its first row.
  QuadBand FirstRow(int wall)
  {
    QuadBand band;
    const std::vector<int> row = this->Walk.RowThrough(wall);
    band.closed = this->Walk.Forward(row.back()) == row.front();
    for (const int side : row)
    {
      const int layer = this->LayerOfSide[side];
      band.layers.push_back(layer);
      if (layer >= 0)
      {
        const double growth = this->Layered.prescriptions[layer].growth;
        band.growth = band.growth > 0.0 ? std::min(band.growth, growth) : growth;
      }
    }
    band.rows.push_back(row);
    if (!this->Take(row, band))
    {
      throw Error("The quads beside '" + this->NameOf(band) + "' near " +
        Describe(this->PointOf(this->Walk.StartOf(wall)).InPlane()) +
        " are also beside another side with a layer, or beside this one again; use smaller quads.");
    }
    return band;
  }

  /// Returns the name of the first layered side of a band.
  std::string NameOf(const QuadBand& band) const
  {
    const int layer = *std::max_element(band.layers.begin(), band.layers.end());
    return this->Layered.prescriptions[layer].name;
  }

  /// Reserves a row of quads for a band; returns whether it is free, and none of its quads is in
  /// the band already.
  bool Take(const std::vector<int>& row, QuadBand& band)
  {
    std::set<int> quads = band.quads;
    for (const int side : row)
    {
      if (this->IsTaken[RowThrough(side)] || !quads.insert(side / 4).second)
      {
        return false;
      }
    }
    for (const int side : row)
    {
      this->IsTaken[RowThrough(side)] = true;
    }
    band.quads = std::move(quads);
    return true;
  }

  /// Adds the next row to a band if there is one.
  bool AddRow(QuadBand& band)
  {
    const std::vector<int>& last = band.rows.back();
    const auto fail = [&](BandEnd end, int point)
    {
      band.end = end;
      band.place = this->PointOf(point).InPlane();
      return false;
    };
    std::vector<int> next;
    for (std::size_t i = 0; i < last.size(); ++i)
    {
      const int top = QuadWalk::Opposite(last[i]);
      const int left = this->Walk.EndOf(top);
      const int right = this->Walk.StartOf(top);
      for (const int point : { left, right })
      {
        if (!this->IsFree[point])
        {
          const QuadPoint& found = this->PointOf(point);
          return fail(found.curve.loop < 0 ? BandEnd::Irregular : BandEnd::Boundary, point);
        }
      }
      const int above = this->Walk.Above(last[i]);
      if (above < 0)
      {
        return fail(BandEnd::Boundary, left);
      }
      next.push_back(above);
    }
    for (std::size_t i = 0; i < next.size(); ++i)
    {
      const bool isLast = i + 1 == next.size();
      const int expected = !isLast ? next[i + 1] : band.closed ? next[0] : -1;
      if (this->Walk.Forward(next[i]) != expected)
      {
        return fail(BandEnd::Irregular, this->Walk.EndOf(next[i]));
      }
    }
    if (!this->Take(next, band))
    {
      return fail(BandEnd::Other, this->Walk.StartOf(next[0]));
    }
    band.rows.push_back(std::move(next));
    return true;
  }

  const LayeredMesh& Layered;
  const QuadWalk& Walk;
  std::vector<int> LayerOfSide; ///< Per side of a quad.
  std::vector<bool> IsTaken;    ///< Per row through a quad.
  std::vector<bool> IsFree;     ///< Per point.
  std::vector<int> Walls;       ///< Per edge of the boundary, the side of a quad there.
};
}

std::vector<QuadBand> FindBands(const LayeredMesh& layered, const QuadWalk& walk, int maximumRows)
{
  return Finder(layered, walk).Find(maximumRows);
}

QuadBand FindBand(const LayeredMesh& layered, const QuadWalk& walk, std::size_t edge, int rows)
{
  return Finder(layered, walk).FindOne(edge, rows);
}

std::optional<QuadBand> FindBandBehind(const LayeredMesh& layered, const QuadWalk& walk,
  const std::vector<DividedBand>& divided, int maximumRows, double ratio)
{
  return Finder(layered, walk).FindBehind(divided, maximumRows, ratio);
}

std::vector<int> PointsAcross(
  const QuadBand& band, const QuadWalk& walk, std::size_t line, int rows)
{
  const bool isLast = line == band.rows[0].size();
  const std::size_t column = isLast ? line - 1 : line;
  std::vector<int> points;
  for (int row = 0; row < rows; ++row)
  {
    const int side = band.rows[row][column];
    points.push_back(isLast ? walk.EndOf(side) : walk.StartOf(side));
  }
  const int top = QuadWalk::Opposite(band.rows[rows - 1][column]);
  points.push_back(isLast ? walk.StartOf(top) : walk.EndOf(top));
  return points;
}
}
