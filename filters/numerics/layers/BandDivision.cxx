#include "BandDivision.h"

#include "Index.h"

#include <algorithm>
#include <map>
#include <utility>

namespace crossfield
{
namespace
{
class Divider
{
public:
  Divider(LayeredMesh& layered, const QuadBand& band, const QuadWalk& walk,
    const std::vector<std::vector<QuadPoint>>& lines)
    : Layered(layered)
    , Mesh(layered.mesh)
    , Band(band)
    , Walk(walk)
    , Rows(static_cast<int>(lines[0].size()) + 1)
    , OldRows(static_cast<int>(band.rows.size()))
    , IsInBand(layered.mesh.quads.size(), false)
    , IsRemoved(layered.mesh.points.size(), false)
  {
    for (const int quad : band.quads)
    {
      this->IsInBand[quad] = true;
    }
    for (std::size_t line = 0; line < lines.size(); ++line)
    {
      this->AddLine(line, lines[line]);
    }
  }

  void Divide()
  {
    this->DivideQuads();
    this->DivideBoundary();
    this->RemovePoints();
  }

private:
  /// Adds the new points of a line to the mesh, after all old ones.
  void AddLine(std::size_t line, const std::vector<QuadPoint>& points)
  {
    std::vector<int> old = PointsAcross(this->Band, this->Walk, line, this->OldRows);
    std::vector<int> divided = { old.front() };
    for (const QuadPoint& point : points)
    {
      divided.push_back(static_cast<int>(this->Mesh.points.size()));
      this->Mesh.points.push_back(point);
    }
    divided.push_back(old.back());
    for (std::size_t level = 1; level + 1 < old.size(); ++level)
    {
      this->IsRemoved[old[level]] = true;
    }
    this->OldLines.push_back(std::move(old));
    this->Lines.push_back(std::move(divided));
  }

  void DivideQuads()
  {
    std::vector<std::array<int, 4>> quads;
    std::vector<std::array<double, 2>> targetLengths;
    std::vector<int> patch;
    std::vector<int> regions;
    std::map<std::pair<int, bool>, int> numbers = { { { 0, false }, 0 } };
    const auto regionOf = [&](std::size_t quad)
    {
      const auto key = std::make_pair(this->Layered.regions[quad], bool(this->IsInBand[quad]));
      return numbers.emplace(key, static_cast<int>(numbers.size())).first->second;
    };
    for (std::size_t q = 0; q < this->Mesh.quads.size(); ++q)
    {
      const int region = regionOf(q);
      if (!this->IsInBand[q])
      {
        quads.push_back(this->Mesh.quads[q]);
        targetLengths.push_back(this->Mesh.targetLengths[q]);
        patch.push_back(this->Mesh.patch[q]);
        regions.push_back(region);
      }
    }
    const std::size_t columns = this->Band.rows[0].size();
    for (std::size_t column = 0; column < columns; ++column)
    {
      const std::vector<int>& left = this->Lines[column];
      const std::vector<int>& right = this->Lines[(column + 1) % this->Lines.size()];
      for (int row = 0; row < this->Rows; ++row)
      {
        const int oldRow = row * this->OldRows / this->Rows;
        const std::size_t old = Index(this->Band.rows[oldRow][column] / 4);
        const std::array<int, 4> quad = { left[row], right[row], right[row + 1], left[row + 1] };
        quads.push_back(quad);
        targetLengths.push_back(
          { 0.5 * (this->Length(quad[0], quad[1]) + this->Length(quad[2], quad[3])),
            0.5 * (this->Length(quad[1], quad[2]) + this->Length(quad[3], quad[0])) });
        patch.push_back(this->Mesh.patch[old]);
        regions.push_back(regionOf(old));
      }
    }
    this->Mesh.quads = std::move(quads);
    this->Mesh.targetLengths = std::move(targetLengths);
    this->Mesh.patch = std::move(patch);
    this->Layered.regions = std::move(regions);
  }

  double Length(int from, int to) const
  {
    return (this->Mesh.points[to].place - this->Mesh.points[from].place).norm();
  }

  /// Replaces the edges at the ends of an open band.
  void DivideBoundary()
  {
    if (this->Band.closed)
    {
      return;
    }
    // The boundary leads down the first line and up the last one. An edge at the wall's end is
    // replaced by all new edges, the others are removed.
    std::map<std::array<int, 2>, std::vector<int>> replacements;
    for (const std::size_t line : { std::size_t(0), this->Lines.size() - 1 })
    {
      std::vector<int> old = this->OldLines[line];
      std::vector<int> divided = this->Lines[line];
      if (line == 0)
      {
        std::reverse(old.begin(), old.end());
        std::reverse(divided.begin(), divided.end());
      }
      for (std::size_t level = 0; level + 1 < old.size(); ++level)
      {
        replacements[{ old[level], old[level + 1] }] = level == 0 ? divided : std::vector<int>();
      }
    }
    LayeredMesh& layered = this->Layered;
    std::vector<QuadBoundaryEdge> boundary;
    std::vector<int> bands;
    for (std::size_t e = 0; e < this->Mesh.boundary.size(); ++e)
    {
      QuadBoundaryEdge edge = this->Mesh.boundary[e];
      const auto found = replacements.find(edge.points);
      const std::vector<int> points = found == replacements.end()
        ? std::vector<int>(edge.points.begin(), edge.points.end())
        : found->second;
      for (std::size_t i = 0; i + 1 < points.size(); ++i)
      {
        edge.points = { points[i], points[i + 1] };
        boundary.push_back(edge);
        bands.push_back(layered.bands[e]);
      }
    }
    this->Mesh.boundary = std::move(boundary);
    layered.bands = std::move(bands);
  }

  void RemovePoints()
  {
    std::vector<int> numbers(this->Mesh.points.size(), -1);
    std::size_t kept = 0;
    for (std::size_t p = 0; p < this->Mesh.points.size(); ++p)
    {
      if (p >= this->IsRemoved.size() || !this->IsRemoved[p])
      {
        numbers[p] = static_cast<int>(kept);
        this->Mesh.points[kept++] = this->Mesh.points[p];
      }
    }
    this->Mesh.points.resize(kept);
    for (std::array<int, 4>& quad : this->Mesh.quads)
    {
      for (int& point : quad)
      {
        point = numbers[point];
      }
    }
    for (QuadBoundaryEdge& edge : this->Mesh.boundary)
    {
      for (int& point : edge.points)
      {
        point = numbers[point];
      }
    }
  }

  LayeredMesh& Layered;
  QuadMesh& Mesh;
  const QuadBand& Band;
  const QuadWalk& Walk;
  const int Rows;
  const int OldRows;
  std::vector<bool> IsInBand;  ///< Per old quad.
  std::vector<bool> IsRemoved; ///< Per old point.
  std::vector<std::vector<int>> OldLines;
  std::vector<std::vector<int>> Lines;
};
}

void DivideBand(LayeredMesh& layered, const QuadBand& band, const QuadWalk& walk,
  const std::vector<std::vector<QuadPoint>>& lines)
{
  Divider(layered, band, walk, lines).Divide();
}
}
