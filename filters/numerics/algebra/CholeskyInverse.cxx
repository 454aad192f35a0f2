#include "CholeskyInverse.h"

#include "SerialBlas.h"

// The Fortran interface of LAPACK; see DenseCholesky.
extern "C" void dpotri_(const char* half, const int* size, double* matrix, const int* leading,
  int* info, std::size_t halfLength);

namespace crossfield
{
Eigen::MatrixXd CholeskyInverse(Eigen::MatrixXd lower)
{
  if (lower.size() > 0)
  {
    const SerialBlas serial;
    const auto size = static_cast<int>(lower.rows());
    int info = 0; // not 0 only for a zero on the diagonal
    dpotri_("L", &size, lower.data(), &size, &info, 1);
    lower.triangularView<Eigen::StrictlyUpper>() = lower.transpose();
  }
  return lower;
}
}
