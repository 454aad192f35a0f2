#include "BlockMatrix.h"

namespace crossfield
{
Eigen::Index BlockMatrix::Rows() const
{
  Eigen::Index rows = 0;
  for (const Eigen::MatrixXd& block : this->blocks)
  {
    rows += block.rows();
  }
  return rows;
}

double BlockMatrix::Trace() const
{
  double trace = 0.0;
  for (const Eigen::MatrixXd& block : this->blocks)
  {
    trace += block.trace();
  }
  return trace;
}

Eigen::MatrixXcd BlockMatrix::operator*(const Eigen::MatrixXcd& columns) const
{
  Eigen::MatrixXcd ofCoupled(this->coupling.rows(), columns.cols());
  Eigen::MatrixXcd product(columns.rows(), columns.cols());
  Eigen::Index row = 0;
  Eigen::Index place = 0;
  for (std::size_t i = 0; i < this->blocks.size(); ++i)
  {
    const Eigen::Index size = this->blocks[i].rows();
    product.middleRows(row, size) = this->blocks[i] * columns.middleRows(row, size);
    ofCoupled.middleRows(place, this->coupled[i]) =
      columns.middleRows(row + size - this->coupled[i], this->coupled[i]);
    row += size;
    place += this->coupled[i];
  }
  const Eigen::MatrixXcd across = this->coupling * ofCoupled;
  row = 0;
  place = 0;
  for (std::size_t i = 0; i < this->blocks.size(); ++i)
  {
    row += this->blocks[i].rows();
    product.middleRows(row - this->coupled[i], this->coupled[i]) +=
      across.middleRows(place, this->coupled[i]);
    place += this->coupled[i];
  }
  return product;
}
}
