// Proposed configurations, and the solver's results for them and for others.

#include "BuiltinDomains.h"
#include "ConfigurationSpread.h"
#include "CornerClassification.h"
#include "DomainQueries.h"
#include "DrillHoles.h"
#include "FieldCheck.h"
#include "MakePlanarDomain.h"
#include "PerforatedSolve.h"
#include "PoincareHopf.h"
#include "Support.h"

#include <algorithm>
#include <cmath>

namespace crossfield::test
{
namespace
{
SolvedField SolveUnitNormOn(const TriangleMesh& mesh)
{
  PerforatedOptions options;
  options.method = PerforatedMethod::UnitNorm;
  return SolvePerforated(ShareTopology(mesh), options);
}

TEST(DomainQueries, SignedDistance)
{
  const PlanarDomain ring = Builtin("ring", 0.001);
  EXPECT_NEAR(SignedDistance({ 0.7, 0.0 }, ring), 0.3, 1e-5);
  EXPECT_NEAR(SignedDistance({ 0.0, 0.0 }, ring), -0.4, 1e-5);
  EXPECT_NEAR(SignedDistance({ 0.0, -2.0 }, ring), -1.0, 1e-5);
}

TEST(DomainQueries, DistanceAlongRay)
{
  const PlanarDomain square = Builtin("square");
  EXPECT_NEAR(
    DistanceAlongRay(square, { 0.0, 0.0 }, Point(1.0, 1.0).normalized()), std::sqrt(2.0), 1e-12);
  EXPECT_NEAR(DistanceAlongRay(square, { 0.5, 0.0 }, { 0.0, 1.0 }), 1.0, 1e-12);
  EXPECT_EQ(DistanceAlongRay(square, { 0.5, 0.0 }, { 0.0, -1.0 }), 0.0);
}

TEST(ConfigurationSpread, IsConsistentAndCanBeDrilledAndSolved)
{
  for (const std::string& name : BuiltinDomainNames())
  {
    for (const bool cancel : { false, true })
    {
      SCOPED_TRACE(name + (cancel ? " with pairs" : ""));
      const PlanarDomain domain = Builtin(name);
      SpreadOptions options;
      options.cancelFlatCorners = cancel;
      const Configuration proposal = SpreadConfiguration(domain, options);
      EXPECT_EQ(TotalQuarters(proposal), Required(domain));
      if (!cancel)
      {
        EXPECT_EQ(proposal.size(), static_cast<std::size_t>(std::abs(Required(domain))));
      }
      // Every configuration that the check accepts yields a field without other singularities.
      const TriangleMesh mesh = DrillHoles(domain, proposal);
      const SolvedField field = SolveUnitNormOn(mesh);
      EXPECT_TRUE(field.converged);
      EXPECT_EQ(field.unwantedSingularities, 0);
      const FieldCheck check = CheckField({ ShareTopology(mesh), field.u });
      EXPECT_TRUE(check.asPrescribed) << check.reason;
    }
  }
}

TEST(ConfigurationSpread, CancelsFlatAnglesAsInThePaper)
{
  SpreadOptions options;
  options.cancelFlatCorners = true;
  const auto signs = [&](const char* name)
  {
    std::vector<int> quarters;
    for (const Singularity& singularity : SpreadConfiguration(Builtin(name), options))
    {
      quarters.push_back(singularity.quarterIndex);
    }
    return quarters;
  };
  // One +1/4 between the two flat angles and one −1/4.
  EXPECT_EQ(signs("angular-balanced"), std::vector<int>({ 1, -1 }));
  // Two +1/4 between the flat angles and four −1/4 around the hole.
  EXPECT_EQ(signs("angular-hole"), std::vector<int>({ 1, 1, -1, -1, -1, -1 }));
}

TEST(ConfigurationSpread, SpreadsOverTheDisk)
{
  // Four equal disks fit into the unit disk if their centres are at distance 2 − √2 from its
  // centre.
  const Configuration proposal = SpreadConfiguration(Builtin("disk"));
  ASSERT_EQ(proposal.size(), 4u);
  for (std::size_t i = 0; i < 4; ++i)
  {
    EXPECT_NEAR(proposal[i].position.norm(), 2.0 - std::sqrt(2.0), 0.1);
    EXPECT_GT(proposal[i].radius, 0.0);
    for (std::size_t j = 0; j < i; ++j)
    {
      EXPECT_GT((proposal[i].position - proposal[j].position).norm(), 0.7);
    }
  }
}

TEST(ConfigurationSpread, CompletesGivenSingularities)
{
  SpreadOptions options;
  options.given = { { Point(0.3, 0.0), -1, 0.05 }, { Point(-0.3, 0.0), 2, 0.1 } };
  const PlanarDomain disk = Builtin("disk");
  const Configuration proposal = SpreadConfiguration(disk, options);
  ASSERT_EQ(proposal.size(), 5u);
  EXPECT_EQ(proposal[1].quarterIndex, 2);
  EXPECT_EQ(proposal[0].position, options.given[0].position);
  EXPECT_EQ(TotalQuarters(proposal), 4);
  EXPECT_NO_THROW(DrillHoles(disk, proposal));
  options.given[0].position = Point(3.0, 0.0);
  EXPECT_TRUE(Refuses([&] { SpreadConfiguration(disk, options); }, { "outside" }));
}

TEST(ConfigurationSpread, FollowsChosenCorners)
{
  SpreadOptions options;
  options.corners = { { Point(0.0, 0.0), 2 }, { Point(1.0, 1.0), 0 }, { Point(1.0, 0.0), 0 } };
  EXPECT_EQ(TotalQuarters(SpreadConfiguration(Builtin("square"), options)), 1);
}

TEST(ConfigurationSpread, IsScaleInvariant)
{
  const PlanarDomain star = Builtin("star");
  const Configuration plain = SpreadConfiguration(star);
  for (const double scale : { 1e-6, 1e6 })
  {
    const Similarity move{ 0.0, scale, Point::Zero() };
    const Configuration scaled = SpreadConfiguration(move(star));
    ASSERT_EQ(scaled.size(), plain.size());
    for (std::size_t i = 0; i < plain.size(); ++i)
    {
      EXPECT_NEAR((scaled[i].position / scale - plain[i].position).norm(), 0.0, 1e-9);
      EXPECT_NEAR(scaled[i].radius / scale, plain[i].radius, 1e-9);
    }
  }
}

TEST(ChosenCorners, AreTakenByTheUnitNormField)
{
  // The corner of a square at the origin has k = 0 instead of 1. Its energy is moderate, so the
  // field shows the chosen index.
  const PlanarDomain square = Builtin("square");
  const std::vector<CornerChoice> corners = { { Point(0.0, 0.0), 0 } };
  const Configuration one = { { Point(0.4, 0.4), 1, 0.05 } };
  const TriangleMesh mesh = DrillHoles(square, one);
  EXPECT_TRUE(Refuses(
    [&] { SolveUnitNormOn(mesh); }, { "add up to 1", "requires 0" }, Error::Kind::Inconsistent));
  PerforatedOptions options;
  options.method = PerforatedMethod::UnitNorm;
  options.corners = corners;
  const SolvedField field = SolvePerforated(ShareTopology(mesh), options);
  EXPECT_TRUE(field.converged);
  EXPECT_EQ(field.unwantedSingularities, 0);
  EXPECT_EQ(field.count.requiredInteriorQuarters, 1);
  const FieldCheck check = CheckField({ ShareTopology(mesh), field.u });
  EXPECT_TRUE(check.asPrescribed);
  ASSERT_EQ(check.count.corners.size(), 4u);
  for (const CountedCorner& corner : check.count.corners)
  {
    EXPECT_EQ(corner.quarterIndex, corner.position.norm() < 1e-9 ? 0 : 1);
  }
  EXPECT_TRUE(check.count.Consistent());

  // Choosing the indices of the smallest rotation changes nothing.
  options.corners = { { Point(0.0, 0.0), 1 }, { Point(1.0, 0.0), 1 } };
  const TriangleMesh pair =
    DrillHoles(square, { { Point(0.3, 0.4), 1, 0.05 }, { Point(0.7, 0.6), -1, 0.05 } });
  EXPECT_EQ(SolvePerforated(ShareTopology(pair), options).energy, SolveUnitNormOn(pair).energy);
  options.corners = { { Point(0.5, 0.5), 1 } };
  EXPECT_TRUE(Refuses([&] { SolvePerforated(ShareTopology(mesh), options); }, { "not a vertex" }));
}

TEST(ChosenCorners, ExactMinimiserHasTheLowestFieldEnergy)
{
  // A sector of 70° = 0.389π: k = 1 compared with k = 2 and k = 0. The energy of the field follows
  // the singular energies of corners and holes.
  const double angle = 70.0 / 180.0 * Pi;
  Loop sector = { { 0.0, 0.0 } };
  for (int i = 0; i <= 24; ++i)
  {
    sector.emplace_back(std::cos(angle * i / 24.0), std::sin(angle * i / 24.0));
  }
  const PlanarDomain domain = MakePlanarDomain({ sector });
  const CornerClassification best = ClassifyCorners(domain);
  double energy[2];
  for (const int k : { 0, 1 })
  {
    PerforatedOptions options;
    options.method = PerforatedMethod::UnitNorm;
    options.corners = { { Point(0.0, 0.0), k } };
    SpreadOptions proposal;
    proposal.corners = options.corners;
    const TriangleMesh mesh = DrillHoles(domain, SpreadConfiguration(domain, proposal));
    energy[k] = SolvePerforated(ShareTopology(mesh), options).energy;
  }
  EXPECT_LT(energy[1], energy[0]);
  EXPECT_EQ(
    std::min_element(best.corners.begin(), best.corners.end(),
      [](const Corner& a, const Corner& b) { return a.position.norm() < b.position.norm(); })
      ->quarterIndex,
    1);
}

TEST(RejectedConfigurations, AreRejectedWithTheMessageOfTheCheck)
{
  for (const char* name : { "disk", "l-shape", "angular-hole", "quarter-disk" })
  {
    SCOPED_TRACE(name);
    const PlanarDomain domain = Builtin(name);
    Configuration wrong = SpreadConfiguration(domain);
    if (wrong.empty())
    {
      wrong.push_back({ Point(0.25, 0.25), 1, 0.02 });
    }
    else
    {
      wrong.pop_back();
    }
    const TriangleMesh mesh = DrillHoles(domain, wrong);
    const std::string reason = ConsistencyReason(CountQuarters(domain.loops, TotalQuarters(wrong)));
    for (const auto method : { PerforatedMethod::Constrained, PerforatedMethod::UnitNorm })
    {
      PerforatedOptions options;
      options.method = method;
      EXPECT_TRUE(Refuses([&] { SolvePerforated(ShareTopology(mesh), options); }, { reason },
        Error::Kind::Inconsistent));
    }
  }
}

TEST(RequireInside, RejectsPositionsOutside)
{
  const PlanarDomain ring = Builtin("ring");
  EXPECT_NO_THROW(RequireInside(ring, { { Point(0.7, 0.0), 1, 0.0 } }));
  EXPECT_TRUE(Refuses(
    [&] {
      RequireInside(ring, { { Point(0.7, 0.0), 1, 0.0 }, { Point(0.0, 0.1), 1, 0.0 } });
    },
    { "singularity 2", "(0, 0.1)", "outside" }));
  EXPECT_TRUE(Refuses(
    [&] {
      RequireInside(ring, { { Point(std::nan(""), 0.0), 1, 0.0 } });
    },
    { "Row 1", "finite" }));
}

TEST(FieldCheck, CountsTheIndicesOfTheField)
{
  const PlanarDomain disk = Builtin("disk");
  const TriangleMesh mesh = DrillHoles(disk, OnCircle(4, 0.6, 0.25 * Pi, 1, 0.1));
  const SolvedField field = SolveUnitNormOn(mesh);
  const FieldCheck check = CheckField({ ShareTopology(mesh), field.u });
  EXPECT_EQ(check.holes.size(), 4u);
  EXPECT_EQ(check.prescribedDegrees, std::vector<int>({ 1, 1, 1, 1 }));
  EXPECT_EQ(check.interiorQuarters, 0);
  EXPECT_TRUE(check.asPrescribed);
  EXPECT_TRUE(check.count.Consistent());
  EXPECT_EQ(check.count.givenInteriorQuarters, 4);
  EXPECT_NE(check.reason.find("prescribed degrees"), std::string::npos);

  // The same field on a mesh that prescribes other degrees.
  TriangleMesh other = mesh;
  for (BoundaryEdge& edge : other.boundary)
  {
    edge.quarterIndex += edge.kind == BoundaryKind::Hole ? 1 - 2 * (edge.id % 2) : 0;
  }
  const FieldCheck wrong = CheckField({ ShareTopology(other), field.u });
  EXPECT_FALSE(wrong.asPrescribed);
  EXPECT_TRUE(wrong.count.Consistent()) << "the sums agree for every field";
  EXPECT_NE(wrong.reason.find("4 holes"), std::string::npos) << wrong.reason;

  // Without holes the positions of the singularities are free, but their sum must be four: here u =
  // e^{4iφ} around the origin.
  const TriangleMesh undrilled = DrillHoles(disk, {});
  const EdgeNumbering edges = NumberEdges(undrilled);
  ComplexVector own(edges.Count());
  for (int e = 0; e < edges.Count(); ++e)
  {
    const Point middle = Midpoint(undrilled, edges, e);
    own[e] = std::polar(1.0, 4.0 * std::atan2(middle.y(), middle.x()));
  }
  for (std::size_t i = 0; i < undrilled.boundary.size(); ++i)
  {
    const auto& ends = undrilled.boundary[i].vertices;
    own[edges.ofBoundary[i]] = AlignedRepresentation(
      undrilled.points[std::size_t(ends[1])] - undrilled.points[std::size_t(ends[0])]);
  }
  const FieldCheck free = CheckField({ ShareTopology(undrilled), own });
  EXPECT_TRUE(free.asPrescribed) << free.reason;
  EXPECT_EQ(free.interiorQuarters, 4);
  EXPECT_NE(free.reason.find("total 4"), std::string::npos) << free.reason;

  ComplexVector bad = field.u;
  bad[0] = std::nan("");
  EXPECT_TRUE(Refuses([&] { CheckField({ ShareTopology(mesh), bad }); }, { "finite" }));
}
}
}
