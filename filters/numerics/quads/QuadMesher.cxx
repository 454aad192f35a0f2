#include "QuadMesher.h"

#include "Error.h"
#include "QuadLayout.h"
#include "Stopwatch.h"
#include "TMeshFaces.h"

#include <cmath>

namespace crossfield
{
namespace
{
long long CountQuads(const TMesh& lines, const std::vector<int>& counts)
{
  long long quads = 0;
  for (const TFace& face : lines.faces)
  {
    long long sides[2] = { 0, 0 };
    for (const std::size_t side : { std::size_t(0), std::size_t(1) })
    {
      for (const int half : face.sides[side])
      {
        sides[side] += counts[static_cast<std::size_t>(half / 2)];
      }
    }
    quads += sides[0] * sides[1];
  }
  return quads;
}

/// The size whose number of quads is nearest to the wanted one, of a few that follow each other's misfit.
void ChooseSize(const TMesh& lines, int wanted, QuadResult& result, const Progress& progress)
{
  double area = 0.0;
  for (const TFace& face : lines.faces)
  {
    area += lines.SideLength(face, 0) * lines.SideLength(face, 1);
  }
  double size = std::sqrt(area / wanted);
  double least = -1.0;
  // Rounding shrinks with the size; a count within 1 % is as good as one can ask for.
  for (int attempt = 0; attempt < 6 && (least < 0.0 || least > 0.01); ++attempt)
  {
    progress.Report(attempt / 6.0);
    ArcCounts counts = CountArcs(lines, size);
    const auto quads = static_cast<double>(CountQuads(lines, counts.counts));
    const double misfit = std::abs(quads / wanted - 1.0);
    const double tried = size;
    size *= std::sqrt(quads / wanted);
    if (least < 0.0 || misfit < least)
    {
      least = misfit;
      result.counts = std::move(counts);
      result.size = tried;
    }
  }
}
}

QuadResult MakeQuads(const FlatMap& map, const QuadOptions& options, const Progress& progress)
{
  if (!(options.size >= 0.0) || !std::isfinite(options.size) ||
    (options.size == 0.0 && options.count < 1))
  {
    throw Error("The size of quads must be a positive number, or their count at least 1.");
  }
  Stopwatch stopwatch;
  QuadResult result;
  result.lines = MakeTMesh(map, TraceLines(map, progress.Part(0.0, 0.2)));
  result.traceSeconds = stopwatch.Lap();
  if (options.size > 0.0)
  {
    result.size = options.size;
    result.counts = CountArcs(result.lines, options.size, progress.Part(0.2, 0.4));
  }
  else
  {
    ChooseSize(result.lines, options.count, result, progress.Part(0.2, 0.4));
  }
  stopwatch.Lap();
  result.mesh = LayQuads(map, result.lines, result.counts.counts, result.size);
  result.layoutSeconds = stopwatch.Lap();
  progress.Report(0.5);
  result.smoothing =
    SmoothQuads(result.mesh, BoundaryCurves(*map.topology), progress.Part(0.5, 0.95));
  result.smoothSeconds = stopwatch.Lap();
  result.quality = MeasureQuads(result.mesh, result.size);
  result.blocks = FindBlocks(result.mesh);
  progress.Report(1.0);
  return result;
}
}
