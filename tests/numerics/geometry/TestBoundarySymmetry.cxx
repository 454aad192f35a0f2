#include "BoundarySymmetry.h"
#include "ConfigurationSymmetry.h"
#include "MakePlanarDomain.h"
#include "Support.h"

#include <algorithm>
#include <cmath>

namespace crossfield::test
{
namespace
{
Loop Rectangle(double width, double height)
{
  return { { -0.5 * width, -0.5 * height }, { 0.5 * width, -0.5 * height },
    { 0.5 * width, 0.5 * height }, { -0.5 * width, 0.5 * height } };
}

TEST(BoundarySymmetry, FindsSymmetriesOfKnownDomains)
{
  const struct
  {
    std::vector<Loop> loops;
    int order;
    bool reflects;
  } cases[] = {
    { { RegularPolygon(5) }, 5, true },
    { { Rectangle(2.0, 1.0) }, 2, true },
    { { Rectangle(1.0, 1.0) }, 4, true },
    { { { { 0.0, 0.0 }, { 2.0, 0.0 }, { 2.5, 1.0 }, { 0.5, 1.0 } } }, 2, false }, // parallelogram
    { { { { 0.0, 0.0 }, { 2.0, 0.0 }, { 0.3, 1.0 } } }, 1, false },
    // A hole off the centre leaves one reflection, and so do two holes of different size in a row.
    { { Rectangle(2.0, 1.0), RegularPolygon(12, 0.2, { 0.5, 0.0 }) }, 1, true },
    { { Rectangle(2.0, 1.0), RegularPolygon(12, 0.2, { 0.5, 0.0 }),
        RegularPolygon(12, 0.2, { -0.5, 0.0 }) },
      2, true },
    { { Rectangle(2.0, 1.0), RegularPolygon(12, 0.2, { 0.5, 0.1 }),
        RegularPolygon(12, 0.2, { -0.5, -0.1 }) },
      2, false },
    { { Rectangle(2.0, 1.0), RegularPolygon(12, 0.2, { 0.5, 0.1 }) }, 1, false },
  };
  for (const auto& one : cases)
  {
    for (const double angle : { 0.0, 0.7 })
    {
      for (const double scale : { 1e-6, 1.0, 1e6 })
      {
        const Similarity move{ angle, scale, Point(3.0 * scale, -2.0 * scale) };
        const PlanarDomain domain = MakePlanarDomain(move(one.loops));
        const SymmetryGroup group = FindSymmetries(domain);
        EXPECT_EQ(group.order, one.order) << one.loops.size() << " loops at " << angle;
        EXPECT_EQ(group.reflects, one.reflects) << one.loops.size() << " loops at " << angle;
        // Each element maps each vertex to a vertex.
        for (const Isometry& map : group.Elements())
        {
          const Point image = map(domain.loops[0][0]);
          double nearest = domain.Diagonal();
          for (const Point& vertex : domain.loops[0])
          {
            nearest = std::min(nearest, (vertex - image).norm());
          }
          EXPECT_LT(nearest, 1e-9 * domain.Diagonal());
          EXPECT_LT((map.Inverse()(image) - domain.loops[0][0]).norm(), 1e-9 * domain.Diagonal());
        }
      }
    }
  }
}

TEST(BoundarySymmetry, IgnoresStraightVertices)
{
  Loop square = Rectangle(1.0, 1.0);
  square.insert(square.begin() + 1, Point(0.1, -0.5));
  const SymmetryGroup group = FindSymmetries(MakePlanarDomain({ square }));
  EXPECT_EQ(group.order, 4);
  EXPECT_TRUE(group.reflects);
}

TEST(BoundarySymmetry, ToleranceIsRelative)
{
  Loop square = Rectangle(1.0, 1.0);
  square[0] += Point(1e-6, 0.0);
  EXPECT_EQ(FindSymmetries(MakePlanarDomain({ square })).order, 1);
  EXPECT_EQ(FindSymmetries(MakePlanarDomain({ square }), 1e-5).order, 4);
}

TEST(ConfigurationSymmetry, ProjectsToTheLargestSubgroupThatFits)
{
  const PlanarDomain disk = MakePlanarDomain({ RegularPolygon(48) });
  const SymmetryGroup group = FindSymmetries(disk);
  EXPECT_EQ(group.order, 48);
  Random random(3);
  Configuration places = OnCircle(4, 0.85, 0.3, 1, 0.0);
  for (Singularity& singularity : places)
  {
    singularity.position += 0.01 * Point(random.Uniform(-1.0, 1.0), random.Uniform(-1.0, 1.0));
  }
  const Configuration before = places;
  const ConfigurationSymmetry symmetry = MatchSymmetry(places, group, 0.05);
  EXPECT_EQ(symmetry.elements.size(), 8u) << "those of the square";
  symmetry.Project(places);
  for (std::size_t g = 0; g < symmetry.elements.size(); ++g)
  {
    for (std::size_t i = 0; i < places.size(); ++i)
    {
      EXPECT_LT(
        (symmetry.elements[g](places[i].position) - places[symmetry.images[g][i]].position).norm(),
        1e-14);
    }
  }
  for (std::size_t i = 0; i < places.size(); ++i)
  {
    EXPECT_LT((places[i].position - before[i].position).norm(), 0.05);
  }
  // The projection of directions is the derivative of Project and orthogonal.
  Eigen::VectorXd direction = Eigen::VectorXd::Random(8);
  Configuration moved = places;
  for (std::size_t i = 0; i < 4; ++i)
  {
    moved[i].position += direction.segment<2>(2 * static_cast<Eigen::Index>(i));
  }
  symmetry.Project(moved);
  const Eigen::VectorXd projected = symmetry.ProjectDirections(direction);
  for (std::size_t i = 0; i < 4; ++i)
  {
    EXPECT_LT((moved[i].position - places[i].position -
                projected.segment<2>(2 * static_cast<Eigen::Index>(i)))
                .norm(),
      1e-14);
  }
  EXPECT_NEAR(projected.dot(direction), projected.squaredNorm(), 1e-14);
  // A different index at one position leaves only the reflection through it.
  Configuration odd = OnCircle(4, 0.85, 0.0, 1, 0.0);
  odd[0].quarterIndex = -1;
  EXPECT_EQ(MatchSymmetry(odd, group, 0.05).elements.size(), 2u);
  // Without symmetry nothing moves.
  Configuration none = { { Point(0.1, 0.2), 1, 0.0 }, { Point(-0.5, 0.3), -1, 0.0 } };
  const ConfigurationSymmetry trivial = MatchSymmetry(none, group, 0.001);
  EXPECT_TRUE(trivial.IsTrivial());
  trivial.Project(none);
  EXPECT_EQ(none[0].position, Point(0.1, 0.2));
}
}
}
