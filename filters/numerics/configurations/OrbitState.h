#pragma once

#include "SiteOrbits.h"

#include <array>
#include <cmath>

namespace crossfield
{
/// A change of the indices of up to three orbits.
struct Move
{
  std::array<Eigen::Index, 3> orbits = {};
  std::array<int, 3> changes = {};
  int count = 0;
  double energy = 0.0; ///< Change of the form.
};

/// Indices of orbits while they change.
class OrbitState
{
public:
  explicit OrbitState(const OrbitForm& form)
    : Form(form)
    , Indices(Eigen::VectorXi::Zero(form.linear.size()))
    , Gradient(form.linear)
    , Blocked(Eigen::VectorXi::Zero(form.linear.size()))
    , Defects(form.defects)
    , Holonomy(this->HolonomyOf(form.defects))
  {
  }

  int Sum() const { return this->Total; }
  const Eigen::VectorXi& GetIndices() const { return this->Indices; }
  /// Returns the form with the energy of the defects, and with the changes of the costs of nodes so far.
  double Energy() const { return this->Value + this->Holonomy; }

  bool Allows(Eigen::Index orbit, int change) const
  {
    return std::abs(this->Indices[orbit] + change) <= this->Form.limits[orbit];
  }

  /// Returns the change of the form and of the cost of nodes by a single change, without that of the defects.
  double Single(Eigen::Index orbit, int change) const
  {
    return change * this->Gradient[orbit] +
      0.5 * change * change * this->Form.matrix(orbit, orbit) +
      this->Form.nodeCost * this->NodeChange(orbit, change);
  }

  bool Allows(const Move& move) const
  {
    for (int a = 0; a < move.count; ++a)
    {
      if (!this->Allows(move.orbits[a], move.changes[a]))
      {
        return false;
      }
    }
    return true;
  }

  /// Returns the change of the sum of the absolute values of all indices.
  int NodeChange(const Move& move) const
  {
    int change = 0;
    for (int a = 0; a < move.count; ++a)
    {
      change += this->NodeChange(move.orbits[a], move.changes[a]);
    }
    return change;
  }
  int NodeChange(Eigen::Index orbit, int change) const
  {
    const int index = this->Indices[orbit];
    return this->Form.sizes[orbit] * (std::abs(index + change) - std::abs(index));
  }

  /// Returns the change of the form by a move, with the cost of nodes.
  double ChangeBy(const Move& move) const
  {
    double change = 0.0;
    for (int a = 0; a < move.count; ++a)
    {
      change += this->Single(move.orbits[a], move.changes[a]);
      for (int b = 0; b < a; ++b)
      {
        change +=
          move.changes[a] * move.changes[b] * this->Form.matrix(move.orbits[a], move.orbits[b]);
      }
    }
    return change;
  }

  /// Returns whether the sites that a move occupies are free.
  bool IsFree(const Move& move) const
  {
    for (int a = 0; a < move.count; ++a)
    {
      const Eigen::Index orbit = move.orbits[a];
      if (this->Indices[orbit] != 0 || move.changes[a] == 0)
      {
        continue;
      }
      int blocked = this->Blocked[orbit];
      for (int b = 0; b < move.count; ++b)
      {
        const Eigen::Index other = move.orbits[b];
        if (b == a || this->Form.isNear(orbit, other) == 0)
        {
          continue;
        }
        const bool was = this->Indices[other] != 0;
        const bool is = this->Indices[other] + move.changes[b] != 0;
        blocked += is ? (was ? 0 : 1) : (was ? -1 : 0);
      }
      if (blocked > 0)
      {
        return false;
      }
    }
    return true;
  }

  /// Returns the change of the energy of the defects.
  double HolonomyChange(const Move& move) const
  {
    if (this->Defects.size() == 0)
    {
      return 0.0;
    }
    Eigen::VectorXd defects = this->Defects;
    for (int a = 0; a < move.count; ++a)
    {
      defects += move.changes[a] * this->Form.defectChanges.col(move.orbits[a]);
    }
    return this->HolonomyOf(defects) - this->Holonomy;
  }

  void Make(const Move& move)
  {
    this->Value += move.energy;
    for (int a = 0; a < move.count; ++a)
    {
      const Eigen::Index orbit = move.orbits[a];
      const int change = move.changes[a];
      this->Gradient += change * this->Form.matrix.col(orbit);
      this->Defects += change * this->Form.defectChanges.col(orbit);
      this->Total += change * this->Form.sizes[orbit];
      const bool was = this->Indices[orbit] != 0;
      this->Indices[orbit] += change;
      const bool is = this->Indices[orbit] != 0;
      if (was != is)
      {
        this->Blocked += (is ? 1 : -1) * this->Form.isNear.col(orbit).cast<int>();
      }
    }
    this->Holonomy = this->HolonomyOf(this->Defects);
  }

private:
  double HolonomyOf(const Eigen::VectorXd& defects) const
  {
    if (defects.size() == 0)
    {
      return 0.0;
    }
    const Eigen::VectorXd wrapped =
      defects.unaryExpr([](double defect) { return WrapAngle(defect); });
    return 0.5 * wrapped.dot(this->Form.defectEnergy * wrapped);
  }

  const OrbitForm& Form;
  Eigen::VectorXi Indices;
  Eigen::VectorXd Gradient;
  Eigen::VectorXi Blocked;
  Eigen::VectorXd Defects;
  double Holonomy;
  double Value = 0.0;
  int Total = 0;
};
}
