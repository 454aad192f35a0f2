#pragma once

#include <Eigen/SparseCore>

#include <cholmod.h>

#include <memory>
#include <vector>

namespace crossfield
{
/// Workspace of CHOLMOD for one analysis, factorisation or solve, with the options for matrices of
/// planar meshes in a given order. CHOLMOD writes its status and memory statistics into it, so
/// concurrent solves with one factor need one workspace each.
class CholmodWorkspace
{
public:
  CholmodWorkspace()
  {
    cholmod_start(&this->Common);
    this->Common.print = 0; // errors are thrown, not printed
    this->Common.supernodal = CHOLMOD_SUPERNODAL;
    this->Common.final_ll = 1;
    this->Common.nmethods = 1;
    this->Common.method[0].ordering = CHOLMOD_GIVEN;
    // A postorder would move trailing unknowns when the other part of the matrix is disconnected.
    this->Common.postorder = 0;
    // Always merge supernodes of up to 16 columns, and those of up to 32 and 64 columns if this
    // adds few zeros. Planar meshes have small supernodes, and fewer BLAS calls save a tenth of the
    // time (CHOLMOD's defaults: 4, 16, 48).
    this->Common.nrelax[0] = 16;
    this->Common.nrelax[1] = 32;
    this->Common.nrelax[2] = 64;
  }
  ~CholmodWorkspace() { cholmod_finish(&this->Common); }
  CholmodWorkspace(const CholmodWorkspace&) = delete;
  CholmodWorkspace& operator=(const CholmodWorkspace&) = delete;

  cholmod_common* Get() { return &this->Common; }

private:
  cholmod_common Common{};
};

/// Releases a factor with the workspace that made it, which must still exist.
struct ReleaseFactor
{
  cholmod_common* common = nullptr;
  void operator()(cholmod_factor* factor) const { cholmod_free_factor(&factor, this->common); }
};
using CholmodFactor = std::unique_ptr<cholmod_factor, ReleaseFactor>;

/// Throws Error when an entry of a matrix is not finite.
void RequireFinite(const Eigen::SparseMatrix<double>& matrix);

/// Factors a compressed matrix, of which only the lower triangle is read, in the order `order`, or
/// in the order of its rows if `order` is null. Stops at the first pivot that is not positive;
/// factor->minor is its column, or the number of columns if there is none. All supernodes before it
/// are valid then. Throws Error when there is not enough memory or the factor has too many entries.
CholmodFactor FactorInOrder(const Eigen::SparseMatrix<double>& matrix, CholmodWorkspace& workspace,
  const std::vector<int>* order = nullptr);

/// Replaces the values of a factor by those of another matrix with the same places of entries, in
/// the same order.
void FactorAgain(
  const Eigen::SparseMatrix<double>& matrix, CholmodWorkspace& workspace, cholmod_factor& factor);
}
