#include "LayerSteps.h"

#include "Error.h"
#include "LayerRows.h"

#include <algorithm>
#include <cmath>

namespace crossfield
{
namespace
{
/// Returns the name of the side of a loop.
std::string NameOfLoop(std::size_t loop)
{
  return loop == 0 ? "outer" : "hole" + std::to_string(loop - 1);
}

const LayerPrescription* FindLayer(const QuadRequest& request, const std::string& name)
{
  const auto found = std::find_if(request.layers.begin(), request.layers.end(),
    [&](const LayerPrescription& layer) { return layer.name == name; });
  return found == request.layers.end() ? nullptr : &*found;
}

double LengthOf(const Loop& loop)
{
  double length = 0.0;
  for (std::size_t i = 0; i < loop.size(); ++i)
  {
    length += (loop[(i + 1) % loop.size()] - loop[i]).norm();
  }
  return length;
}
}

std::vector<CornerChoice> CornersForLayers(const PlanarDomain& domain, const QuadRequest& request)
{
  std::vector<CornerChoice> corners = request.corners;
  const SidesAtCorner sidesAt = [](const Corner& corner)
  { return std::vector<std::string>{ NameOfLoop(static_cast<std::size_t>(corner.loop)) }; };
  const double reach = BoundaryReach * domain.Diagonal();
  const auto isChosen = [&](const Point& position)
  {
    return std::any_of(corners.begin(), corners.end(), [&](const CornerChoice& choice)
      { return (choice.position - position).norm() <= reach; });
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
  if (request.layers.empty())
  {
    return corners;
  }
  for (const Corner& corner : FindCorners(domain.loops))
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

ClearanceFactors ClearanceForLayers(
  const PlanarDomain& domain, const QuadRequest& request, double clearance, double quadSize)
{
  ClearanceFactors factors;
  for (std::size_t l = 0; l < domain.loops.size() && !request.layers.empty(); ++l)
  {
    const LayerPrescription* layer = FindLayer(request, NameOfLoop(l));
    const double room =
      layer == nullptr ? 0.0 : request.layerRoom * RowsToReplace(layer->growth) * quadSize;
    factors.emplace_back(domain.loops[l].size(), std::max(1.0, room / clearance));
  }
  return factors;
}

int CountBeforeLayers(const PlanarDomain& domain, const QuadRequest& request)
{
  // With h the size of quads, K rows of h along a side of length L become N rows: A/h² + Σ L (N −
  // K)/h quads. N depends on h by a logarithm only.
  double size = std::sqrt(domain.Area() / request.quadCount);
  for (int iteration = 0; iteration < 10; ++iteration)
  {
    double columns = 0.0;
    for (std::size_t loop = 0; loop < domain.loops.size(); ++loop)
    {
      if (const LayerPrescription* layer = FindLayer(request, NameOfLoop(loop)))
      {
        const int replaced = RowsToReplace(layer->growth);
        const int rows = layer->rows > 0
          ? layer->rows
          : RowsToFill(replaced * size, std::min(layer->first, size), layer->growth);
        columns += LengthOf(domain.loops[loop]) * std::max(0, rows - replaced);
      }
    }
    // A x² + columns x = count, x = 1/h.
    const double area = domain.Area();
    size = 2.0 * area /
      (std::sqrt(columns * columns + 4.0 * area * request.quadCount) - columns);
  }
  return std::max(1, static_cast<int>(std::lround(domain.Area() / (size * size))));
}

int CorrectCountBeforeLayers(int before, int total, int requested)
{
  // The layers add c √n to n quads.
  const double root = std::sqrt(static_cast<double>(before));
  const double c = (total - before) / root;
  const double corrected = 0.5 * (std::sqrt(c * c + 4.0 * requested) - c);
  return std::max(1, static_cast<int>(std::lround(corrected * corrected)));
}

std::vector<LayerReport> AddRequestedLayers(
  const QuadRequest& request, const BoundaryCurves& curves, QuadResult& quads)
{
  std::vector<int> layers;
  std::vector<int> names;
  for (const QuadBoundaryEdge& edge : quads.mesh.boundary)
  {
    const LayerPrescription* layer =
      FindLayer(request, NameOfLoop(static_cast<std::size_t>(edge.id)));
    layers.push_back(layer == nullptr ? -1 : static_cast<int>(layer - request.layers.data()));
    names.push_back(edge.id);
  }
  return AddLayers(quads, curves, request.layers, layers, names);
}
}
