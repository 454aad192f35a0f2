// Singularities for target sizes: the form against fields and known spreads, and the search on
// parts with known answers.

#include "SizedConfigurations.h"

#include "AutomaticConfiguration.h"
#include "MakePlanarDomain.h"
#include "P1Interpolation.h"
#include "PoincareHopf.h"
#include "SizeForm.h"
#include "Support.h"

#include <cmath>
#include <set>

namespace crossfield::test
{
namespace
{
/// A part, its target sizes, and singularities with a spread that another program found.
struct Example
{
  PlanarDomain domain;
  SizeFunction size;
  Configuration known;
  double spread = 0.0;
};

double Grown(double from, double distance, double growth, double largest)
{
  return std::min(largest, from + std::log(growth) * std::max(0.0, distance));
}

/// A plate of 4 × 2 with a hole of radius 0.05 at the origin.
Example PlateWithSmallHole()
{
  return { MakePlanarDomain({ { { -2.0, -1.0 }, { 2.0, -1.0 }, { 2.0, 1.0 }, { -2.0, 1.0 } },
             RegularPolygon(128, 0.05) }),
    [](const Point& place) { return Grown(0.01, place.norm() - 0.05, 1.2, 0.2); },
    { { { 0.747, -0.685 }, -1, 0.0 }, { { -0.663, 0.691 }, -1, 0.0 },
      { { -0.728, -0.659 }, -1, 0.0 }, { { 0.667, 0.688 }, -1, 0.0 } },
    0.079 };
}

/// The unit disk with small quads in its middle.
Example DiskFineInside()
{
  return { MakePlanarDomain({ RegularPolygon(96) }),
    [](const Point& place) { return Grown(0.03, place.norm() - 0.3, 1.25, 0.2); },
    { { { 0.227, 0.0 }, 1, 0.0 }, { { -0.227, 0.0 }, 1, 0.0 }, { { 0.096, 0.273 }, 1, 0.0 },
      { { -0.096, 0.273 }, 1, 0.0 }, { { 0.096, -0.273 }, 1, 0.0 }, { { -0.096, -0.273 }, 1, 0.0 },
      { { 0.0, 0.571 }, -1, 0.0 }, { { 0.0, -0.571 }, -1, 0.0 } },
    0.126 };
}

/// Half of a bar whose height falls from 2 to 1 with a fillet of radius 0.1.
Example BarWithFillet()
{
  Loop loop = { { 0.0, 0.0 }, { 6.0, 0.0 }, { 6.0, 1.0 } };
  constexpr int Steps = 16;
  for (int i = 0; i <= Steps; ++i)
  {
    const double angle = -0.5 * Pi - 0.5 * Pi * i / Steps;
    loop.push_back(Point(3.1, 1.1) + 0.1 * Point(std::cos(angle), std::sin(angle)));
  }
  loop.push_back({ 3.0, 2.0 });
  loop.push_back({ 0.0, 2.0 });
  return { MakePlanarDomain({ loop }),
    [](const Point& place)
    {
      const Point offset = place - Point(3.1, 1.1);
      const bool isBeside = offset.x() < 0.0 && offset.y() < 0.0;
      const double distance = isBeside
        ? std::abs(offset.norm() - 0.1)
        : std::min((place - Point(3.0, 1.1)).norm(), (place - Point(3.1, 1.0)).norm());
      return Grown(0.03, distance, 1.25, 0.25);
    },
    { { { 3.704, 0.465 }, -1, 0.0 }, { { 2.222, 1.568 }, -1, 0.0 }, { { 2.629, 0.369 }, -1, 0.0 },
      { { 3.250, 0.799 }, 1, 0.0 }, { { 2.865, 1.098 }, 1, 0.0 } },
    0.081 };
}

SizeSearchOptions OptionsFor(const SizeFunction& size)
{
  SizeSearchOptions options;
  options.size = size;
  return options;
}

/// Returns the positions and the indices of a configuration.
std::pair<std::vector<Point>, Eigen::VectorXi> SitesOf(const Configuration& configuration)
{
  std::vector<Point> places;
  Eigen::VectorXi indices(static_cast<Eigen::Index>(configuration.size()));
  for (const Singularity& one : configuration)
  {
    indices[static_cast<Eigen::Index>(places.size())] = one.quarterIndex;
    places.push_back(one.position);
  }
  return { places, indices };
}

double SpreadOf(const SizeForm& form, const Configuration& configuration)
{
  const auto [places, indices] = SitesOf(configuration);
  return form.FormAt(places, 25.0).SpreadOf(indices);
}

TEST(SizeForm, HasKnownSpreads)
{
  for (const Example& example : { PlateWithSmallHole(), DiskFineInside(), BarWithFillet() })
  {
    const SizeForm form(example.domain, OptionsFor(example.size), {});
    EXPECT_NEAR(SpreadOf(form, example.known), example.spread, 0.015);
  }
}

TEST(SizeForm, VanishesForTheSizesOfAField)
{
  // A plate with two holes, whose fluxes have no periods, and singularities of both signs.
  const PlanarDomain plate =
    MakePlanarDomain({ { { 0.0, 0.0 }, { 4.0, 0.0 }, { 4.0, 2.0 }, { 0.0, 2.0 } },
      RegularPolygon(32, 0.3, { 1.2, 0.9 }), RegularPolygon(32, 0.25, { 2.9, 1.1 }) });
  const Configuration field = { { { 0.6, 0.5 }, -1, 0.0 }, { { 1.9, 0.4 }, -1, 0.0 },
    { { 0.7, 1.5 }, -1, 0.0 }, { { 1.8, 1.5 }, -1, 0.0 }, { { 2.3, 0.6 }, -1, 0.0 },
    { { 3.5, 0.6 }, -1, 0.0 }, { { 2.4, 1.6 }, -1, 0.0 }, { { 3.5, 1.6 }, -1, 0.0 },
    { { 2.0, 1.0 }, 1, 0.0 }, { { 3.7, 1.1 }, -1, 0.0 } };
  const TriangleMesh mesh = DrillMesh(plate, {}, 0.03);
  const PointPotential potential = PointPotentialOn(mesh, {}, Required(plate));
  const PointPotential::Solution solution = potential.Solve(field);
  Eigen::VectorXd sizes(static_cast<Eigen::Index>(mesh.points.size()));
  for (Eigen::Index v = 0; v < sizes.size(); ++v)
  {
    double phi = solution.regular[v];
    for (const LogSource& log : solution.logs)
    {
      const double distance = (mesh.points[static_cast<std::size_t>(v)] - log.position).norm();
      phi += log.strength * std::log(std::max(distance, 0.02));
    }
    sizes[v] = 0.1 * std::exp(0.25 * phi);
  }
  const P1Interpolation size(mesh, sizes);
  const SizeForm form(plate, OptionsFor([&](const Point& place) { return size.At(place); }), {});
  EXPECT_LT(SpreadOf(form, field), 0.02);
  Configuration other = field;
  other[8].position = { 2.0, 0.7 };
  EXPECT_GT(SpreadOf(form, other), 0.05);
  // Sites that have nothing change nothing.
  auto [places, indices] = SitesOf(field);
  places.emplace_back(3.0, 0.4);
  indices.conservativeResize(indices.size() + 1);
  indices[indices.size() - 1] = 0;
  EXPECT_NEAR(form.FormAt(places, 25.0).SpreadOf(indices), SpreadOf(form, field), 1e-9);
}

TEST(SizeForm, IsTheSumOfItsParts)
{
  // Changes of the form between indices with the same sum are those of spread and energy.
  const Example example = BarWithFillet();
  const SizeForm form(example.domain, OptionsFor(example.size), {});
  const auto [places, indices] = SitesOf(example.known);
  const SizeForm::AtSites sites = form.FormAt(places, 25.0);
  const auto valueOf = [&](const Eigen::VectorXi& of)
  {
    const Eigen::VectorXd k = of.cast<double>();
    return sites.form.form.linear.dot(k) + 0.5 * k.dot(sites.form.form.matrix * k);
  };
  Eigen::VectorXi others = indices;
  std::swap(others[0], others[3]);
  const auto squareOf = [&](const Eigen::VectorXi& of)
  { return 0.5e4 * std::pow(sites.SpreadOf(of), 2); };
  const double energy = valueOf(others) - valueOf(indices) - squareOf(others) + squareOf(indices);
  // A fifth of W, which is of the order of the logarithms of distances.
  EXPECT_LT(std::abs(energy), 20.0);
  EXPECT_GT(std::abs(squareOf(others) - squareOf(indices)), 100.0);
}

TEST(SizedConfigurations, NeedNoMoreNodesThanKnown)
{
  for (const Example& example : { PlateWithSmallHole(), DiskFineInside(), BarWithFillet() })
  {
    const std::vector<SizedConfiguration> found =
      SearchForSizes(example.domain, OptionsFor(example.size));
    ASSERT_FALSE(found.empty());
    const auto enough = std::find_if(
      found.begin(), found.end(), [](const SizedConfiguration& one) { return one.spread <= 0.15; });
    ASSERT_NE(enough, found.end());
    EXPECT_LE(enough->singularities.size(), example.known.size());
    int sum = 0;
    for (const Singularity& one : enough->singularities)
    {
      sum += one.quarterIndex;
    }
    EXPECT_EQ(sum, Required(example.domain));
    const SizeForm form(example.domain, OptionsFor(example.size), {});
    EXPECT_NEAR(SpreadOf(form, enough->singularities), enough->spread, 1e-6);
  }
}

TEST(SizedConfigurations, EqualSizesInARectangleNeedNone)
{
  const PlanarDomain plate =
    MakePlanarDomain({ { { 0.0, 0.0 }, { 3.0, 0.0 }, { 3.0, 1.0 }, { 0.0, 1.0 } } });
  const std::vector<SizedConfiguration> found =
    SearchForSizes(plate, OptionsFor([](const Point&) { return 0.1; }));
  ASSERT_EQ(found.size(), 1U);
  EXPECT_TRUE(found[0].singularities.empty());
  EXPECT_LT(found[0].spread, 0.02);
}

TEST(SizedConfigurations, ScaleAndTurnWithTheDomain)
{
  const Example example = BarWithFillet();
  const std::vector<SizedConfiguration> found =
    SearchForSizes(example.domain, OptionsFor(example.size));
  for (const double factor : { 1e-3, 1e3 })
  {
    const Similarity map{ 0.7, factor, Point(3.0 * factor, -factor) };
    const Similarity back{ -0.7, 1.0 / factor, Point::Zero() };
    const Point shift = map(Point::Zero());
    const std::vector<SizedConfiguration> other = SearchForSizes(map(example.domain),
      OptionsFor([&](const Point& place) { return factor * example.size(back(place - shift)); }));
    ASSERT_FALSE(other.empty());
    EXPECT_EQ(other[0].singularities.size(), found[0].singularities.size());
    EXPECT_NEAR(other[0].spread, found[0].spread, 0.02);
  }
}

TEST(SizedConfigurations, HaveTheSymmetriesOfDomainAndSizes)
{
  const PlanarDomain plate =
    MakePlanarDomain({ { { -2.0, -1.0 }, { 2.0, -1.0 }, { 2.0, 1.0 }, { -2.0, 1.0 } },
      RegularPolygon(64, 0.3, { -0.35, 0.0 }), RegularPolygon(64, 0.3, { 0.35, 0.0 }) });
  std::set<std::size_t> symmetries;
  for (const SizedConfiguration& one : SearchForSizes(plate,
         OptionsFor([](const Point& place) { return Grown(0.03, place.norm() - 0.1, 1.25, 0.2); })))
  {
    symmetries.insert(one.symmetries);
  }
  EXPECT_EQ(*symmetries.rbegin(), 4U);
  symmetries.clear();
  for (const SizedConfiguration& one : SearchForSizes(plate,
         OptionsFor([](const Point& place)
           { return Grown(0.03, (place - Point(1.0, 0.0)).norm(), 1.25, 0.2); })))
  {
    symmetries.insert(one.symmetries);
  }
  EXPECT_EQ(*symmetries.rbegin(), 2U);
}

TEST(SizedConfigurations, AreTheSameWhenAllSizesAreHalved)
{
  const Example example = DiskFineInside();
  AutomaticOptions options;
  const double mean = std::sqrt(Pi / 677.0);
  options.optimizer.sizes = { Sizing::Field,
    [&](const Point& place) { return example.size(place) / mean; } };
  Configuration first;
  for (const double factor : { 1.0, 0.5, 0.25 })
  {
    options.quadSize = factor * mean;
    const AutomaticConfiguration chosen = ChooseConfiguration(example.domain, options);
    if (first.empty())
    {
      first = chosen.singularities;
    }
    ASSERT_EQ(chosen.singularities.size(), first.size());
    for (std::size_t i = 0; i < first.size(); ++i)
    {
      EXPECT_EQ(chosen.singularities[i].position, first[i].position);
      EXPECT_EQ(chosen.singularities[i].quarterIndex, first[i].quarterIndex);
    }
  }
}

TEST(SizedConfigurations, SmallPartsCount)
{
  // A hundredth of the area and a thirtieth of the quads.
  const PlanarDomain plate =
    MakePlanarDomain({ { { 0.0, 0.0 }, { 40.0, 0.0 }, { 40.0, 40.0 }, { 0.0, 40.0 } } });
  const auto size = [](const Point& place)
  { return Grown(0.05, (place - Point(20.0, 20.0)).norm() - 0.5, 1.25, 0.6); };
  const std::vector<SizedConfiguration> found = SearchForSizes(plate, OptionsFor(size));
  ASSERT_FALSE(found.empty());
  EXPECT_GE(found.back().singularities.size(), 4U);
  for (const Singularity& one : found.back().singularities)
  {
    EXPECT_LT((one.position - Point(20.0, 20.0)).norm(), 6.0);
  }
}

TEST(SizedConfigurations, KeepGivenSingularities)
{
  const Example example = DiskFineInside();
  SizeSearchOptions options = OptionsFor(example.size);
  options.given = OnCircle(4, 0.6, 0.0, 1, 0.0);
  const SizeForm form(example.domain, options, {});
  const double alone = form.FormAt({ { 0.0, 0.0 } }, 25.0).SpreadOf(Eigen::VectorXi::Zero(1));
  bool isBetter = false;
  for (const SizedConfiguration& one : SearchForSizes(example.domain, options))
  {
    ASSERT_GE(one.singularities.size(), 4U);
    for (std::size_t i = 0; i < 4; ++i)
    {
      EXPECT_EQ(one.singularities[i].position, options.given[i].position);
    }
    int sum = 0;
    for (const Singularity& singularity : one.singularities)
    {
      sum += singularity.quarterIndex;
    }
    EXPECT_EQ(sum, 4);
    isBetter = isBetter || one.spread < 0.5 * alone;
  }
  EXPECT_TRUE(isBetter);
}
}
}
