#include "FlatMetric.h"

#include "MetricRemeshing.h"
#include "SeamlessPoisson.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <utility>
#include <vector>

namespace crossfield
{
namespace
{
/// A mean of logarithms.
struct LogMean
{
  double sum = 0.0;
  int count = 0;

  void Add(double log)
  {
    this->sum += log;
    ++this->count;
  }
  double Value() const { return this->count > 0 ? this->sum / this->count : 0.0; }
};

/// Returns per edge of a metric the logarithm of its length in the targets of the seamless map over
/// that in the plane: the mean over its triangles, and over neighbours for edges that splits have
/// added.
std::vector<double> LogScales(
  const MeshTopology& topology, const SeamlessPoisson& targets, const ConeMetric& metric)
{
  std::map<std::pair<int, int>, LogMean> given;
  for (std::size_t t = 0; t < topology.mesh.triangles.size(); ++t)
  {
    const std::array<int, 3>& v = topology.mesh.triangles[t];
    for (int i = 0; i < 3; ++i)
    {
      const int j = (i + 1) % 3;
      const double image = (targets.target[t].row(j) - targets.target[t].row(i)).norm();
      const double length = topology.Length(topology.EdgeOf(static_cast<int>(t), i));
      given[std::minmax(v[i], v[j])].Add(std::log(image / length));
    }
  }
  std::vector<LogMean> scales(metric.LogLengths().size());
  std::vector<LogMean> nearby(scales.size());
  for (const ConeMetric::Triangle& triangle : metric.Triangles())
  {
    for (std::size_t i = 0; i < 3; ++i)
    {
      const auto found =
        given.find(std::minmax(triangle.vertices[i], triangle.vertices[(i + 1) % 3]));
      if (found != given.end())
      {
        scales[triangle.edges[i]].Add(found->second.Value());
        nearby[triangle.edges[(i + 1) % 3]].Add(found->second.Value());
        nearby[triangle.edges[(i + 2) % 3]].Add(found->second.Value());
      }
    }
  }
  std::vector<double> result;
  for (std::size_t e = 0; e < scales.size(); ++e)
  {
    result.push_back((scales[e].count > 0 ? scales[e] : nearby[e]).Value());
  }
  return result;
}

/// Multiplies lengths by e^scale, or by a root of it if that leaves no triangle degenerate: the
/// first Newton steps are conformal and do the rest.
void ScaleLengths(const std::vector<double>& scales, ConeMetric& metric)
{
  const std::vector<double> start = metric.LogLengths();
  for (double part = 1.0; part > 0.0; part -= 0.25)
  {
    std::vector<double> logs = start;
    for (std::size_t e = 0; e < logs.size(); ++e)
    {
      logs[e] += part * scales[e];
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

FlattenedTargets FlattenFrames(const MeshTopology& topology, const TriangleFrames& frames,
  const std::vector<Cone>& cones, const Progress& progress)
{
  ConeMetric start(topology, frames.jump, cones);
  SplitNarrowFans(start);
  ScaleLengths(LogScales(topology, TargetGradients(topology, frames), start), start);
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
