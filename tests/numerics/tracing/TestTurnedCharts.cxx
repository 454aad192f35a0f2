// The map, its T-mesh and edge counts need no common frame of the triangles: with the chart of each
// triangle turned by a random angle they are the same.

#include "MakePlanarDomain.h"
#include "MeshForPoints.h"
#include "PhaseSteps.h"
#include "Quantisation.h"
#include "SeamlessMapChecks.h"
#include "Support.h"
#include "TMeshChecks.h"
#include "TargetSolve.h"

#include <Eigen/Geometry>

#include <memory>
#include <utility>

namespace crossfield::test
{
namespace
{
/// A planar topology with turned charts.
struct TurnedTopology : MeshTopology
{
  TurnedTopology(const PlanarTopology& planar, const std::vector<double>& angles)
    : MeshTopology(planar)
  {
    this->charts.emplace();
    this->charts->positions = InSpace(planar.mesh.points);
    this->charts->curvature = Eigen::VectorXd::Zero(planar.VertexCount());
    for (int t = 0; t < planar.TriangleCount(); ++t)
    {
      const double mine = angles[static_cast<std::size_t>(t)];
      const Eigen::Rotation2Dd turn(mine);
      this->charts->corners.push_back(
        { turn * planar.At(t, 0), turn * planar.At(t, 1), turn * planar.At(t, 2) });
      std::array<double, 3> hinges{};
      for (int side = 0; side < 3; ++side)
      {
        const int other = planar.Neighbour(t, side);
        hinges[static_cast<std::size_t>(side)] =
          other < 0 ? 0.0 : WrapAngle(angles[static_cast<std::size_t>(other)] - mine);
      }
      this->charts->hinges.push_back(hinges);
    }
  }
};

/// The results for one topology.
struct Solved
{
  SeamlessMap map;
  TMesh mesh;
  std::vector<int> counts;
};

Solved Solve(const SharedTopology& topology, PhaseSteps steps, const std::vector<Cone>& cones)
{
  TriangleFrames frames = FrameTriangles(*topology, std::move(steps));
  frames.h.array() -= frames.h.mean();
  Solved solved;
  solved.map = SolveTargets({ topology, frames.jump, TargetGradients(*topology, frames) }, cones);
  solved.mesh = MakeTMesh(solved.map, TraceSeparatrices(solved.map));
  solved.counts =
    Quantise(solved.mesh, MakeQuantisationProblem(solved.mesh, 0.1), SearchEffort::Thorough).counts;
  return solved;
}

void ExpectSame(
  const PlanarDomain& domain, const Configuration& configuration, double meshSize, Random& random)
{
  const SharedPlanarTopology planar =
    ShareTopology(MeshThroughPoints(domain, configuration, meshSize));
  const std::vector<Cone> cones = SolveSeamlessMap(planar, configuration).cones;
  const PointPotential potential = PointPotentialOn(planar->mesh, {}, TotalQuarters(configuration));
  const PhaseSteps steps = StepsOf(potential, potential.Solve(configuration));

  std::vector<double> angles;
  for (int t = 0; t < planar->TriangleCount(); ++t)
  {
    angles.push_back(random.Uniform(-Pi, Pi));
  }
  PhaseSteps turnedSteps = steps;
  for (NearCone& near : turnedSteps.near)
  {
    near.position =
      Eigen::Rotation2Dd(angles[static_cast<std::size_t>(near.triangle)]) * near.position;
  }
  const Solved plain = Solve(planar, steps, cones);
  const Solved turned =
    Solve(std::make_shared<const TurnedTopology>(*planar, angles), turnedSteps, cones);

  EXPECT_EQ(SeamDefect(turned.map), 0.0);
  EXPECT_NEAR(turned.map.residual, plain.map.residual, 1e-10);
  EXPECT_EQ(turned.map.seams, plain.map.seams);
  // Lengths instead of coordinates, as the first chart of the map is arbitrary up to a quarter
  // turn.
  for (std::size_t t = 0; t < plain.map.corners.size(); ++t)
  {
    for (int side = 0; side < 3; ++side)
    {
      const auto length = [&](const SeamlessMap& map)
      {
        return (map.At(static_cast<int>(t), (side + 1) % 3) - map.At(static_cast<int>(t), side))
          .norm();
      };
      EXPECT_NEAR(length(turned.map), length(plain.map), 1e-10);
    }
  }
  ASSERT_EQ(turned.mesh.arcs.size(), plain.mesh.arcs.size());
  ASSERT_EQ(turned.mesh.nodes.size(), plain.mesh.nodes.size());
  for (std::size_t a = 0; a < plain.mesh.arcs.size(); ++a)
  {
    EXPECT_NEAR(turned.mesh.arcs[a].length, plain.mesh.arcs[a].length, 1e-10);
  }
  for (std::size_t n = 0; n < plain.mesh.nodes.size(); ++n)
  {
    EXPECT_LT((turned.mesh.nodes[n].place - plain.mesh.nodes[n].place).norm(), 1e-10);
  }
  EXPECT_EQ(turned.counts, plain.counts);
}

TEST(TurnedCharts, GiveTheSameMapTMeshAndCounts)
{
  Random random(45);
  // Without symmetries: on a symmetric mesh rounding errors decide where it is cut.
  {
    SCOPED_TRACE("disk");
    const Configuration four = { { { 0.52, 0.31 }, 1 }, { { -0.35, 0.47 }, 1 },
      { { -0.51, -0.4 }, 1 }, { { 0.33, -0.55 }, 1 } };
    ExpectSame(Builtin("disk", 0.05), four, 0.05, random);
  }
  {
    SCOPED_TRACE("ring");
    Loop hole = RegularPolygon(40, 0.4);
    hole[3] *= 1.02;
    ExpectSame(MakePlanarDomain({ RegularPolygon(64), hole }), {}, 0.05, random);
  }
  SCOPED_TRACE("square");
  ExpectSame(Builtin("square"), { { { 0.3, 0.4 }, 1 }, { { 0.7, 0.45 }, -1 } }, 0.05, random);
}
}
}
