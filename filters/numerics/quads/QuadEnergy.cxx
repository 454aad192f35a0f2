#include "QuadEnergy.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace crossfield
{
namespace
{
std::size_t Index(int i)
{
  return static_cast<std::size_t>(i);
}

/// The sides of a quad's corner over the wanted lengths, the columns of J.
struct CornerFrame
{
  Point next;
  Point previous;
  double nextLength;
  double previousLength;
  int at;
  int to;
  int from;

  double Determinant() const { return Cross(this->next, this->previous); }
};

CornerFrame FrameAt(const QuadMesh& mesh, std::size_t quad, std::size_t corner)
{
  const auto& points = mesh.quads[quad];
  CornerFrame frame{};
  frame.at = points[corner];
  frame.to = points[(corner + 1) % 4];
  frame.from = points[(corner + 3) % 4];
  frame.nextLength = mesh.wanted[quad][corner % 2];
  frame.previousLength = mesh.wanted[quad][(corner + 1) % 2];
  const Point& place = mesh.points[Index(frame.at)].place;
  frame.next = (mesh.points[Index(frame.to)].place - place) / frame.nextLength;
  frame.previous = (mesh.points[Index(frame.from)].place - place) / frame.previousLength;
  return frame;
}
}

QuadEnergy::QuadEnergy(
  QuadMesh& mesh, const BoundaryCurves& curves, bool releaseCones, double sizePart)
  : Mesh(mesh)
  , Curves(curves)
  , SizePart(sizePart)
{
  for (const QuadPoint& point : mesh.points)
  {
    const bool inside = point.curve.loop < 0;
    const bool free = !point.fixed || (releaseCones && inside);
    this->First.push_back(free ? this->Count : -1);
    this->Count += free ? (inside ? 2 : 1) : 0;
  }
  this->Diagonal = Eigen::VectorXd::Zero(this->Count);
  for (std::size_t q = 0; q < mesh.quads.size(); ++q)
  {
    const double curvature =
      1.0 / (mesh.wanted[q][0] * mesh.wanted[q][0]) + 1.0 / (mesh.wanted[q][1] * mesh.wanted[q][1]);
    for (const int p : mesh.quads[q])
    {
      const Eigen::Index first = this->First[Index(p)];
      if (first >= 0)
      {
        this->Diagonal.segment(first, mesh.points[Index(p)].curve.loop < 0 ? 2 : 1).array() +=
          4.0 * curvature;
      }
    }
  }
}

Eigen::VectorXd QuadEnergy::Unknowns() const
{
  Eigen::VectorXd unknowns(this->Count);
  for (std::size_t p = 0; p < this->First.size(); ++p)
  {
    const QuadPoint& point = this->Mesh.points[p];
    if (this->First[p] >= 0 && point.curve.loop < 0)
    {
      unknowns.segment<2>(this->First[p]) = point.place;
    }
    else if (this->First[p] >= 0)
    {
      unknowns[this->First[p]] = point.curve.at;
    }
  }
  return unknowns;
}

void QuadEnergy::Move(const Eigen::VectorXd& unknowns)
{
  for (std::size_t p = 0; p < this->First.size(); ++p)
  {
    QuadPoint& point = this->Mesh.points[p];
    if (this->First[p] >= 0 && point.curve.loop < 0)
    {
      point.place = unknowns.segment<2>(this->First[p]);
    }
    else if (this->First[p] >= 0)
    {
      point.curve.at = unknowns[this->First[p]];
      point.place = this->Curves.At(point.curve);
    }
  }
}

double QuadEnergy::Value(double epsilon, Eigen::VectorXd* gradient) const
{
  double energy = 0.0;
  std::vector<Point> forces;
  if (gradient != nullptr)
  {
    forces.assign(this->Mesh.points.size(), Point::Zero());
  }
  for (std::size_t q = 0; q < this->Mesh.quads.size(); ++q)
  {
    for (std::size_t c = 0; c < 4; ++c)
    {
      const CornerFrame frame = FrameAt(this->Mesh, q, c);
      const double determinant = frame.Determinant();
      if (epsilon <= 0.0 && determinant <= 0.0)
      {
        return std::numeric_limits<double>::infinity();
      }
      const double root = std::sqrt(determinant * determinant + epsilon * epsilon);
      const double chi = 0.5 * (determinant + root);
      const double top =
        (1.0 - this->SizePart) * (frame.next.squaredNorm() + frame.previous.squaredNorm()) +
        this->SizePart * (determinant * determinant + 1.0);
      energy += top / chi;
      if (gradient != nullptr)
      {
        const double slope = 0.5 * (1.0 + determinant / root);
        const double byDeterminant =
          2.0 * this->SizePart * determinant / chi - top * slope / (chi * chi);
        const double byNorm = 2.0 * (1.0 - this->SizePart) / chi;
        // ∂ Cross(n, p) = (p_y, −p_x) by n and (−n_y, n_x) by p.
        const Point byNext =
          (byNorm * frame.next + byDeterminant * Point(frame.previous.y(), -frame.previous.x())) /
          frame.nextLength;
        const Point byPrevious =
          (byNorm * frame.previous + byDeterminant * Point(-frame.next.y(), frame.next.x())) /
          frame.previousLength;
        forces[Index(frame.to)] += byNext;
        forces[Index(frame.from)] += byPrevious;
        forces[Index(frame.at)] -= byNext + byPrevious;
      }
    }
  }
  if (gradient != nullptr)
  {
    gradient->resize(this->Count);
    for (std::size_t p = 0; p < this->First.size(); ++p)
    {
      const QuadPoint& point = this->Mesh.points[p];
      if (this->First[p] >= 0 && point.curve.loop < 0)
      {
        gradient->segment<2>(this->First[p]) = forces[p];
      }
      else if (this->First[p] >= 0)
      {
        (*gradient)[this->First[p]] = forces[p].dot(this->Curves.Tangent(point.curve));
      }
    }
  }
  return energy;
}

double QuadEnergy::LeastDeterminant() const
{
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t q = 0; q < this->Mesh.quads.size(); ++q)
  {
    for (std::size_t c = 0; c < 4; ++c)
    {
      least = std::min(least, FrameAt(this->Mesh, q, c).Determinant());
    }
  }
  return least;
}
}
