// Images of nodes under a motion: those of an exhaustive search.

#include "NodeImages.h"

#include "Index.h"
#include "Support.h"

#include <Eigen/Geometry>

#include <algorithm>

namespace crossfield::test
{
TEST(NodeImages, AreTheNearestNodesWithinTheTolerance)
{
  Random random(31);
  constexpr int Count = 200;
  for (const double apart : { 0.0, 1e-11, 1e-7 })
  {
    Eigen::Affine3d motion(Eigen::AngleAxisd(1.1, Eigen::Vector3d(1.0, 2.0, -0.5).normalized()));
    motion.pretranslate(Eigen::Vector3d(3.0, -1.0, 0.2));
    std::vector<Eigen::Vector3d> points;
    std::vector<int> from;
    std::vector<int> to;
    for (int i = 0; i < Count; ++i)
    {
      points.emplace_back(random.Uniform(0.0, 9.0), random.Uniform(0.0, 9.0), random.Integer(0, 2));
      from.push_back(i);
    }
    for (int i = 0; i < Count; ++i)
    {
      const Complex direction = random.UnitComplex();
      points.push_back(motion * points[Index(i)] +
        apart * Eigen::Vector3d(direction.real(), 0.0, direction.imag()));
      to.push_back(Count + i);
    }
    std::reverse(to.begin(), to.end());
    const std::vector<int> images = FindImages(points, motion.matrix(), from, to);
    for (int i = 0; i < Count; ++i)
    {
      EXPECT_EQ(images[Index(i)], apart > 1e-8 ? -1 : Count + i);
    }
  }
}
}
