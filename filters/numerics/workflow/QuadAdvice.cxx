#include "QuadAdvice.h"

#include "DomainQueries.h"
#include "MeshGrade.h"
#include "OptimizerReport.h"
#include "Outcome.h"
#include "SmoothBoundary.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <sstream>

namespace crossfield
{
namespace
{
bool IsInside(const PlanarDomain& domain, const Singularity& singularity)
{
  return SignedDistance(singularity.position, domain) > BoundaryReach * domain.Diagonal();
}

/// Returns "The singularity at (1, 2) of quarter index 3".
std::string Name(const Singularity& singularity)
{
  return "The singularity at " + Describe(singularity.position) + " of quarter index " +
    std::to_string(singularity.quarterIndex);
}

double AreaOf(const QuadMesh& mesh, const std::array<int, 4>& quad)
{
  const auto at = [&](std::size_t corner) { return mesh.points[quad[corner]].InPlane(); };
  return 0.5 * Cross(at(2) - at(0), at(3) - at(1));
}

std::string SplitAdvice(int count, int sign)
{
  return "; to have " + std::to_string(count) + " of index " + std::to_string(sign) +
    " instead, split it (SplitSingularities, --split).";
}
}

void RequireNodes(const PlanarDomain& domain, const Configuration& singularities)
{
  for (const Singularity& singularity : singularities)
  {
    if (singularity.quarterIndex > 2 && IsInside(domain, singularity))
    {
      throw Error(Name(singularity) + " would be a node with " +
        std::to_string(4 - singularity.quarterIndex) + " quads, which no mesh has" +
        SplitAdvice(singularity.quarterIndex, 1));
    }
  }
}

std::vector<std::string> DescribeFlatNodes(
  const PlanarDomain& domain, const Configuration& singularities)
{
  std::vector<std::string> sentences;
  for (const Singularity& singularity : singularities)
  {
    if (singularity.quarterIndex == 2 && IsInside(domain, singularity))
    {
      sentences.push_back(Name(singularity) +
        " is a node of valence 2, between two quads with angles of 180°" + SplitAdvice(2, 1));
    }
  }
  return sentences;
}

std::vector<std::string> DescribeCrowdedNodes(
  const PlanarDomain& domain, const Configuration& singularities)
{
  std::vector<std::string> sentences;
  for (const Singularity& singularity : singularities)
  {
    if (singularity.quarterIndex <= -2 && IsInside(domain, singularity))
    {
      sentences.push_back(Name(singularity) + " is a node of valence " +
        std::to_string(4 - singularity.quarterIndex) + SplitAdvice(-singularity.quarterIndex, -1));
    }
  }
  return sentences;
}

SizeTrials TrySmallerSizes(
  const QuadResult& quads, const std::function<QuadResult(double size)>& mesh)
{
  constexpr double MaximumQuads = 50000.0;  // about two seconds
  constexpr std::size_t MaximumArcs = 2000; // edge counts of more take a minute
  constexpr double Valid = 0.01;            // a smaller scaled Jacobian may be rounding
  SizeTrials trials;
  for (const double factor : { 2.0, 4.0 })
  {
    if (factor * factor * static_cast<double>(quads.mesh.quads.size()) > MaximumQuads ||
      quads.tMesh.arcs.size() > MaximumArcs)
    {
      break;
    }
    const double size = std::stod(FormatShort(quads.size / factor)); // as it is printed
    ++trials.tried;
    const Outcome<QuadResult> smaller = Try([&] { return mesh(size); });
    if (!smaller.value)
    {
      break;
    }
    if (smaller.value->quality.jacobian.min > Valid)
    {
      trials.valid = SmallerSize{ size, smaller.value->mesh.quads.size() };
      break;
    }
  }
  return trials;
}

double FindSmoothing(const PlanarDomain& domain, const std::vector<Point>& kept,
  const std::function<void(const PlanarDomain& domain)>& mesh)
{
  for (const double part : { 400.0, 200.0, 100.0, 50.0 })
  {
    const double length = std::stod(FormatShort(domain.Diagonal() / part)); // as it is printed
    const Outcome<bool> outcome = Try(
      [&]
      {
        mesh(SmoothBoundary(domain, length, kept).domain);
        return true;
      });
    if (outcome.value)
    {
      return length;
    }
  }
  return 0.0;
}

std::string CountInverted(const QuadQuality& quality)
{
  const bool one = quality.inverted == 1;
  return std::to_string(quality.inverted) +
    (one ? " quad is inverted near " : " quads are inverted, the worst near ") +
    DescribePlace(quality.where);
}

std::string DescribeInverted(
  const QuadQuality& quality, const SizeTrials& smaller, bool singularitiesAreGiven)
{
  std::ostringstream text;
  text << CountInverted(quality);
  if (smaller.valid)
  {
    text << "; use a smaller size"
         << (smaller.valid->keepsSingularities
                ? " and the same singularities (--save-singularities, then -s): with "
                : ": with ")
         << smaller.valid->size << ", " << smaller.valid->quads << " quads, none is inverted.";
  }
  else
  {
    text << (smaller.tried > 0 ? ", and smaller sizes do not help" : "")
         << (singularitiesAreGiven ? "; choose other positions for the singularities nearby."
                                   : ".");
  }
  return text.str();
}

std::string DescribeCount(const QuadRequest& request, bool isPrescribed, const QuadResult& quads)
{
  if (CountExcess(quads, request.quadSize, request.quadCount) <= 0.0)
  {
    return {};
  }
  return "No number of quads within 5 % of " + std::to_string(request.quadCount) +
    " was found for these separatrices" +
    (isPrescribed ? " and the prescribed numbers and sizes of edges; " : "; ") +
    std::to_string(quads.mesh.quads.size()) + " is the nearest; request another number" +
    (isPrescribed ? ", or prescribe others." : ".");
}

std::string DescribeLostSides(const QuadMesh& mesh)
{
  std::vector<int> edges(mesh.sideNames.size(), 0);
  for (const QuadBoundaryEdge& edge : mesh.boundary)
  {
    if (edge.side >= 0)
    {
      ++edges[static_cast<std::size_t>(edge.side)];
    }
  }
  const auto lost = std::count(edges.begin(), edges.end(), 0);
  if (lost == 0)
  {
    return {};
  }
  const auto first = std::find(edges.begin(), edges.end(), 0) - edges.begin();
  const std::string& name = mesh.sideNames[static_cast<std::size_t>(first)];
  return std::to_string(lost) + " of " + std::to_string(edges.size()) + " sides, such as '" + name +
    "', have no edge, and edges beside them cut across; prescribe a number of edges for them (--count " +
    name +
    ":1, Count of a side), or smaller quads if these are larger than the sides"
    " (QuadSize, --size).";
}

std::string DescribeSizes(const ResolvedRequest& request, const QuadResult& quads)
{
  const QuadMesh& mesh = quads.mesh;
  // Two thirds of the sizes are then within a factor of e of their mean.
  constexpr double LargestDeviation = 1.0;
  const bool isPrescribed = request.sizing == Sizing::Field || !request.layers.empty() ||
    std::any_of(request.prescribed.begin(), request.prescribed.end(),
      [](const SidePrescription& one) { return one.isGraded || one.size > 0.0; });
  if (isPrescribed)
  {
    return "";
  }
  double count = 0.0;
  double sum = 0.0;
  double squares = 0.0;
  double smallest = std::numeric_limits<double>::infinity();
  double largest = 0.0;
  for (std::size_t q = 0; q < mesh.quads.size(); ++q)
  {
    const double area = AreaOf(mesh, mesh.quads[q]);
    if (area > 0.0)
    {
      const double size = std::sqrt(area);
      count += 1.0;
      sum += std::log(size);
      squares += std::log(size) * std::log(size);
      smallest = std::min(smallest, size);
      largest = std::max(largest, size);
    }
  }
  const double mean = sum / count;
  const double deviation = std::sqrt(std::max(0.0, squares / count - mean * mean));
  if (!(std::max(deviation, quads.quality.variation) > LargestDeviation))
  {
    return "";
  }
  std::ostringstream text;
  text.precision(2);
  text << "Sizes of quads differ from " << smallest << " to " << largest
       << ", with a standard deviation of their logarithm of " << deviation << "; ";
  if (request.sizing != Sizing::Uniform)
  {
    text << "uniform sizes (Sizing, --sizing uniform) may differ less, at the cost of shapes.";
  }
  else if (request.hold)
  {
    text << "they may differ less if singularities are not held (HoldSingularities, --hold).";
  }
  else
  {
    text << (request.singularities
        ? "with others, which are chosen without any (--singularities), they may differ less."
        : "pairs of singularities (Pairs, --pairs) may make them more equal.");
  }
  return text.str();
}

std::string DescribeArea(const QuadResult& quads)
{
  if (AreaError(quads) <= AcceptableAreaError)
  {
    return "";
  }
  // Where an edge is long, it cuts off most.
  double longest = 0.0;
  Point place = Point::Zero();
  for (const QuadBoundaryEdge& edge : quads.mesh.boundary)
  {
    const Point from = quads.mesh.points[edge.points[0]].InPlane();
    const Point to = quads.mesh.points[edge.points[1]].InPlane();
    if ((to - from).norm() > longest)
    {
      longest = (to - from).norm();
      place = 0.5 * (from + to);
    }
  }
  std::ostringstream text;
  text.precision(2);
  text << "The area of the quads differs by " << 100.0 * AreaError(quads)
       << " % from that of the domain, because edges on curved sides are long, up to " << longest
       << " near " << Describe(place) << "; use smaller quads (QuadSize, --size).";
  return text.str();
}

std::string DescribeRegionAreas(const QuadMesh& mesh, const std::vector<int>& region,
  const std::vector<double>& areas, const std::vector<std::string>& names)
{
  constexpr double Octagon = 0.1; // 1 − 2√2/π
  std::vector<double> covered(areas.size(), 0.0);
  std::vector<std::size_t> quads(areas.size(), 0);
  for (std::size_t q = 0; q < mesh.quads.size(); ++q)
  {
    covered[static_cast<std::size_t>(region[q])] += AreaOf(mesh, mesh.quads[q]);
    quads[static_cast<std::size_t>(region[q])] = q;
  }
  std::size_t worst = 0;
  const auto error = [&](std::size_t r) { return std::abs(covered[r] / areas[r] - 1.0); };
  for (std::size_t r = 1; r < areas.size(); ++r)
  {
    worst = error(r) > error(worst) ? r : worst;
  }
  if (error(worst) <= Octagon)
  {
    return "";
  }
  std::ostringstream text;
  text.precision(2);
  text << "The quads of material '" << names[worst] << "' near "
       << Describe(mesh.points[mesh.quads[quads[worst]][0]].InPlane()) << " have "
       << std::lround(100.0 * covered[worst] / areas[worst])
       << " % of the area of the region, because edges on curved sides are long; use smaller quads "
          "(QuadSize, --size), or smaller ones in this material (--size-in).";
  return text.str();
}

std::string RepairAdvice(const HolonomyRepair& repair)
{
  std::ostringstream text;
  text.precision(3);
  text << "the repair of the holonomy (RepairHolonomy, --repair-holonomy) avoids this and moves "
          "singularities by up to "
       << repair.largestMove;
  return text.str();
}

Error WithSmoothing(const Error& error, double length, bool singularitiesAreGiven)
{
  if (length > 0.0)
  {
    std::ostringstream text;
    text << "smooth the boundary with a length of " << length
         << " (SmoothingLength of Boundary Simplifier, --smooth-boundary)";
    return { error.GetCause(), text.str(), Error::Kind::BadInput };
  }
  return { error.GetCause() + " on a finer mesh as well",
    singularitiesAreGiven ? "move singularities away from each other and from the boundary"
                          : "give other singularities",
    Error::Kind::BadInput };
}
}
