#include "ArcDerivatives.h"
#include "LayoutClosing.h"
#include "Layouts.h"
#include "SeamlessMapSolve.h"
#include "Support.h"
#include "TMeshPatches.h"

#include <Eigen/QR>

namespace crossfield::test
{
namespace
{
/// A map and its T-mesh on a given mesh.
struct Traced
{
  SeamlessMap map;
  TMesh tMesh;

  Traced(const TriangleMesh& mesh, const Configuration& singularities)
    : map(SolveSeamlessMap(ShareTopology(mesh), singularities))
    , tMesh(MakeTMesh(map, TraceSeparatrices(map)))
  {
  }

  Eigen::VectorXd Lengths() const
  {
    Eigen::VectorXd lengths(static_cast<Eigen::Index>(this->tMesh.arcs.size()));
    for (std::size_t a = 0; a < this->tMesh.arcs.size(); ++a)
    {
      lengths[static_cast<Eigen::Index>(a)] = this->tMesh.arcs[a].length;
    }
    return lengths;
  }
};

/// Derivatives of the lengths of all arcs and of the defects by the formula and by differences.
struct Derivatives
{
  Eigen::MatrixXd formula;
  Eigen::MatrixXd differences;
  Eigen::MatrixXd formulaOfDefects;
  Eigen::MatrixXd differencesOfDefects; ///< Radians of θ.
  Eigen::VectorXd lengths;
  double largestMismatch = 0.0; ///< Of ℓ and the imaginary part of the path.

  Derivatives(
    const PlanarDomain& domain, const Configuration& singularities, double meshSize, double reach)
  {
    const TriangleMesh mesh = MeshThroughPoints(domain, singularities, meshSize);
    const Traced start(mesh, singularities);
    this->lengths = start.Lengths();
    const PositionResponse response(start.map);
    this->formulaOfDefects = response.GetDefectDerivatives();
    this->formula = Eigen::MatrixXd::Zero(this->lengths.size(), response.Columns());
    const ArcPaths paths(start.map, start.tMesh);
    for (Eigen::Index a = 0; a < this->lengths.size(); ++a)
    {
      const auto path = paths.Of(static_cast<int>(a));
      EXPECT_TRUE(path);
      std::complex<double> sum = 0.0;
      for (const ArcPath::Piece& piece : path->pieces)
      {
        sum += piece.step;
      }
      this->largestMismatch =
        std::max(this->largestMismatch, std::abs(sum.imag() - this->lengths[a]));
      this->formula.row(a) = DifferentiateArc(response, *path);
    }
    this->differences = this->formula;
    this->differencesOfDefects = this->formulaOfDefects;
    // Small beside the edges at singularities, large beside rounding.
    const double step = 1e-5 * domain.Diagonal();
    for (Eigen::Index column = 0; column < response.Columns(); ++column)
    {
      const Cone& cone = response.ConeOf(static_cast<std::size_t>(column / 2));
      const auto moved = [&](double by)
      {
        TriangleMesh movedMesh = mesh;
        Configuration movedSingularities = singularities;
        movedSingularities[static_cast<std::size_t>(cone.row)].position[column % 2] += by;
        // The mesh moves along, so that the error of the map near the cone hardly changes.
        const Point centre = singularities[static_cast<std::size_t>(cone.row)].position;
        for (Point& point : movedMesh.points)
        {
          const double ratio = (point - centre).norm() / reach;
          if (ratio < 1.0)
          {
            point[column % 2] += by * std::pow(1.0 - ratio * ratio, 2);
          }
        }
        return Traced(movedMesh, movedSingularities);
      };
      const Traced after = moved(step);
      const Traced before = moved(-step);
      this->differences.col(column) = (after.Lengths() - before.Lengths()) / (2.0 * step);
      for (Eigen::Index k = 0; k < this->differencesOfDefects.rows(); ++k)
      {
        this->differencesOfDefects(k, column) = 0.25 *
          (after.map.holonomyDefect[static_cast<std::size_t>(k)] -
            before.map.holonomyDefect[static_cast<std::size_t>(k)]) /
          (2.0 * step);
      }
    }
  }

  /// Returns the relative error over moves that keep the defects, up to a common factor of all
  /// lengths for each move.
  double Error() const
  {
    Eigen::MatrixXd formulaPart = this->formula;
    Eigen::MatrixXd differencesPart = this->differences;
    if (this->formulaOfDefects.rows() > 0)
    {
      const Eigen::MatrixXd pseudoInverse =
        this->formulaOfDefects.completeOrthogonalDecomposition().pseudoInverse();
      formulaPart -= formulaPart * pseudoInverse * this->formulaOfDefects;
      differencesPart -= differencesPart * pseudoInverse * this->formulaOfDefects;
    }
    Eigen::MatrixXd error = formulaPart - differencesPart;
    const Eigen::VectorXd unit = this->lengths.normalized();
    error -= unit * (unit.transpose() * error);
    return error.norm() / differencesPart.norm();
  }
};

/// A disk with singularities of both signs, whose separatrices pass others at small distances.
Derivatives OnDisk(double meshSize)
{
  const Configuration six = { { { 0.55, 0.1 }, 1 }, { { 0.05, 0.62 }, 1 }, { { -0.5, -0.15 }, 1 },
    { { 0.1, -0.5 }, 1 }, { { -0.45, 0.45 }, 1 }, { { -0.2, 0.2 }, -1 } };
  return Derivatives(Builtin("disk", 0.05), six, meshSize, 0.3);
}

TEST(ArcDerivatives, LengthIsTheImaginaryPartOfThePath)
{
  const Derivatives derivatives = OnDisk(0.1);
  EXPECT_EQ(derivatives.lengths.size(), 40);
  EXPECT_LT(derivatives.largestMismatch, 1e-14);
}

TEST(ArcDerivatives, JoinedSeparatricesAreStraight)
{
  // Four singularities on a square, whose sides are pairs of separatrices.
  const Configuration four = { { { 0.5, 0.5 }, 1 }, { { -0.5, 0.5 }, 1 }, { { -0.5, -0.5 }, 1 },
    { { 0.5, -0.5 }, 1 } };
  const PlanarDomain disk = Builtin("disk", 0.1);
  ClosingOptions options;
  options.mesh = [&disk](const Configuration& singularities, const Progress&)
  { return MeshThroughPoints(disk, singularities, 0.1); };
  options.size = 0.1;
  options.exact = true;
  options.maximumMaps = 40;
  const Layout square = CloseLayout(disk, LayOutOn(disk, four, {}, 0.1), options).layout;
  ASSERT_EQ(square.tMesh.headOn, 4);
  const std::vector<ArcPath> joined = ArcPaths(square.map, square.tMesh).Joined();
  ASSERT_EQ(joined.size(), 4u);
  const PositionResponse response(square.map);
  for (const ArcPath& path : joined)
  {
    std::complex<double> sum = 0.0;
    for (const ArcPath::Piece& piece : path.pieces)
    {
      sum += piece.step;
    }
    EXPECT_EQ(sum.imag(), 0.0);
    EXPECT_GT(sum.real(), 0.5);
    // Growing the square keeps its separatrices together, turning one of its corners does not.
    const Eigen::RowVectorXd row = DifferentiateArc(response, path);
    Eigen::VectorXd growth(8);
    Eigen::VectorXd turn = Eigen::VectorXd::Zero(8);
    for (Eigen::Index m = 0; m < 4; ++m)
    {
      growth.segment<2>(2 * m) = response.PositionOf(static_cast<std::size_t>(m));
      if (response.GetMoving()[static_cast<std::size_t>(m)] == path.firstCone)
      {
        turn.segment<2>(2 * m) << -growth[2 * m + 1], growth[2 * m];
      }
    }
    EXPECT_GT(std::abs(row * turn), 0.1);
    EXPECT_LT(std::abs(row * growth), 0.05 * std::abs(row * turn));
  }
}

TEST(ArcDerivatives, AgreeWithDifferences)
{
  const double coarse = OnDisk(0.1).Error();
  const double fine = OnDisk(0.025).Error();
  EXPECT_LT(coarse, 0.06); // measured: 0.039
  EXPECT_LT(fine, 0.03);   // measured: 0.018
  EXPECT_LT(fine, 0.7 * coarse);
}

TEST(ArcDerivatives, AgreeWithDifferencesAroundAnInnerLoop)
{
  // Symmetric about y = 0, so that the inner loop has no defect, but for a millionth: separatrices
  // of a symmetric mesh meet where those of a disturbed one pass each other.
  const PlanarDomain plate = { { { { -1.5, -1.0 }, { 1.5, -1.0 }, { 1.5, 1.0 }, { -1.5, 1.0 } },
    { { -0.2, -0.25 }, { -0.2, 0.25 }, { 0.3, 0.15 }, { 0.3, -0.15 } } } };
  const Configuration four = { { { -0.8, 0.45 }, 1 }, { { -0.8, -0.45 }, 1 }, { { 0.8, 0.4 }, -1 },
    { { 0.8, -0.400001 }, -1 } };
  const Derivatives derivatives(plate, four, 0.04, 0.25);
  EXPECT_LT(derivatives.Error(), 0.06); // measured: 0.043
  ASSERT_EQ(derivatives.formulaOfDefects.rows(), 1);
  EXPECT_LT((derivatives.formulaOfDefects - derivatives.differencesOfDefects).norm(),
    2e-3 * derivatives.differencesOfDefects.norm());
}
}
}
