#include "LayoutSnap.h"

#include "LayoutClosing.h"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <utility>

namespace crossfield
{
namespace
{
double LongestOf(const std::vector<int>& arcs, const TMesh& tMesh)
{
  double longest = 0.0;
  for (const int arc : arcs)
  {
    longest = std::max(longest, tMesh.arcs[arc].length);
  }
  return longest;
}

/// Leaves out the longest of the arcs, and returns the others.
std::vector<int> LeaveOutLongest(
  const std::vector<int>& arcs, const TMesh& tMesh, double smallestSize, ClosingOptions& options)
{
  // An arc has edges if it is longer than half a quad, unless other arcs forbid it.
  options.size = std::min(options.size, 2.0 * LongestOf(arcs, tMesh));
  std::vector<int> others = arcs;
  while (others.size() >= arcs.size())
  {
    if (options.size < smallestSize)
    {
      return {};
    }
    options.size *= 0.95;
    others = FindArcsToClose(tMesh, options);
  }
  return others;
}

/// `isMissing`: whether separatrices remain that nearly meet.
std::string Describe(
  const Layout& start, const ClosingResult& closed, bool isMissing, double tolerance)
{
  std::ostringstream text;
  text.precision(3);
  const std::size_t before = start.tMesh.patches.size();
  const std::size_t after = closed.layout.tMesh.patches.size();
  if (closed.maps > 0)
  {
    text << "Nearly coincident separatrices were joined: " << after << " patches instead of "
         << before << ". The maximum displacement of a singularity is "
         << LargestMove(start.singularities, closed.layout.singularities) << ".";
  }
  else
  {
    text << "No separatrices were joined.";
  }
  if (isMissing)
  {
    text
      << " Others still nearly coincide: joining them is impossible or moves a singularity by more "
         "than "
      << tolerance << ".";
  }
  return text.str();
}
}

LayoutSnap SnapLayout(const FactoredDomain& domain, const Configuration& singularities,
  const SeamlessMapOptions& options, double tolerance, const Progress& progress)
{
  constexpr int MaximumAttempts = 12;
  ClosingOptions closing;
  closing.map = options;
  closing.mesh = [&domain](const Configuration& moved, const Progress&)
  { return domain.MeshOn(moved); };
  closing.coarseness = 1.0;
  // Arcs shorter than half of the size have no edges. The lower bound limits the edges of others.
  const double smallestSize = 1e-5 * std::sqrt(domain.GetDomain().Area());
  closing.size = std::max(2.0 * tolerance, smallestSize);
  closing.exact = true;
  closing.maximumMaps = 120;
  closing.maximumMove = tolerance;
  const Layout start =
    LayOut(ShareTopology(domain.MeshOn(singularities)), singularities, options, true);
  ClosingResult closed;
  closed.layout = start;
  const double size = closing.size;
  std::vector<int> arcs = FindArcsToClose(start.tMesh, closing);
  for (int i = 0; i < MaximumAttempts && !arcs.empty(); ++i)
  {
    ClosingResult attempt = CloseLayout(domain.GetDomain(), start, closing,
      progress.Part(static_cast<double>(i) / MaximumAttempts, (i + 1.0) / MaximumAttempts));
    if (attempt.converged)
    {
      closed = std::move(attempt);
      break;
    }
    arcs = LeaveOutLongest(arcs, start.tMesh, smallestSize, closing);
  }
  closing.size = size;
  LayoutSnap result;
  result.singularities = closed.layout.singularities;
  result.largestMove = LargestMove(singularities, result.singularities);
  result.event =
    Describe(start, closed, !FindArcsToClose(closed.layout.tMesh, closing).empty(), tolerance);
  progress.Report(1.0);
  return result;
}
}
