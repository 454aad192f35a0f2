#pragma once

#include <Eigen/Core>

#include <complex>

namespace crossfield
{
/// Returns A B, computed by BLAS (dgemm). BLAS is several times as fast as Eigen, which is compiled
/// for the instructions that every processor has.
Eigen::MatrixXd DenseProduct(
  const Eigen::Ref<const Eigen::MatrixXd>& left, const Eigen::Ref<const Eigen::MatrixXd>& right);

/// Returns Aᴴ B, computed by BLAS.
Eigen::MatrixXd AdjointProduct(
  const Eigen::Ref<const Eigen::MatrixXd>& left, const Eigen::Ref<const Eigen::MatrixXd>& right);
Eigen::MatrixXcd AdjointProduct(
  const Eigen::Ref<const Eigen::MatrixXcd>& left, const Eigen::Ref<const Eigen::MatrixXcd>& right);

/// Replaces y by y + factor × x (zaxpy).
void AddMultiple(std::complex<double> factor, const Eigen::Ref<const Eigen::VectorXcd>& x,
  Eigen::Ref<Eigen::VectorXcd> y);

/// Replaces B by L⁻¹ B, or by L⁻ᵀ B, computed by BLAS (dtrsm). Only the lower triangle of L is read.
void SolveLowerInPlace(
  const Eigen::Ref<const Eigen::MatrixXd>& lower, Eigen::Ref<Eigen::MatrixXd> columns);
void SolveLowerAdjointInPlace(
  const Eigen::Ref<const Eigen::MatrixXd>& lower, Eigen::Ref<Eigen::MatrixXd> columns);
}
