#include "SizeSearch.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace crossfield
{
namespace
{
constexpr int MostSizes = 20;
/// Good enough at once; the tolerance is after a few sizes.
constexpr double Fine = 0.01;
constexpr int FewSizes = 6;
}

long long CountQuads(const TMesh& mesh, const std::vector<int>& counts)
{
  long long quads = 0;
  for (const TPatch& face : mesh.patches)
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

SizedCounts SearchSize(const TMesh& mesh, int wanted, double first,
  const std::function<ArcCounts(double)>& countsOf, const Progress& progress)
{
  SizedCounts best;
  double least = -1.0;
  double tooMany = 0.0; // sizes; 0: none yet
  double tooFew = 0.0;
  double size = first;
  for (int tried = 0; tried < MostSizes; ++tried)
  {
    progress.Report(static_cast<double>(tried) / MostSizes);
    ArcCounts counts = countsOf(size);
    const long long quads = CountQuads(mesh, counts.counts);
    const double ratio = static_cast<double>(quads) / wanted;
    const double error = std::abs(ratio - 1.0);
    (ratio > 1.0 ? tooMany : tooFew) = size;
    if (least < 0.0 || error < least)
    {
      least = error;
      best = { size, std::move(counts), quads };
    }
    if (least <= Fine || (least <= CountTolerance && tried + 1 >= FewSizes))
    {
      break;
    }
    if (tooMany > 0.0 && tooFew > 0.0 && tried > 1)
    {
      // Nearer than that, the counts are those of the ends.
      if (std::abs(tooFew - tooMany) < 1e-4 * tooMany)
      {
        break;
      }
      size = std::sqrt(tooMany * tooFew);
    }
    else
    {
      // At least 2 % on, so that a count that does not change is left.
      const double factor = std::sqrt(std::max(ratio, 0.01));
      size *= ratio > 1.0 ? std::max(factor, 1.02) : std::min(factor, 0.98);
    }
  }
  return best;
}
}
