#include "TMeshConversion.h"

#include "ColumnWriting.h"
#include "Error.h"
#include "Index.h"
#include "PlanarTopology.h"
#include "TraceGraph.h"
#include "vtkCrossFieldArrayNames.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkPointData.h"

#include <algorithm>
#include <string>

namespace names = vtkCrossFieldArrayNames;

namespace
{
using crossfield::Index;
using crossfield::Point;
using crossfield::SpacePoint;

/** Cell data of a line. */
struct LineRow
{
  int line = -1;
  int singularity = -1;
  int quarterIndex = 0;
  int endsAt = 0;
  int seed = -1;
  double length = 0.0;
};

/** Polylines with their cell data. */
class LineWriter
{
public:
  LineWriter(const crossfield::DomainPlane& plane, vtkPolyData* output)
    : Plane(plane)
    , Output(output)
  {
    this->Points->SetDataTypeToDouble();
  }

  void Add(const std::vector<SpacePoint>& polyline, const LineRow& row)
  {
    this->Lines->InsertNextCell(static_cast<int>(polyline.size()));
    for (const SpacePoint& point : polyline)
    {
      this->Lines->InsertCellPoint(
        this->Points->InsertNextPoint(this->Plane.PlaceToSpace(point).data()));
    }
    this->Rows.push_back(row);
  }

  void Write()
  {
    this->Output->SetPoints(this->Points);
    this->Output->SetLines(this->Lines);
    vtkCellData* data = this->Output->GetCellData();
    const auto add = [&](const char* name, int LineRow::*member)
    {
      ColumnWriting::AddColumn<vtkIntArray>(
        data, name, this->Rows, [member](const LineRow& row) { return row.*member; });
    };
    add(names::Line, &LineRow::line);
    add(names::Singularity, &LineRow::singularity);
    add(names::QuarterIndex, &LineRow::quarterIndex);
    add(names::EndsAt, &LineRow::endsAt);
    add(names::Seed, &LineRow::seed);
    ColumnWriting::AddColumn<vtkDoubleArray>(
      data, names::Length, this->Rows, [](const LineRow& row) { return row.length; });
  }

private:
  const crossfield::DomainPlane& Plane;
  vtkPolyData* Output;
  vtkNew<vtkPoints> Points;
  vtkNew<vtkCellArray> Lines;
  std::vector<LineRow> Rows;
};

/**
 * Returns the triangle that contains a point of the plane and stores its position in the map; −1 if
 * the point is outside.
 */
int Locate(const crossfield::SeamlessMap& map, const Point& place, Point& w)
{
  const crossfield::SharedPlanarTopology topology = crossfield::RequirePlanar(map.topology);
  const auto& triangles = topology->mesh.triangles;
  for (int t = 0; t < static_cast<int>(triangles.size()); ++t)
  {
    const Point& a = topology->PointAt(triangles[t][0]);
    const Point b = topology->PointAt(triangles[t][1]) - a;
    const Point c = topology->PointAt(triangles[t][2]) - a;
    const double area = crossfield::Cross(b, c);
    const double beta = crossfield::Cross(place - a, c) / area;
    const double gamma = crossfield::Cross(b, place - a) / area;
    // Tolerance for rounding, so that seeds on edges are found.
    constexpr double Tolerance = -1e-12;
    if (beta >= Tolerance && gamma >= Tolerance && 1.0 - beta - gamma >= Tolerance)
    {
      w =
        map.At(t, 0) + beta * (map.At(t, 1) - map.At(t, 0)) + gamma * (map.At(t, 2) - map.At(t, 0));
      return t;
    }
  }
  return -1;
}
}

namespace TMeshConversion
{
//------------------------------------------------------------------------------
void WriteTraces(const MapConversion::Map& traced, const crossfield::TraceGraph& graph,
  const std::vector<Point>& seeds, double longest, vtkPolyData* output)
{
  const crossfield::SeamlessMap& map = traced.map;
  const crossfield::LineWalk walk(map);
  LineWriter writer(traced.plane, output);
  for (std::size_t i = 0; i < graph.separatrices.size(); ++i)
  {
    const crossfield::TracedSeparatrix& line = graph.separatrices[i];
    const crossfield::LineSegment& first = line.segments.front();
    std::vector<SpacePoint> polyline = { walk.PlaceAt(first.triangle, first.entry) };
    for (int s = 0; s < line.lastSegment; ++s)
    {
      const crossfield::LineSegment& segment = line.segments[s];
      polyline.push_back(walk.PlaceAt(segment.triangle, segment.exit));
    }
    polyline.push_back(walk.PlaceAt(line.segments[line.lastSegment], line.length));
    LineRow row;
    row.line = static_cast<int>(i);
    if (line.cone >= 0)
    {
      row.singularity = map.cones[line.cone].row;
      row.quarterIndex = map.cones[line.cone].quarterIndex;
    }
    row.endsAt = static_cast<int>(line.end);
    row.length = line.length;
    writer.Add(polyline, row);
  }
  for (std::size_t seed = 0; seed < seeds.size(); ++seed)
  {
    Point w;
    const int triangle = Locate(map, seeds[seed], w);
    if (triangle < 0)
    {
      throw crossfield::Error("The seed " + std::to_string(seed) + " at " +
        crossfield::Describe(seeds[seed]) + " lies outside the domain; move it inside.");
    }
    for (int direction = 0; direction < 4; ++direction)
    {
      const auto segments = crossfield::TraceStreamline(map, triangle, w, direction, longest);
      std::vector<SpacePoint> polyline = { { seeds[seed].x(), seeds[seed].y(), 0.0 } };
      for (const crossfield::LineSegment& segment : segments)
      {
        polyline.push_back(segment.exitLength <= longest
            ? walk.PlaceAt(segment.triangle, segment.exit)
            : walk.PlaceAt(segment, longest));
      }
      LineRow row;
      row.seed = static_cast<int>(seed);
      row.length = std::min(longest, segments.back().exitLength);
      const bool ends = walk.Beyond(segments.back()) < 0 && segments.back().exitLength <= longest;
      row.endsAt = static_cast<int>(
        ends ? crossfield::SeparatrixEnd::Boundary : crossfield::SeparatrixEnd::None);
      writer.Add(polyline, row);
    }
  }
  writer.Write();
}

//------------------------------------------------------------------------------
void WriteArcs(const MapConversion::Map& traced, const crossfield::TMesh& mesh, vtkPolyData* output)
{
  // Arcs follow their separatrix from its start on.
  std::vector<int> coneOf(Index(mesh.separatrixCount), -1);
  for (std::size_t half = 0; half < mesh.halfEdges.size(); ++half)
  {
    const int separatrix = mesh.arcs[half / 2].separatrix;
    const int cone = mesh.nodes[Index(mesh.halfEdges[half].node)].cone;
    if (separatrix >= 0 && cone >= 0 && coneOf[Index(separatrix)] < 0)
    {
      coneOf[Index(separatrix)] = cone;
    }
  }
  LineWriter writer(traced.plane, output);
  for (const crossfield::TArc& arc : mesh.arcs)
  {
    if (arc.separatrix < 0)
    {
      continue;
    }
    LineRow row;
    row.line = arc.separatrix;
    row.length = arc.length;
    const int cone = coneOf[Index(arc.separatrix)];
    if (cone >= 0)
    {
      row.singularity = traced.map.cones[Index(cone)].row;
      row.quarterIndex = traced.map.cones[Index(cone)].quarterIndex;
    }
    writer.Add(arc.polyline, row);
  }
  writer.Write();
}

//------------------------------------------------------------------------------
void AddCounts(const crossfield::TMesh& mesh, vtkFieldData* field)
{
  const auto count = [](std::size_t size) { return static_cast<int>(size); };
  ColumnWriting::AddIntegers(field, names::Lines, { mesh.separatrixCount });
  ColumnWriting::AddIntegers(field, names::Faces, { count(mesh.patches.size()) });
  ColumnWriting::AddIntegers(field, names::Arcs, { count(mesh.arcs.size()) });
  ColumnWriting::AddIntegers(field, names::ExtraLines, { mesh.extraSeparatrices });
  ColumnWriting::AddIntegers(field, names::HeadOn, { mesh.headOn });
  ColumnWriting::AddIntegers(field, names::Flips, { 0 });
  ColumnWriting::AddNumbers(field, names::Longest, { mesh.longest });
  ColumnWriting::AddNumbers(field, names::Mismatch, { mesh.Mismatch() });
}
}
