#include "MeshGrade.h"

#include "SizeSearch.h"
#include "TargetLengths.h"

#include <algorithm>
#include <cmath>
#include <tuple>

namespace crossfield
{
bool MeshGrade::operator<(const MeshGrade& other) const
{
  const auto values = [](const MeshGrade& grade)
  {
    return std::tie(
      grade.inverted, grade.count, grade.area, grade.shape, grade.variation, grade.blocks);
  };
  return values(*this) < values(other);
}

MeshGrade GradeOf(const QuadResult& quads, double quadSize, int quadCount, double attainable)
{
  const QuadQuality& quality = quads.quality;
  const double bound = std::max(attainable, quality.bound);
  return { quality.inverted, CountExcess(quads, quadSize, quadCount),
    std::max(0.0, AreaError(quads) - AcceptableAreaError),
    std::max(0.0, GoodShape - quality.jacobian.min / bound),
    std::max(0.0, quality.variation - GoodVariation), quads.blocks.blocks.size() };
}

double AreaError(const QuadResult& quads)
{
  double area = 0.0;
  for (const QuadBoundaryEdge& edge : quads.mesh.boundary)
  {
    const auto at = [&](std::size_t end) { return quads.mesh.points[edge.points[end]].InPlane(); };
    area += edge.kind == BoundaryKind::Interface ? 0.0 : 0.5 * Cross(at(0), at(1));
  }
  const double whole = AreaOf(quads.tMesh);
  return whole > 0.0 ? std::abs(area / whole - 1.0) : 0.0;
}

double CountExcess(const QuadResult& quads, double quadSize, int quadCount)
{
  const auto count = static_cast<double>(quads.mesh.quads.size());
  return quadSize > 0.0 || quadCount == 0
    ? 0.0
    : std::max(0.0, std::abs(count / quadCount - 1.0) - CountTolerance);
}

bool IsAsGood(const QuadQuality& quality, const QuadQuality& other, const MergeTolerance& tolerance)
{
  return quality.inverted == 0 &&
    quality.jacobian.min >=
    tolerance.jacobianFactor * other.jacobian.min - tolerance.jacobianDrop &&
    quality.jacobian.mean >= other.jacobian.mean - tolerance.meanDrop &&
    quality.variation <= std::max(tolerance.variationFactor * other.variation,
                           other.variation + tolerance.variationRise);
}

bool IsAsClean(const QuadResult& quads, const QuadResult& other, double quadSize, int quadCount)
{
  return IsAsGood(quads.quality, other.quality, CleanTolerance) &&
    CountExcess(quads, quadSize, quadCount) <= CountExcess(other, quadSize, quadCount);
}

bool IsCoarser(const QuadResult& quads, const QuadResult& other)
{
  const std::size_t blocks = quads.blocks.blocks.size();
  const std::size_t others = other.blocks.blocks.size();
  return blocks != others ? blocks < others
                          : quads.quality.jacobian.min > other.quality.jacobian.min;
}
}
