#include "FlatMetric.h"

#include "Index.h"
#include "MetricDerivatives.h"
#include "MetricRemeshing.h"

namespace crossfield
{
namespace
{
/// Returns H at the vertices of a metric: means over triangles, and over neighbours for vertices
/// that are not of the mesh of the frames.
Eigen::VectorXd VertexValues(
  const MeshTopology& topology, const Eigen::VectorXd& ofTriangles, const ConeMetric& metric)
{
  const auto given = static_cast<int>(topology.mesh.points.size());
  const auto count = static_cast<Eigen::Index>(metric.Points().size());
  Eigen::VectorXd sums = Eigen::VectorXd::Zero(count);
  Eigen::VectorXd weights = Eigen::VectorXd::Zero(count);
  for (std::size_t t = 0; t < topology.mesh.triangles.size(); ++t)
  {
    for (const int v : topology.mesh.triangles[t])
    {
      sums[v] += ofTriangles[static_cast<Eigen::Index>(t)];
      weights[v] += 1.0;
    }
  }
  Eigen::VectorXd values = sums.cwiseQuotient(weights.cwiseMax(1.0));
  for (const ConeMetric::Triangle& triangle : metric.Triangles())
  {
    for (const int v : triangle.vertices)
    {
      for (const int other : triangle.vertices)
      {
        if (v >= given && other < given)
        {
          sums[v] += values[other];
          weights[v] += 1.0;
        }
      }
    }
  }
  return sums.cwiseQuotient(weights.cwiseMax(1.0));
}

/// Multiplies lengths by e^{−H}, or by a root of it if that leaves no triangle degenerate: the
/// first Newton steps are conformal and do the rest.
void ScaleLengths(const Eigen::VectorXd& h, ConeMetric& metric)
{
  const Eigen::VectorXd scale = ConformalChanges(metric, h);
  const std::vector<double> start = metric.LogLengths();
  for (double part = 1.0; part > 0.0; part -= 0.25)
  {
    std::vector<double> logs = start;
    for (std::size_t e = 0; e < logs.size(); ++e)
    {
      logs[e] -= part * scale[static_cast<Eigen::Index>(e)];
    }
    metric.SetLogLengths(std::move(logs));
    if (metric.IsValid())
    {
      return;
    }
  }
  metric.SetLogLengths(start);
}
}

FlattenedTargets FlattenFrames(const SharedTopology& topology, const TriangleFrames& frames,
  const std::vector<Cone>& cones, const Progress& progress)
{
  ConeMetric start(*topology, frames.jump, cones);
  SplitNarrowFans(start);
  ScaleLengths(VertexValues(*topology, frames.h, start), start);
  FlattenedTargets result;
  // 0.3 to 0.7 is a good compromise: near 0 the maximum of the strain is least and its mean large,
  // near 1 strains are unbounded at the poles (docs/method.md §12.5).
  for (const double quantile : { 0.3, 0.7 })
  {
    ConeMetric metric = start;
    result.report = FlattenMetric(metric, quantile, progress);
    if (result.report.converged)
    {
      result.targets = LayOut(metric);
      return result;
    }
  }
  return result;
}
}
