#include "SmoothCrosses.h"

#include "DissectedCholesky.h"
#include "SymmetricAssembly.h"

#include <array>
#include <cmath>

namespace crossfield
{
namespace
{
/// The energy E: its matrix, without the diagonal, and b. Unknowns 2t and 2t + 1 are the parts of z on triangle t.
class CrossEnergy
{
public:
  explicit CrossEnergy(const MeshTopology& topology)
    : Areas(2 * topology.TriangleCount())
    , Diagonal(Eigen::VectorXd::Zero(this->Areas.size()))
    , Boundary(Eigen::VectorXd::Zero(this->Areas.size()))
  {
    for (int t = 0; t < topology.TriangleCount(); ++t)
    {
      this->Areas.segment<2>(2 * t).setConstant(topology.AreaOf(t));
      const auto& v = topology.mesh.triangles[t];
      const SpacePoint centre =
        (topology.PositionOf(v[0]) + topology.PositionOf(v[1]) + topology.PositionOf(v[2])) / 3.0;
      this->Places.insert(this->Places.end(), 2, centre);
      this->Partners.insert(this->Partners.end(), { 2 * t + 1, 2 * t });
    }
    for (int t = 0; t < topology.TriangleCount(); ++t)
    {
      for (int side = 0; side < 3; ++side)
      {
        this->AddSide(topology, t, side);
      }
    }
  }

  /// Returns the factor of M + τ E.
  DissectedCholesky FactorFor(double time, const Progress& progress) const
  {
    std::vector<SymmetricEntry> entries = this->Entries;
    for (SymmetricEntry& entry : entries)
    {
      entry.value *= time;
    }
    return { AssembleSymmetric(this->Areas + time * this->Diagonal, entries), this->Places, {}, {},
      progress, this->Partners };
  }

  /// Returns M z + τ b.
  Eigen::VectorXd SourceOf(const Eigen::VectorXd& z, double time) const
  {
    return this->Areas.cwiseProduct(z) + time * this->Boundary;
  }

  Eigen::Index Size() const { return this->Areas.size(); }

private:
  void AddSide(const MeshTopology& topology, int t, int side)
  {
    const int other = topology.Neighbour(t, side);
    if (other > t)
    {
      return; // from the other side
    }
    const double length = topology.Length(topology.EdgeOf(t, side));
    const double area = topology.AreaOf(t) + (other < 0 ? 0.0 : topology.AreaOf(other));
    const double weight = 1.5 * length * length / area;
    this->Diagonal.segment<2>(2 * t).array() += weight;
    if (other < 0)
    {
      const double direction = 4.0 * topology.DirectionOf(t, side);
      this->Boundary.segment<2>(2 * t) += weight * Point(std::cos(direction), std::sin(direction));
      return;
    }
    this->Diagonal.segment<2>(2 * other).array() += weight;
    const double turn = 4.0 * topology.Hinge(t, side);
    const double cosine = weight * std::cos(turn);
    const double sine = weight * std::sin(turn);
    this->Entries.push_back({ 2 * other, 2 * t, -cosine });
    this->Entries.push_back({ 2 * other, 2 * t + 1, sine });
    this->Entries.push_back({ 2 * other + 1, 2 * t, -sine });
    this->Entries.push_back({ 2 * other + 1, 2 * t + 1, -cosine });
  }

  Eigen::VectorXd Areas;
  Eigen::VectorXd Diagonal;
  Eigen::VectorXd Boundary;
  std::vector<SymmetricEntry> Entries;
  std::vector<SpacePoint> Places;
  std::vector<int> Partners;
};

/// Returns z with unit length on every triangle.
Eigen::VectorXd Unit(Eigen::VectorXd z)
{
  for (Eigen::Index i = 0; i < z.size(); i += 2)
  {
    const double length = z.segment<2>(i).norm();
    z.segment<2>(i) = length > 0.0 ? Point(z.segment<2>(i) / length) : Point(1.0, 0.0);
  }
  return z;
}

Eigen::VectorXd Solve(const DissectedCholesky& factor, const Eigen::VectorXd& source)
{
  return factor.Substitute(factor.Eliminate(source));
}
}

Eigen::VectorXd SmoothCrosses(const MeshTopology& topology, const Progress& progress)
{
  const CrossEnergy energy(topology);
  const double area = topology.Area();
  const bool isClosed = topology.loops.empty();
  Eigen::VectorXd z = Eigen::VectorXd::Zero(energy.Size());
  {
    // A long time leaves the minimum; on a closed surface, what is left of any start is the least eigenvector.
    const double longTime = 10.0 * area;
    constexpr int Steps = 20; // enough for a start, which the short times below change
    const DissectedCholesky factor = energy.FactorFor(longTime, progress.Part(0.0, 0.2));
    if (isClosed)
    {
      z = Unit(z);
    }
    for (int step = 0; step < Steps; ++step)
    {
      z = Solve(factor, energy.SourceOf(z, longTime));
      if (isClosed)
      {
        z /= z.lpNorm<Eigen::Infinity>();
      }
    }
  }
  // Diffusion lengths relative to the root of the area: from long to short ones, so that few singularities are left.
  constexpr std::array<double, 4> Lengths = { 0.15, 0.08, 0.04, 0.02 };
  constexpr int StepsOfLength = 6; // the field hardly changes after these
  double done = 0.2;
  for (const double length : Lengths)
  {
    const double time = length * length * area;
    const DissectedCholesky factor = energy.FactorFor(time, progress.Part(done, done + 0.2));
    done += 0.2;
    for (int step = 0; step < StepsOfLength; ++step)
    {
      z = Solve(factor, energy.SourceOf(Unit(z), time));
    }
  }
  Eigen::VectorXd angle(topology.TriangleCount());
  for (int t = 0; t < topology.TriangleCount(); ++t)
  {
    angle[t] = 0.25 * std::atan2(z[2 * t + 1], z[2 * t]);
  }
  progress.Report(1.0);
  return angle;
}
}
