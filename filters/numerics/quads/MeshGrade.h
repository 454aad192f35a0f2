#pragma once

#include "QuadResult.h"

#include <cstddef>
#include <limits>

namespace crossfield
{
/// Part of the attainable minimum scaled Jacobian (QuadQuality::bound) from which shapes need no
/// improvement: smoothing towards uniform sizes costs about as much.
constexpr double GoodShape = 0.8;
/// Part of it from which other singularities need not be tried.
constexpr double AcceptableShape = 0.6;
/// Standard deviation of sizes relative to their mean up to which sizes need no improvement.
constexpr double GoodVariation = 0.12;

/// Part of the area of the domain that may be lost where edges cut off curves of the boundary.
constexpr double AcceptableAreaError = 0.02;

/// What a mesh lacks. Of two meshes for the same request, the one with the smaller grade is better; its
/// members are compared in their order. Merging blocks is judged by IsAsClean instead, and positions of
/// the nodes of one mesh by SmoothQuads.
struct MeshGrade
{
  int inverted = 0;   ///< Number of inverted quads.
  double count = 0.0; ///< CountExcess.
  double area = 0.0;  ///< Excess of AreaError over AcceptableAreaError.
  /// What the minimum scaled Jacobian lacks to GoodShape, in parts of the attainable one.
  double shape = 0.0;
  double variation = 0.0; ///< Excess over GoodVariation.
  std::size_t blocks = 0; ///< Number of blocks.

  /// Returns whether shapes and sizes need no improvement.
  bool IsGood() const
  {
    return this->inverted == 0 && this->area == 0.0 && this->shape == 0.0 && this->variation == 0.0;
  }
  bool operator<(const MeshGrade& other) const;
};

/// Returns the grade of a mesh for a request of a size or, if that is 0, of a number of quads. `attainable` is
/// the minimum scaled Jacobian to compare with, if it exceeds that of the mesh: nodes that move along
/// the boundary may lower the attainable one, which is no merit.
MeshGrade GradeOf(const QuadResult& quads, double quadSize, int quadCount, double attainable = 0.0);

/// Returns the relative difference of the area of a mesh from that of its domain.
double AreaError(const QuadResult& quads);

/// Returns the relative error of a requested number of quads beyond CountTolerance, 0 if a size was
/// requested or no number.
double CountExcess(const QuadResult& quads, double quadSize, int quadCount);

/// How much worse than another mesh one with fewer blocks may be: bounds of its minimum and mean scaled
/// Jacobian and of its variation of sizes.
struct MergeTolerance
{
  double jacobianFactor; ///< The minimum is at least this times the other one, less jacobianDrop.
  double jacobianDrop;
  double meanDrop;        ///< The mean is at most this much smaller.
  double variationFactor; ///< The variation is at most this times the other one,
  double variationRise;   ///< or at most this much larger.
};

/// Where singularities move for fewer blocks: no loss of quality that a user would notice.
constexpr MergeTolerance CleanTolerance = { 1.0, 0.02, 0.002, 1.35, 0.05 };
/// Where separatrices are merged on request, at the cost of shapes: half of the minimum scaled Jacobian.
constexpr MergeTolerance CoarseTolerance = { 0.5, 0.0, std::numeric_limits<double>::infinity(), 1.0,
  std::numeric_limits<double>::infinity() };

/// Returns whether a mesh has no inverted quads and is as good as another one within the tolerance.
bool IsAsGood(
  const QuadQuality& quality, const QuadQuality& other, const MergeTolerance& tolerance);

/// Returns whether a mesh is as good as another one within CleanTolerance, and its number of quads as near
/// to the requested one, or within CountTolerance.
bool IsAsClean(const QuadResult& quads, const QuadResult& other, double quadSize, int quadCount);

/// Returns whether a mesh has fewer blocks than another one, or as many and a larger minimum scaled
/// Jacobian.
bool IsCoarser(const QuadResult& quads, const QuadResult& other);
}
