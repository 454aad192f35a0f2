#include "PaperFigures.h"

#include <cmath>

namespace
{
using Rows = std::vector<std::array<double, 4>>;

/** Returns four singularities k = +1 on the diagonals of the disk. */
Rows Square(double distance, double radius)
{
  const double d = distance * std::sqrt(0.5);
  return { { d, d, 1, radius }, { -d, d, 1, radius }, { -d, -d, 1, radius }, { d, -d, 1, radius } };
}
}

std::vector<PaperFigure> PaperFigures()
{
  return {
    { "ring_040", "ringRatio, left", "eight singularities, four +1/4 and four -1/4", "ring", 0.4,
      "ginzburg-landau-constant", 0.03, 0.01, {} },
    { "ring_046", "ringRatio, right", "no singularity", "ring", 0.46, "ginzburg-landau", 0.03, 0.01,
      {} },
    { "disk_holes", "firstFormulationDisk", "four +1/4, 13 iterations", "disk", 0.0, "constrained",
      0.05, 0.0, Square(0.6, 0.1) },
    { "disk_moved", "diskV4", "four +1/4, at most 30 iterations", "disk", 0.0, "constrained", 0.05,
      0.0,
      { { 0.0, 0.0, 1, 0.01 }, { -0.2, 0.2, 1, 0.01 }, { 0.2, -0.2, 1, 0.01 },
        { -0.2, -0.2, 1, 0.01 } } },
    { "ellipse_reference", "ellipse, above", "four +1/4 nearly on a line", "ellipse", 0.0,
      "ginzburg-landau", 0.06, 0.06, {} },
    { "ellipse_holes", "ellipse, below", "a rectangle of four +1/4", "ellipse", 0.0, "unit-norm",
      0.06, 0.0,
      { { -2.1, -0.2, 1, 0.06 }, { -2.1, 0.2, 1, 0.06 }, { 2.1, -0.2, 1, 0.06 },
        { 2.1, 0.2, 1, 0.06 } } },
    { "disk_triangles", "oneTriangle", "works close to the Ginzburg-Landau positions", "disk", 0.0,
      "triangle-penalty", 0.05, 0.05, Square(0.85, 0.0) },
    { "quarter_disk", "normHole", "-1/4 on the circle, two +1/4 appear, the corners take the rest",
      "quarter-disk", 0.0, "imprint-unit", 0.03, 0.0, { { 0.42, 0.42, -1, 0.1 } } },
    { "disk_reference", "diskGL", "four +1/4", "disk", 0.0, "ginzburg-landau", 0.05, 0.05, {} },
    { "disk_wrong_sum", "holeAndGL", "opposite singularities stick to holes placed too far away",
      "disk", 0.0, "penalty", 0.05, 0.05,
      { { -0.6, 0.6, 1, 0.1 }, { -0.6, -0.6, 1, 0.1 }, { 0.6, -0.35, 1, 0.1 },
        { -0.2, 0.2, -1, 0.1 }, { -0.2, -0.2, -1, 0.1 }, { 0.5, -0.62, -1, 0.05 },
        { 0.6, 0.6, -1, 0.1 } } },
    { "angular_balanced", "threeAngularDomsMeshes, first", "the indices inside add up to 0",
      "angular-balanced", 0.0, "unit-norm", 0.05, 0.0, {}, true },
    { "angular_negative", "threeAngularDomsMeshes, second", "two singularities -1/4",
      "angular-negative", 0.0, "unit-norm", 0.05, 0.0, {}, true },
    { "angular_positive", "threeAngularDomsMeshes, third", "two singularities +1/4",
      "angular-positive", 0.0, "unit-norm", 0.05, 0.0, {}, true },
    { "angular_hole", "test2",
      "six singular holes: four of one sign around the hole, two of the other between large angles",
      "angular-hole", 0.0, "unit-norm", 0.03, 0.0,
      { { 0.0, 0.42, 1, 0.025 }, { 0.0, -0.42, 1, 0.025 }, { 0.4, 0.2, -1, 0.05 },
        { -0.4, 0.2, -1, 0.05 }, { -0.4, -0.2, -1, 0.05 }, { 0.4, -0.2, -1, 0.05 } } },
    { "h_field", "singdeltas, h, hiso", "H from a linear problem, isolines normal to the boundary",
      "l-shape", 0.0, "h", 0.02, 0.0,
      { { 0.15, 0.2, 1, 0.0 }, { 0.9, 0.15, 1, 0.0 }, { 0.7, 0.38, 1, 0.0 }, { 0.2, 0.8, 1, 0.0 },
        { 0.55, 0.15, -1, 0.0 }, { 0.2, 0.55, -1, 0.0 }, { 0.4, 0.36, -1, 0.0 },
        { 0.85, 0.5, -1, 0.0 } } },
  };
}
