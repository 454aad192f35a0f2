#include "SizeExtension.h"

#include "DissectedCholesky.h"
#include "P1Laplacian.h"
#include "TriangleArea.h"

#include <algorithm>
#include <cmath>

namespace crossfield
{
Eigen::VectorXd ExtendSizes(const PlanarTopology& topology, const Eigen::VectorXd& sizes)
{
  std::vector<int> boundary;
  Eigen::VectorXd logarithms = Eigen::VectorXd::Zero(sizes.size());
  for (const BoundaryEdge& edge : topology.mesh.boundary)
  {
    const int vertex = edge.vertices[0]; // every boundary vertex starts one edge
    boundary.push_back(vertex);
    logarithms[vertex] = std::log(sizes[vertex]);
  }
  std::sort(boundary.begin(), boundary.end());
  boundary.erase(std::unique(boundary.begin(), boundary.end()), boundary.end());
  const Eigen::SparseMatrix<double> stiffness = P1Stiffness(topology);
  const DissectedCholesky factor(stiffness, InSpace(topology.mesh.points), {}, boundary);
  // The correction is 0 at boundary vertices, which are not eliminated.
  logarithms += factor.Substitute(factor.Eliminate(-(stiffness * logarithms)));
  Eigen::VectorXd extended = logarithms.array().exp();
  for (const int vertex : boundary)
  {
    extended[vertex] = sizes[vertex];
  }
  return extended;
}

double EquivalentSize(const TriangleMesh& mesh, const Eigen::VectorXd& sizes)
{
  double area = 0.0;
  double count = 0.0;
  for (const std::array<int, 3>& triangle : mesh.triangles)
  {
    const double part = TriangleArea(mesh, triangle) / 3.0;
    for (const int vertex : triangle)
    {
      area += part;
      count += part / (sizes[vertex] * sizes[vertex]);
    }
  }
  return std::sqrt(area / count);
}
}
