#include "LagrangeQuad.h"

#include <cmath>

namespace crossfield
{
namespace
{
/// Gauss points of the interval [0, 1]: three for order 2, four for order 3.
std::vector<double> GaussPoints(int count)
{
  if (count == 3)
  {
    const double a = 0.5 * std::sqrt(0.6);
    return { 0.5 - a, 0.5, 0.5 + a };
  }
  const double root = 2.0 / 7.0 * std::sqrt(1.2);
  const double a = 0.5 * std::sqrt(3.0 / 7.0 - root);
  const double b = 0.5 * std::sqrt(3.0 / 7.0 + root);
  return { 0.5 - b, 0.5 - a, 0.5 + a, 0.5 + b };
}

/// Returns the value of the Lagrange polynomial of node i at x, for nodes k / order.
double Value(int i, int order, double x)
{
  double value = 1.0;
  for (int k = 0; k <= order; ++k)
  {
    value *= k == i ? 1.0 : (x * order - k) / (i - k);
  }
  return value;
}

double Derivative(int i, int order, double x)
{
  double sum = 0.0;
  for (int k = 0; k <= order; ++k)
  {
    double product = k == i ? 0.0 : static_cast<double>(order) / (i - k);
    for (int m = 0; m <= order && k != i; ++m)
    {
      product *= m == i || m == k ? 1.0 : (x * order - m) / (i - m);
    }
    sum += product;
  }
  return sum;
}
}

LagrangeQuad::LagrangeQuad(int order)
  : AlongFirst((order + 1) * (order + 1), (order + 1) * (order + 1))
  , AlongSecond(this->AlongFirst.rows(), this->AlongFirst.cols())
{
  const std::vector<double> gauss = GaussPoints(order + 1);
  Eigen::Index column = 0;
  for (const double y : gauss)
  {
    for (const double x : gauss)
    {
      for (int j = 0; j <= order; ++j)
      {
        for (int i = 0; i <= order; ++i)
        {
          const Eigen::Index row = j * (order + 1) + i;
          this->AlongFirst(row, column) = Derivative(i, order, x) * Value(j, order, y);
          this->AlongSecond(row, column) = Value(i, order, x) * Derivative(j, order, y);
        }
      }
      ++column;
    }
  }
}

LagrangeQuad::Range LagrangeQuad::MeasureJacobian(const Eigen::Matrix2Xd& nodes) const
{
  const Eigen::Matrix2Xd first = nodes * this->AlongFirst;
  const Eigen::Matrix2Xd second = nodes * this->AlongSecond;
  const Eigen::ArrayXd determinants =
    first.row(0).array() * second.row(1).array() - first.row(1).array() * second.row(0).array();
  return { determinants.minCoeff(), determinants.maxCoeff() };
}
}
