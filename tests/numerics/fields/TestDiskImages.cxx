#include "BoundarySingularities.h"
#include "ConfigurationPlacement.h"
#include "ExactFields.h"
#include "HField.h"
#include "MakePlanarDomain.h"
#include "Support.h"

#include <algorithm>
#include <cmath>

namespace crossfield::test
{
namespace
{
/// Returns singularities of the disk, inside and on the circle, with quarter indices from −2 to 4.
std::vector<Configuration> Preimages()
{
  return { { { { 0.31, 0.42 }, 4, 0.0 }, { { -0.52, 0.18 }, -2, 0.0 }, { { -0.11, -0.61 }, 1, 0.0 },
             { { 0.47, -0.33 }, 1, 0.0 } },
    { { { 0.1, -0.2 }, 3, 0.0 }, { { -0.4, 0.3 }, -1, 0.0 }, OnTheCircle(0.8, 1),
      OnTheCircle(2.9, -1), OnTheCircle(4.6, 2) },
    { { { 0.2, 0.3 }, 2, 0.0 }, OnTheCircle(1.2, 4), OnTheCircle(5.0, -2) },
    { OnTheCircle(0.5, 1), OnTheCircle(2.0, 1), OnTheCircle(3.3, 3), { { -0.1, 0.4 }, -1, 0.0 } } };
}

const std::vector<DiskImage> Images = { { { 0.2, 0.1 }, 2 }, { { -0.1, 0.12 }, 3 } };

/// Returns the singularities as a user of the polygon places them: those on the circle at a vertex,
/// or at a fraction of a side.
Configuration Given(const DiskImage& image, const Configuration& preimages, int count, double part,
  Configuration& moved)
{
  Configuration given = image(preimages);
  moved = preimages;
  for (std::size_t i = 0; i < preimages.size(); ++i)
  {
    if (IsOnCircle(preimages[i]))
    {
      const double step = 2.0 * Pi / count;
      const Point& place = preimages[i].position;
      const double first = step * std::floor(std::atan2(place.y(), place.x()) / step);
      moved[i].position = OnTheCircle(first + part * step, 0).position;
      given[i].position =
        (1.0 - part) * image(std::polar(1.0, first)) + part * image(std::polar(1.0, first + step));
    }
  }
  return given;
}

/// The first two are root mean squares; the maxima contain an additional logarithm of the mesh
/// size.
struct Errors
{
  double h = 0.0;
  double cross = 0.0;
  double energy = 0.0;
};

Errors ErrorsOf(const DiskImage& image, const Configuration& preimages, int sides, double part)
{
  Configuration exact;
  const Configuration given = Given(image, preimages, sides, part, exact);
  DrillOptions options;
  options.meshSize = 2.0 * Pi / sides;
  const PlanarDomain domain = { { image.Polygon(sides) } };
  const TriangleMesh mesh = DrillHoles(InsertBoundarySingularities(domain, given), {}, options);
  const HField field = SolveHField(ShareTopology(mesh), given);
  const Configuration places = image(exact);
  const auto away = [&](const Point& point, double distance)
  {
    return std::all_of(places.begin(), places.end(),
      [&](const Singularity& s) { return (s.position - point).norm() > distance; });
  };
  // The point on the curve that corresponds to a point on a side is exact to second order only, and
  // log r within h of it to first order.
  const auto offCircle = [&](const Point& point)
  {
    for (std::size_t i = 0; i < places.size(); ++i)
    {
      if (IsOnCircle(exact[i]) && (places[i].position - point).norm() < 0.1)
      {
        return false;
      }
    }
    return true;
  };
  Errors errors;
  errors.energy = std::abs(field.renormalizedEnergy - image.Energy(exact));
  std::vector<double> off;
  for (std::size_t v = 0; v < mesh.points.size(); ++v)
  {
    if (offCircle(mesh.points[v]))
    {
      off.push_back(
        field.h[static_cast<Eigen::Index>(v)] - 0.25 * image.PhiAt(exact, mesh.points[v]));
    }
  }
  const Eigen::Map<Eigen::ArrayXd> all(off.data(), static_cast<Eigen::Index>(off.size()));
  errors.h = std::sqrt((all - all.mean()).square().mean());
  const EdgeNumbering& edges = field.field.topology->edges;
  int count = 0;
  for (int e = 0; e < edges.Count(); ++e)
  {
    const Point middle = Midpoint(mesh, edges, e);
    if (edges.triangles[static_cast<std::size_t>(e)][1] >= 0 && away(middle, 0.1))
    {
      ++count;
      errors.cross += std::norm(field.field.u[e] - image.CrossAt(exact, middle));
    }
  }
  errors.cross = std::sqrt(errors.cross / count);
  return errors;
}

TEST(DiskImages, HThetaAndWConvergeAtSecondOrder)
{
  double coarse = 0.0;
  double fine = 0.0;
  for (const DiskImage& image : Images)
  {
    for (const Configuration& preimages : Preimages())
    {
      for (const double part : { 0.0, 0.3 })
      {
        const bool onlyInside = std::none_of(preimages.begin(), preimages.end(), IsOnCircle);
        if (onlyInside && part > 0.0)
        {
          continue;
        }
        SCOPED_TRACE("z + a z^" + std::to_string(image.n) + ", " + std::to_string(part) +
          " along a side, " + std::to_string(preimages.size()));
        double squares = 0.0;
        for (const Singularity& singularity : preimages)
        {
          squares += singularity.quarterIndex * singularity.quarterIndex;
        }
        std::vector<double> sizes;
        std::vector<Errors> errors;
        for (const int count : { 80, 160, 320 })
        {
          sizes.push_back(2.0 * Pi / count);
          errors.push_back(ErrorsOf(image, preimages, count, part));
          // Its sign may change from mesh to mesh, so each value has a second-order bound, and the
          // rate is measured over all of them below.
          EXPECT_LT(errors.back().energy, 4.0 * squares * sizes.back() * sizes.back());
        }
        const auto rate = [&](double Errors::*what)
        {
          std::vector<double> values;
          for (const Errors& here : errors)
          {
            values.push_back(here.*what);
          }
          return ConvergenceRate(sizes, values);
        };
        EXPECT_GE(rate(&Errors::h), 1.8);
        EXPECT_GE(rate(&Errors::cross), 1.8);
        EXPECT_LT(errors.back().h, 2e-4);
        EXPECT_LT(errors.back().cross, 6e-4);
        coarse += errors.front().energy;
        fine += errors.back().energy;
      }
    }
  }
  EXPECT_GE(0.5 * std::log2(coarse / fine), 1.8); // of all W
}
}
}
