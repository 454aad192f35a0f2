#include "LayerSteps.h"

#include "LayerRows.h"
#include "Outcome.h"
#include "QuadSides.h"
#include "SizeSearch.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>

namespace crossfield
{
namespace
{
/// The names of the sides along the loops of a domain.
class NamesAlong
{
public:
  NamesAlong(const PlanarDomain& domain, const ResolvedRequest& request)
    : Sides(request.sides)
    , Arcs(domain.loops.begin(), domain.loops.end())
    , Along(this->Sides, this->Arcs)
  {
  }

  /// Returns the name of a segment of a loop.
  const std::string& At(std::size_t loop, std::size_t segment) const
  {
    const LoopArc& arc = this->Arcs[loop];
    const double middle = 0.5 * (arc.Start(segment) + arc.Start(segment + 1));
    return this->Sides.names[this->Along.At(loop, middle)];
  }

  double LengthOf(std::size_t loop, std::size_t segment) const
  {
    return this->Arcs[loop].Start(segment + 1) - this->Arcs[loop].Start(segment);
  }

private:
  BoundarySides Sides;
  std::vector<LoopArc> Arcs;
  SidesAlong Along;
};

const LayerPrescription* FindLayer(const ResolvedRequest& request, const std::string& name)
{
  const auto found = std::find_if(request.layers.begin(), request.layers.end(),
    [&](const LayerPrescription& layer) { return layer.name == name; });
  return found == request.layers.end() ? nullptr : &*found;
}

/// Corrects the number of quads before layers are added, with which there were `after` quads
/// instead of `total`.
int CorrectCount(int before, int after, int total)
{
  // The layers add c √n to n quads.
  const double root = std::sqrt(static_cast<double>(before));
  const double c = (after - before) / root;
  const double corrected = 0.5 * (std::sqrt(c * c + 4.0 * total) - c);
  return std::max(1, static_cast<int>(std::lround(corrected * corrected)));
}

/// Numbers of edges of sides, which increase where layers end on the sides.
class CountsWithLayers
{
public:
  CountsWithLayers(const ResolvedRequest& request)
    : Request(request)
  {
  }

  /// Compares the numbers of edges with the requested ones. Where they differ, corrects the numbers
  /// that are prescribed before layers are added, with which there were `before`.
  void Compare(
    const std::vector<SideMeasure>& before, const QuadMesh& mesh, SidePrescriptions& corrected)
  {
    const std::vector<SideMeasure> after = MeasureSides(mesh);
    this->Difference.clear();
    for (std::size_t i = 0; i < this->Request.prescribed.size(); ++i)
    {
      const SidePrescription& one = this->Request.prescribed[i];
      const auto side = static_cast<std::size_t>(one.side);
      if (one.count == 0 || after[side].edges == one.count)
      {
        continue;
      }
      this->Difference = this->Describe(mesh.sideNames[side], after[side].edges, one.count);
      corrected[i].count = one.count - (after[side].edges - before[side].edges);
      if (corrected[i].count <= 0)
      {
        throw Error(this->Difference);
      }
    }
  }

  bool AreRight() const { return this->Difference.empty(); }
  /// Throws Error if the numbers of edges differ from the requested ones.
  void Require() const
  {
    if (!this->AreRight())
    {
      throw Error(this->Difference);
    }
  }

private:
  std::string Describe(const std::string& side, int edges, int prescribed) const
  {
    const bool isOne = this->Request.layers.size() == 1;
    return (isOne ? "With the layer of '" + this->Request.layers[0].name + "'"
                  : std::string("With the layers")) +
      ", side '" + side + "' has " + std::to_string(edges) + " edges, but " +
      std::to_string(prescribed) + " are prescribed; leave out this number or the layer" +
      (isOne ? "." : " that ends on the side.");
  }

  const ResolvedRequest& Request;
  std::string Difference; ///< A sentence, empty if there is none.
};
}

namespace
{
/// Returns the ends of periodic sides and their images, if singularities are chosen: given ones
/// suit the corners as they are.
std::vector<std::array<Point, 2>> EndsOfPeriodicSides(
  const PlanarDomain& domain, const ResolvedRequest& request)
{
  std::vector<std::array<Point, 2>> ends;
  if (request.singularities)
  {
    return ends;
  }
  const std::vector<LoopArc> loops(domain.loops.begin(), domain.loops.end());
  for (const PairedSides& pair : request.periodic)
  {
    const SideSpan first = FindSpan(request.sides, loops, pair.first);
    const SideSpan second = FindSpan(request.sides, loops, pair.second);
    const auto at = [&loops](const SideSpan& span, double length)
    { return loops[span.loop].At(span.start + length); };
    ends.push_back({ at(first, 0.0), at(second, second.length) });
    ends.push_back({ at(first, first.length), at(second, 0.0) });
  }
  return ends;
}
}

std::vector<CornerChoice> CompleteCorners(
  const PlanarDomain& domain, const ResolvedRequest& request)
{
  std::vector<CornerChoice> corners = request.corners;
  if (request.layers.empty() && request.cornerRows.empty() && request.periodic.empty())
  {
    return corners;
  }
  const NamesAlong names(domain, request);
  const SidesAtCorner sidesAt = [&](const Corner& corner)
  {
    const auto loop = static_cast<std::size_t>(corner.loop);
    const auto vertex = static_cast<std::size_t>(corner.vertex);
    const std::size_t count = domain.loops[loop].size();
    return std::vector<std::string>{ names.At(loop, (vertex + count - 1) % count),
      names.At(loop, vertex) };
  };
  const double reach = BoundaryReach * domain.Diagonal();
  const auto isChosen = [&](const Point& position)
  {
    return std::any_of(corners.begin(), corners.end(),
      [&](const CornerChoice& choice) { return (choice.position - position).norm() <= reach; });
  };
  for (const CornerChoice& choice : TreatCorners(domain, request.cornerRows, sidesAt))
  {
    if (isChosen(choice.position))
    {
      throw Error("The corner at " + Describe(choice.position) +
        " has both a quarter index and a treatment of rows; give one of them.");
    }
    corners.push_back(choice);
  }
  const std::vector<Corner> found = FindCorners(domain.loops);
  for (const std::array<Point, 2>& ends : EndsOfPeriodicSides(domain, request))
  {
    std::vector<const Corner*> both;
    for (const Point& end : ends)
    {
      for (const Corner& corner : found)
      {
        if ((corner.position - end).norm() <= reach && !isChosen(end))
        {
          both.push_back(&corner);
        }
      }
    }
    // Of the neighbours in space, one has the angle of one end and the other that of its image.
    if (both.size() == 2 && both[0] != both[1] &&
      std::lround((both[0]->angle + both[1]->angle) / (0.5 * Pi)) == 2)
    {
      corners.push_back({ both[0]->position, 1 });
      corners.push_back({ both[1]->position, 1 });
    }
  }
  for (const Corner& corner : found)
  {
    const std::vector<std::string> sides = sidesAt(corner);
    if (!isChosen(corner.position) &&
      std::any_of(sides.begin(), sides.end(),
        [&](const std::string& side) { return FindLayer(request, side) != nullptr; }))
    {
      corners.push_back({ corner.position, QuarterIndexFor(corner, DefaultRows(corner.angle)) });
    }
  }
  return corners;
}

ClearanceFactors ClearanceForLayers(const PlanarDomain& domain, const ResolvedRequest& request,
  double clearance, const SizeFunction& quadSize)
{
  if (request.layers.empty())
  {
    return {};
  }
  const NamesAlong names(domain, request);
  ClearanceFactors factors;
  for (std::size_t l = 0; l < domain.loops.size(); ++l)
  {
    factors.emplace_back();
    const Loop& loop = domain.loops[l];
    for (std::size_t segment = 0; segment < loop.size(); ++segment)
    {
      double distance = 0.0;
      if (const LayerPrescription* layer = FindLayer(request, names.At(l, segment)))
      {
        const Point middle = 0.5 * (loop[segment] + loop[(segment + 1) % loop.size()]);
        distance = request.layerDistance * RowsBeside(*layer) * quadSize(middle);
      }
      factors.back().push_back(std::max(1.0, distance / clearance));
    }
  }
  return factors;
}

int CountBeforeLayers(const PlanarDomain& domain, const ResolvedRequest& request)
{
  std::vector<double> lengths(request.layers.size(), 0.0);
  const NamesAlong names(domain, request);
  for (std::size_t l = 0; l < domain.loops.size(); ++l)
  {
    for (std::size_t segment = 0; segment < domain.loops[l].size(); ++segment)
    {
      if (const LayerPrescription* layer = FindLayer(request, names.At(l, segment)))
      {
        lengths[layer - request.layers.data()] += names.LengthOf(l, segment);
      }
    }
  }
  // With h the size of quads, K rows of h along a side of length L become N rows: A/h² + Σ L (N −
  // K)/h quads. N depends on h by a logarithm only.
  double size = std::sqrt(domain.Area() / request.quadCount);
  for (int iteration = 0; iteration < 10; ++iteration)
  {
    double columns = 0.0;
    for (std::size_t i = 0; i < request.layers.size(); ++i)
    {
      const LayerPrescription& layer = request.layers[i];
      if (!layer.first)
      {
        continue;
      }
      const int replaced = RowsToReplace(layer.growth);
      const int rows = layer.rows > 0
        ? layer.rows
        : RowsToFill(replaced * size, std::min(*layer.first, size), layer.growth);
      columns += lengths[i] * std::max(0, rows - replaced);
    }
    // A x² + columns x = count, x = 1/h.
    const double area = domain.Area();
    size = 2.0 * area / (std::sqrt(columns * columns + 4.0 * area * request.quadCount) - columns);
  }
  return std::max(1, static_cast<int>(std::lround(domain.Area() / (size * size))));
}

std::vector<LayerReport> AddLayersForCount(const PlanarDomain& domain,
  const ResolvedRequest& request, int total, const LayoutSet& layouts, QuadOptions options,
  QuadResult& quads)
{
  // Corrections of numbers of quads and of edges converge in two or three tries; rounding may take
  // some more.
  constexpr int MaximumTries = 8;
  const BoundaryCurves curves(
    RequirePlanar(layouts.Single().map.topology)->AlignedLoops(), options.curves);
  const int separateBlocks = quads.separateBlocks;
  CountsWithLayers sideCounts(request);
  std::optional<QuadResult> best;
  int bestCount = options.quadCount;
  std::vector<LayerReport> reports;
  double smallest = 0.0;
  for (int tries = 1;; ++tries)
  {
    const auto before = static_cast<int>(quads.mesh.quads.size());
    const std::vector<SideMeasure> sides = MeasureSides(quads.mesh);
    Outcome<std::vector<LayerReport>> layers =
      Try([&] { return AddLayers(domain, curves, request.layers, request.takesFewRows, quads); });
    if (layers.value)
    {
      sideCounts.Compare(sides, quads.mesh, options.prescribed);
      const auto after = static_cast<int>(quads.mesh.quads.size());
      const double error =
        options.quadSize > 0.0 ? 0.0 : std::abs(static_cast<double>(after) / total - 1.0);
      if (sideCounts.AreRight() && (!best || error < smallest))
      {
        best = std::move(quads);
        bestCount = options.quadCount;
        smallest = error;
        reports = std::move(*layers.value);
      }
      options.quadCount = CorrectCount(before, after, total);
    }
    else if (!best)
    {
      if (layers.error->GetKind() == Error::Kind::LackOfRows)
      {
        sideCounts.Require();
      }
      throw Error(*layers.error);
    }
    else
    {
      // Larger quads leave too little room; halfway to those that did not.
      options.quadCount = (options.quadCount + bestCount) / 2;
    }
    if ((best && smallest <= CountTolerance) || tries == MaximumTries)
    {
      break;
    }
    Outcome<QuadResult> next = Try([&] { return MakeQuads(layouts, options); });
    if (!next.value)
    {
      // The corrected numbers of edges contradict each other.
      sideCounts.Require();
      throw Error(*next.error);
    }
    quads = std::move(*next.value);
  }
  if (!best)
  {
    sideCounts.Require();
  }
  quads = std::move(*best);
  quads.separateBlocks = separateBlocks;
  return reports;
}
}
