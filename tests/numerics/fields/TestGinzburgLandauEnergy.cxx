#include "DrillHoles.h"
#include "GinzburgLandauEnergy.h"
#include "Support.h"

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>
#include <limits>

namespace crossfield::test
{
namespace
{
constexpr double Epsilon = 0.2;

/// L-shape with a random aligned field and its energy.
class GinzburgLandauEnergyTest : public testing::Test
{
public:
  GinzburgLandauEnergyTest()
    : Mesh(DrillHoles(Builtin("l-shape", 0.25), {}, Coarse()))
    , Edges(NumberEdges(this->Mesh))
  {
  }

  static DrillOptions Coarse()
  {
    DrillOptions options;
    options.meshSize = 0.25;
    return options;
  }

  GinzburgLandauEnergy Energy(const GinzburgLandauPinning& pinning = {}) const
  {
    return GinzburgLandauEnergy(PlanarTopology(this->Mesh), Epsilon, pinning);
  }

  ComplexVector RandomField(const GinzburgLandauEnergy& energy)
  {
    ComplexVector u(this->Edges.Count());
    std::generate(u.begin(), u.end(), [this] { return 1.5 * this->Numbers.Square(); });
    energy.Align(u);
    return u;
  }

  Eigen::VectorXd RandomValues(Eigen::Index count, double lower, double upper)
  {
    Eigen::VectorXd values(count);
    std::generate(
      values.begin(), values.end(), [&] { return this->Numbers.Uniform(lower, upper); });
    return values;
  }

  /// Returns no pinning; a norm per triangle; a norm per edge and a weight; and a norm that is zero
  /// in places.
  std::vector<GinzburgLandauPinning> Pinnings()
  {
    const auto triangles = static_cast<Eigen::Index>(this->Mesh.triangles.size());
    std::vector<GinzburgLandauPinning> pinnings(4);
    pinnings[1].norm = this->RandomValues(triangles, 0.2, 1.4);
    pinnings[2].norm = this->RandomValues(this->Edges.Count(), 0.2, 1.4);
    pinnings[2].gradientWeight = this->RandomValues(triangles, 0.1, 3.0);
    pinnings[3].norm = Eigen::VectorXd::Zero(triangles);
    return pinnings;
  }

  TriangleMesh Mesh;
  EdgeNumbering Edges;
  Random Numbers{ 41 };
};

ComplexVector Moved(
  const GinzburgLandauEnergy& energy, ComplexVector u, Eigen::Index unknown, double by)
{
  const int edge = energy.FreeEdges()[static_cast<std::size_t>(unknown / 2)];
  u[edge] += unknown % 2 == 0 ? Complex(by, 0.0) : Complex(0.0, by);
  return u;
}

TEST_F(GinzburgLandauEnergyTest, GradientIsTheDerivativeOfTheEnergy)
{
  constexpr double Difference = 1e-5;
  for (const GinzburgLandauPinning& pinning : this->Pinnings())
  {
    const GinzburgLandauEnergy energy = this->Energy(pinning);
    const ComplexVector u = this->RandomField(energy);
    const Eigen::VectorXd gradient = energy.Gradient(u);
    ASSERT_EQ(gradient.size(), 2 * static_cast<Eigen::Index>(energy.FreeEdges().size()));
    for (Eigen::Index i = 0; i < gradient.size(); ++i)
    {
      const double slope = (energy.Value(Moved(energy, u, i, Difference)) -
                             energy.Value(Moved(energy, u, i, -Difference))) /
        (2.0 * Difference);
      EXPECT_NEAR(gradient[i], slope, 1e-7 * gradient.lpNorm<Eigen::Infinity>()) << i;
    }
  }
}

TEST_F(GinzburgLandauEnergyTest, HessianIsTheDerivativeOfTheGradient)
{
  constexpr double Difference = 1e-5;
  for (const GinzburgLandauPinning& pinning : this->Pinnings())
  {
    const GinzburgLandauEnergy energy = this->Energy(pinning);
    const ComplexVector u = this->RandomField(energy);
    const Eigen::SparseMatrix<double> sparse = energy.Hessian(u);
    EXPECT_TRUE(sparse.isCompressed());
    const Eigen::MatrixXd hessian = sparse;
    EXPECT_EQ(hessian, hessian.transpose());
    for (Eigen::Index i = 0; i < hessian.cols(); ++i)
    {
      const Eigen::VectorXd column = (energy.Gradient(Moved(energy, u, i, Difference)) -
                                       energy.Gradient(Moved(energy, u, i, -Difference))) /
        (2.0 * Difference);
      EXPECT_LT((hessian.col(i) - column).norm(), 1e-7 * hessian.norm()) << i;
    }
    const Eigen::MatrixXd shifted = energy.Hessian(u, 0.3);
    const Eigen::MatrixXd metric = energy.Metric().asDiagonal();
    EXPECT_LT((shifted - hessian - 0.3 * metric).norm(), 1e-13 * hessian.norm());
  }
}

TEST_F(GinzburgLandauEnergyTest, ShiftByTheMetricMakesTheHessianPositiveDefinite)
{
  for (const GinzburgLandauPinning& pinning : this->Pinnings())
  {
    const GinzburgLandauEnergy energy = this->Energy(pinning);
    ComplexVector zero = ComplexVector::Zero(this->Edges.Count());
    energy.Align(zero);
    for (const ComplexVector& u : { zero, this->RandomField(energy) })
    {
      const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(
        Eigen::MatrixXd(energy.Hessian(u, 1.0)), Eigen::EigenvaluesOnly);
      EXPECT_GT(solver.eigenvalues().minCoeff(), 0.0);
    }
  }
}

TEST_F(GinzburgLandauEnergyTest, PartsMatchIntegralsByHand)
{
  const GinzburgLandauEnergy energy = this->Energy();
  const double area = MeshArea(this->Mesh);
  const ComplexVector one = ComplexVector::Ones(this->Edges.Count());
  EXPECT_NEAR(energy.Value(one), 0.0, 1e-10);
  // |u|² = 4: the penalty is 9 / (4ε²) times the area.
  EXPECT_NEAR(energy.PenaltyPart(2.0 * one), 9.0 * area / (4.0 * Epsilon * Epsilon), 1e-9 * area);

  // u = x + 2iy has ½ |∇u|² = 5/2.
  ComplexVector linear(this->Edges.Count());
  for (int e = 0; e < this->Edges.Count(); ++e)
  {
    const Point place = Midpoint(this->Mesh, this->Edges, e);
    linear[e] = Complex(place.x(), 2.0 * place.y());
  }
  EXPECT_NEAR(energy.GradientPart(linear), 2.5 * area, 1e-10);

  // There is no penalty where f is the norm of the field; a weight multiplies the gradient term.
  GinzburgLandauPinning pinning;
  pinning.norm = linear.cwiseAbs();
  pinning.gradientWeight =
    Eigen::VectorXd::Constant(static_cast<Eigen::Index>(this->Mesh.triangles.size()), 3.0);
  const GinzburgLandauEnergy pinned = this->Energy(pinning);
  EXPECT_NEAR(pinned.PenaltyPart(linear), 0.0, 1e-10);
  EXPECT_NEAR(pinned.GradientPart(linear), 7.5 * area, 1e-10);
}

TEST_F(GinzburgLandauEnergyTest, PenaltyOfASmoothFieldConvergesWithTheSecondOrder)
{
  // ∫ (x⁴ − 1)² over the square [0, 1]² = 1/9 − 2/5 + 1.
  const double exact = (1.0 / 9.0 - 2.0 / 5.0 + 1.0) / (4.0 * Epsilon * Epsilon);
  std::vector<double> sizes;
  std::vector<double> errors;
  PlanarDomain square;
  square.loops = { { { 0.0, 0.0 }, { 1.0, 0.0 }, { 1.0, 1.0 }, { 0.0, 1.0 } } };
  DrillOptions options;
  options.meshSize = 0.3;
  TriangleMesh mesh = DrillHoles(square, {}, options);
  for (double size = 1.0; size > 0.1; size *= 0.5, mesh = Refine(mesh))
  {
    const EdgeNumbering edges = NumberEdges(mesh);
    ComplexVector u(edges.Count());
    for (int e = 0; e < edges.Count(); ++e)
    {
      u[e] = std::pow(Midpoint(mesh, edges, e).x(), 2);
    }
    sizes.push_back(size);
    errors.push_back(
      std::abs(GinzburgLandauEnergy(PlanarTopology(mesh), Epsilon).PenaltyPart(u) - exact));
  }
  EXPECT_GT(ConvergenceRate(sizes, errors), 1.8);
}

TEST_F(GinzburgLandauEnergyTest, HarmonicFieldMinimisesTheGradientPart)
{
  GinzburgLandauPinning weighted;
  weighted.gradientWeight =
    this->RandomValues(static_cast<Eigen::Index>(this->Mesh.triangles.size()), 0.1, 3.0);
  for (const GinzburgLandauPinning& pinning : { GinzburgLandauPinning(), weighted })
  {
    const GinzburgLandauEnergy energy = this->Energy(pinning);
    const ComplexVector harmonic = energy.HarmonicField();
    ComplexVector aligned = harmonic;
    energy.Align(aligned);
    EXPECT_EQ(aligned, harmonic);
    const double minimum = energy.GradientPart(harmonic);
    for (int trial = 0; trial < 5; ++trial)
    {
      const ComplexVector change = this->RandomField(energy) - this->RandomField(energy);
      const double both =
        0.5 * (energy.GradientPart(harmonic + change) + energy.GradientPart(harmonic - change));
      EXPECT_NEAR(both - minimum, energy.GradientPart(change), 1e-9 * both);
      EXPECT_NEAR(energy.GradientPart(harmonic + change), both, 1e-9 * both);
    }
  }
}

TEST_F(GinzburgLandauEnergyTest, IsInvariantUnderScalingWithEpsilon)
{
  const GinzburgLandauEnergy energy = this->Energy();
  const ComplexVector u = this->RandomField(energy);
  Similarity scaling;
  scaling.scale = 1e4;
  const TriangleMesh large = scaling(this->Mesh);
  const GinzburgLandauEnergy scaled(PlanarTopology(large), Epsilon * scaling.scale);
  EXPECT_NEAR(scaled.Value(u), energy.Value(u), 1e-9 * energy.Value(u));
  EXPECT_LT((scaled.Gradient(u) - energy.Gradient(u)).norm(), 1e-9 * energy.Gradient(u).norm());
}

TEST_F(GinzburgLandauEnergyTest, RejectsInvalidOptions)
{
  for (const double epsilon : { 0.0, -1.0, std::numeric_limits<double>::quiet_NaN() })
  {
    EXPECT_TRUE(Refuses([&] { GinzburgLandauEnergy(PlanarTopology(this->Mesh), epsilon); },
      { "epsilon", "positive" }));
  }
  const auto triangles = static_cast<Eigen::Index>(this->Mesh.triangles.size());
  GinzburgLandauPinning pinning;
  pinning.norm = Eigen::VectorXd::Ones(7);
  EXPECT_TRUE(Refuses([&] { this->Energy(pinning); }, { "norm", "7 values" }));
  pinning.norm = Eigen::VectorXd::Constant(triangles, -1.0);
  EXPECT_TRUE(Refuses([&] { this->Energy(pinning); }, { "norm", "negative" }));
  pinning = {};
  pinning.gradientWeight = Eigen::VectorXd::Ones(3);
  EXPECT_TRUE(Refuses([&] { this->Energy(pinning); }, { "weight", "3 values" }));
  pinning.gradientWeight = Eigen::VectorXd::Zero(triangles);
  EXPECT_TRUE(Refuses([&] { this->Energy(pinning); }, { "weight", "not positive" }));
}
}
}
