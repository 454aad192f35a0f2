#ifndef TestInputs_h
#define TestInputs_h

#include "vtkSmartPointer.h"

#include <array>
#include <vector>

class vtkPolyData;
class vtkUnstructuredGrid;

/** The small inputs, made in code, that the tests of the filters share. */
namespace TestInputs
{
using Place = std::array<double, 2>;
using Curve = std::vector<Place>;  ///< Closed: the last place is joined to the first.
using Row = std::array<double, 4>; ///< x, y, quarter index, radius.

Curve Circle(int count, double radius, Place centre = { 0.0, 0.0 });
Curve Rectangle(Place lower, Place upper);

/** Closed polylines: the last point of a line is its first one. */
vtkSmartPointer<vtkPolyData> Loops(const std::vector<Curve>& curves, double z = 0.0);

/** A single polyline that is not closed. */
vtkSmartPointer<vtkPolyData> OpenCurve(const Curve& curve);

/**
 * The same curves the untidy way: clockwise, cut into lines of two points that each have points of
 * their own, in a shuffled order and half of them backwards.
 */
vtkSmartPointer<vtkPolyData> UntidyLoops(const std::vector<Curve>& curves, double z = 0.0);

/** Vertices with `QuarterIndex` (int) and `Radius`. */
vtkSmartPointer<vtkPolyData> Singularities(const std::vector<Row>& rows);

/**
 * Triangles on a grid of the unit squares of [0, 6]², but those of [2, 4]²: the boundary has an
 * outer and an inner loop.
 */
vtkSmartPointer<vtkPolyData> FrameMesh();
/** The boundary of FrameMesh with all its points. */
std::vector<Curve> FrameCurves();

/** The same points and cells as a vtkUnstructuredGrid. */
vtkSmartPointer<vtkUnstructuredGrid> AsUnstructuredGrid(vtkPolyData* input);

/** The unit disk drilled at FourOnDisk(). */
vtkSmartPointer<vtkUnstructuredGrid> DrilledDisk(double meshSize = 0.15);

/** A rectangle with an island, drilled at singularities of unlike indices that add up to −4. */
vtkSmartPointer<vtkUnstructuredGrid> DrilledIsland();

/** What vtkDrillHoles makes of a domain; `mode` as in vtkDrillHoles::SetMode. */
vtkSmartPointer<vtkUnstructuredGrid> Drill(
  vtkPolyData* domain, const std::vector<Row>& rows, double meshSize, int mode = 0);

/** Four +1 on the diagonals at distance 0.6 with radius 0.1. */
std::vector<Row> FourOnDisk();
}

#endif
