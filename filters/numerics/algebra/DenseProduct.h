#pragma once

#include <Eigen/Core>

#include <complex>

namespace crossfield
{
/// A B by BLAS (dgemm): several times as fast as Eigen's product, which may use only what every processor has.
Eigen::MatrixXd DenseProduct(
  const Eigen::Ref<const Eigen::MatrixXd>& left, const Eigen::Ref<const Eigen::MatrixXd>& right);

/// Aᴴ B, likewise.
Eigen::MatrixXd AdjointProduct(
  const Eigen::Ref<const Eigen::MatrixXd>& left, const Eigen::Ref<const Eigen::MatrixXd>& right);
Eigen::MatrixXcd AdjointProduct(
  const Eigen::Ref<const Eigen::MatrixXcd>& left, const Eigen::Ref<const Eigen::MatrixXcd>& right);

/// y becomes y + factor × x (zaxpy).
void AddMultiple(std::complex<double> factor, const Eigen::Ref<const Eigen::VectorXcd>& x,
  Eigen::Ref<Eigen::VectorXcd> y);

/// B becomes L⁻¹ B, by BLAS (dtrsm); only the lower half of L is read.
void SolveLowerInPlace(
  const Eigen::Ref<const Eigen::MatrixXd>& lower, Eigen::Ref<Eigen::MatrixXd> columns);
}
