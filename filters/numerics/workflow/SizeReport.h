#pragma once

#include "QuadResult.h"
#include "TargetSize.h"

#include <optional>
#include <string>
#include <vector>

namespace crossfield
{
/// A part of a domain whose size was requested.
struct SizeSet
{
  std::string name;
  int side = -1;              ///< Index in BoundarySides::names, −1 if it is none.
  std::optional<Point> place; ///< Its centre; without a side and a centre it is the domain.
  double radius = 0.0;
};

/// Target sizes of quads from all that a request says about sizes.
struct SizeTargets
{
  SizeFunction length; ///< Side length of quads.
  double mean = 0.0;   ///< Side length of equal quads that would be as many (EquivalentSize).
  double factor = 1.0; ///< By which the requested sizes were multiplied for a number of quads.
  std::vector<SizeSet> sets; ///< Parts of the domain with requested sizes.
  std::string warning;       ///< If prescribed sizes grow faster than permitted.

  /// Multiplies all sizes.
  void Multiply(double by);
};

/// How closely a mesh has its target sizes (docs/method.md §14.8). The size of a quad is the square root
/// of its area.
struct SizeReport
{
  struct Sample
  {
    double area = 0.0;
    double target = 0.0;  ///< Target size at the centre.
    double Ratio() const; ///< Size over target size.
  };
  struct Set
  {
    std::string name;
    std::vector<double> ratios; ///< Of its quads.
    double Median() const;      ///< 0 without quads.
  };

  std::vector<Sample> samples; ///< One for each quad outside of layers.
  std::vector<Set> sets;       ///< Parts of the domain with requested sizes.
  double factor = 1.0;         ///< SizeTargets::factor.
  /// Largest ratio of the sizes of quads with a common edge, also in layers.
  double largestJump = 1.0;
  int nodesAdded = 0; ///< Singularities beyond those that are given or that the boundary requires.

  /// Returns the part of the area, and of the quads, whose size is within 25 % of the target.
  double AreaShare() const;
  double QuadShare() const;
  /// Returns the shares of the area in parts of 0.95 and of the quads in parts of 0.9, the smaller of both
  /// and at most 1.
  double Met() const;
  /// Returns the median of size over target size in the tenth of the quads with the smallest targets.
  double FineMedian() const;
  /// Adds the quads of another part of a domain.
  void Add(const SizeReport& other);
};

/// Measures the sizes of quads, without SizeReport::nodesAdded. Quads of a set are those with an edge on its
/// side, or with their centre in its disk, at least the nearest one; of the domain all of them.
SizeReport MeasureSizes(const QuadResult& quads, const SizeTargets& targets);

/// Measures the sizes of quads with a target each, without parts of the domain.
SizeReport MeasureTargets(const QuadMesh& mesh, const std::vector<double>& targets);

/// Returns a sentence that says where sizes are missed if less than 90 % of the area or of the quads are
/// within 25 %, or the median of a set differs by more than a factor of two; otherwise nothing.
std::string DescribeMissedSizes(const SizeReport& report);
}
