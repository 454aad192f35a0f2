#ifndef TestInputs_h
#define TestInputs_h

#include "vtkSmartPointer.h"

#include <array>
#include <vector>

class vtkPolyData;
class vtkUnstructuredGrid;

/** Small inputs that the tests of the filters share. */
namespace TestInputs
{
using Place = std::array<double, 2>;
using Curve = std::vector<Place>;  ///< Closed; the first position is not repeated.
using Row = std::array<double, 4>; ///< x, y, quarter index, radius.

Curve Circle(int count, double radius, Place centre = { 0.0, 0.0 });
Curve Rectangle(Place lower, Place upper);

/** Returns closed polylines, whose last point is the first one. */
vtkSmartPointer<vtkPolyData> Loops(const std::vector<Curve>& curves, double z = 0.0);

/** Returns a single polyline that is not closed. */
vtkSmartPointer<vtkPolyData> OpenCurve(const Curve& curve);

/**
 * Returns the same curves clockwise, divided into 2-point lines with separate points, in random
 * order and half of them reversed.
 */
vtkSmartPointer<vtkPolyData> UntidyLoops(const std::vector<Curve>& curves, double z = 0.0);

/** Returns vertices with `QuarterIndex` (int) and `Radius`. */
vtkSmartPointer<vtkPolyData> Singularities(const std::vector<Row>& rows);

/**
 * Returns triangles of a grid of unit squares that cover [0, 6]² without [2, 4]². The boundary has
 * an outer and an inner loop.
 */
vtkSmartPointer<vtkPolyData> FrameMesh();

/** Returns the boundary of FrameMesh with all its points. */
std::vector<Curve> FrameCurves();

/** Returns the same points and cells as a vtkUnstructuredGrid. */
vtkSmartPointer<vtkUnstructuredGrid> AsUnstructuredGrid(vtkPolyData* input);

/** Returns the unit disk drilled at FourOnDisk(). */
vtkSmartPointer<vtkUnstructuredGrid> DrilledDisk(double meshSize = 0.15);

/** Returns a rectangle with an island, drilled at singularities of several indices with sum −4. */
vtkSmartPointer<vtkUnstructuredGrid> DrilledIsland();

/** Returns the output of vtkDrillHoles for a domain; `mode` as in vtkDrillHoles::SetMode. */
vtkSmartPointer<vtkUnstructuredGrid> Drill(
  vtkPolyData* domain, const std::vector<Row>& rows, double meshSize, int mode = 0);

/** Returns the unit sphere as a cube of 6 n² quadrilaterals, blown up. */
vtkSmartPointer<vtkPolyData> BlownUpCube(int n = 8);

/** Returns four +1 on the diagonals at distance 0.6 from the origin with radius 0.1. */
std::vector<Row> FourOnDisk();
}

#endif
