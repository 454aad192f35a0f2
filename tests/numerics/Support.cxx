#include "Support.h"

#include "BuiltinDomains.h"
#include "MakePlanarDomain.h"
#include "PoincareHopf.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace crossfield::test
{
namespace
{
double DistanceToSegment(const Point& point, const Point& from, const Point& to)
{
  const Point along = to - from;
  const double t = std::clamp((point - from).dot(along) / along.squaredNorm(), 0.0, 1.0);
  return (point - from - t * along).norm();
}
}

double Random::Uniform(double lower, double upper)
{
  return lower + (upper - lower) * (static_cast<double>(this->Engine()) / 4294967296.0);
}

int Random::Integer(int lower, int upper)
{
  return lower + static_cast<int>(this->Engine() % static_cast<std::uint32_t>(upper - lower + 1));
}

Complex Random::Square()
{
  const double real = this->Uniform(-1.0, 1.0);
  return { real, this->Uniform(-1.0, 1.0) };
}

Complex Random::UnitComplex()
{
  return std::polar(1.0, this->Uniform(-Pi, Pi));
}

Point Similarity::operator()(const Point& point) const
{
  const double c = std::cos(this->angle);
  const double s = std::sin(this->angle);
  return this->scale * Point(c * point.x() - s * point.y(), s * point.x() + c * point.y()) +
    this->shift;
}

Loop Similarity::operator()(const Loop& loop) const
{
  Loop result;
  for (const Point& point : loop)
  {
    result.push_back((*this)(point));
  }
  return result;
}

std::vector<Loop> Similarity::operator()(const std::vector<Loop>& loops) const
{
  std::vector<Loop> result;
  for (const Loop& loop : loops)
  {
    result.push_back((*this)(loop));
  }
  return result;
}

PlanarDomain Similarity::operator()(const PlanarDomain& domain) const
{
  return PlanarDomain{ (*this)(domain.loops) };
}

Configuration Similarity::operator()(const Configuration& configuration) const
{
  Configuration result = configuration;
  for (Singularity& singularity : result)
  {
    singularity.position = (*this)(singularity.position);
    singularity.radius *= this->scale;
  }
  return result;
}

TriangleMesh Similarity::operator()(const TriangleMesh& mesh) const
{
  TriangleMesh result = mesh;
  result.points = (*this)(mesh.points);
  return result;
}

Eigen::MatrixXd RandomMatrix(Random& random, Eigen::Index rows, Eigen::Index columns)
{
  return Eigen::MatrixXd::NullaryExpr(rows, columns, [&] { return random.Uniform(-1.0, 1.0); });
}

bool AnyHas(const std::vector<std::string>& sentences, const std::string& words)
{
  return std::any_of(sentences.begin(), sentences.end(),
    [&words](const std::string& sentence) { return sentence.find(words) != std::string::npos; });
}

Loop RegularPolygon(int count, double radius, const Point& centre)
{
  Loop loop;
  for (int i = 0; i < count; ++i)
  {
    const double angle = 2.0 * Pi * i / count;
    loop.push_back(centre + radius * Point(std::cos(angle), std::sin(angle)));
  }
  return loop;
}

PlanarDomain RandomSmoothDomain(Random& random, int pointCount)
{
  constexpr int Harmonics = 5;
  double cosines[Harmonics];
  double sines[Harmonics];
  for (int k = 0; k < Harmonics; ++k)
  {
    // Decreasing as 1 / k², so that the curvature stays moderate.
    const double size = 0.25 / ((k + 1) * (k + 1));
    cosines[k] = random.Uniform(-size, size);
    sines[k] = random.Uniform(-size, size);
  }
  Loop loop;
  for (int i = 0; i < pointCount; ++i)
  {
    const double angle = 2.0 * Pi * i / pointCount;
    double radius = 1.0;
    for (int k = 0; k < Harmonics; ++k)
    {
      radius += cosines[k] * std::cos((k + 1) * angle) + sines[k] * std::sin((k + 1) * angle);
    }
    loop.emplace_back(radius * std::cos(angle), radius * std::sin(angle));
  }
  return MakePlanarDomain({ loop });
}

Configuration RandomHoles(Random& random, const PlanarDomain& domain, int count)
{
  Configuration holes;
  while (static_cast<int>(holes.size()) < count)
  {
    // The domain is star-shaped, so a boundary point moved towards the origin is inside.
    const Loop& outer = domain.loops.front();
    const auto i = static_cast<std::size_t>(random.Integer(0, static_cast<int>(outer.size()) - 1));
    Singularity hole;
    hole.position = std::sqrt(random.Uniform(0.0, 0.9)) * outer[i];
    hole.radius = std::exp(random.Uniform(std::log(0.01), std::log(0.08)));
    hole.quarterIndex = random.Integer(-2, 2);
    const bool fits = DistanceToLoop(hole.position, outer) > 2.0 * hole.radius &&
      std::all_of(holes.begin(), holes.end(),
        [&](const Singularity& other)
        {
          return (other.position - hole.position).norm() >
            other.radius + hole.radius + std::min(other.radius, hole.radius);
        });
    if (fits)
    {
      holes.push_back(hole);
    }
  }
  return holes;
}

PlanarDomain Builtin(const std::string& name, double edgeLength)
{
  BuiltinDomain domain;
  domain.name = name;
  domain.edgeLength = edgeLength;
  return MakePlanarDomain(MakeBuiltinDomain(domain));
}

TriangleMesh DrillMesh(
  const PlanarDomain& domain, const Configuration& configuration, double meshSize, DrillMode mode)
{
  DrillOptions options;
  options.meshSize = meshSize;
  options.mode = mode;
  return DrillHoles(domain, configuration, options);
}

double DistanceToLoop(const Point& point, const Loop& loop)
{
  double distance = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < loop.size(); ++i)
  {
    distance = std::min(distance, DistanceToSegment(point, loop[i], loop[(i + 1) % loop.size()]));
  }
  return distance;
}

Configuration OnCircle(
  int count, double circleRadius, double firstAngle, int quarterIndex, double holeRadius)
{
  Configuration result;
  for (int i = 0; i < count; ++i)
  {
    const double angle = firstAngle + 2.0 * Pi * i / count;
    result.push_back(
      { circleRadius * Point(std::cos(angle), std::sin(angle)), quarterIndex, holeRadius });
  }
  return result;
}

Configuration Join(Configuration first, const Configuration& second)
{
  first.insert(first.end(), second.begin(), second.end());
  return first;
}

PlanarDomain LShape()
{
  return MakePlanarDomain(
    { { { 0.0, 0.0 }, { 2.0, 0.0 }, { 2.0, 1.0 }, { 1.0, 1.0 }, { 1.0, 2.0 }, { 0.0, 2.0 } } });
}

PlanarDomain DiskOfEdges(double edge)
{
  return MakePlanarDomain({ RegularPolygon(static_cast<int>(2.0 * Pi / edge)) });
}

PlanarDomain RingOfEdges(double edge)
{
  return MakePlanarDomain({ RegularPolygon(static_cast<int>(2.0 * Pi / edge)),
    RegularPolygon(static_cast<int>(0.8 * Pi / edge), 0.4) });
}

Singularity OnTheCircle(double angle, int quarterIndex)
{
  return { { std::cos(angle), std::sin(angle) }, quarterIndex, 0.0 };
}

OnPolygonOfDisk PutOnPolygon(
  int count, double angle, const Configuration& configuration, Place place)
{
  const Similarity turn{ angle, 1.0, Point::Zero() };
  OnPolygonOfDisk result{ { { turn(RegularPolygon(count)) } }, configuration, configuration };
  for (std::size_t i = 0; i < configuration.size(); ++i)
  {
    Point& exact = result.exact[i].position;
    if (exact.norm() < 0.999)
    {
      continue;
    }
    const double step = 2.0 * Pi / count;
    const double found = (std::atan2(exact.y(), exact.x()) - angle) / step;
    const double sides = place == Place::Vertex ? std::round(found)
      : place == Place::Middle                  ? std::floor(found) + 0.5
                                                : found;
    const double middle = angle + step * (std::floor(sides) + 0.5);
    exact = { std::cos(angle + step * sides), std::sin(angle + step * sides) };
    result.given[i].position = exact;
    if (place != Place::Vertex)
    {
      // The orthogonal projection of the point of the circle onto the side.
      const Point normal(std::cos(middle), std::sin(middle));
      result.given[i].position += (std::cos(0.5 * step) - exact.dot(normal)) * normal;
    }
  }
  return result;
}

double ConvergenceRate(const std::vector<double>& sizes, const std::vector<double>& errors)
{
  double meanX = 0.0;
  double meanY = 0.0;
  const auto count = static_cast<double>(sizes.size());
  for (std::size_t i = 0; i < sizes.size(); ++i)
  {
    meanX += std::log(sizes[i]) / count;
    meanY += std::log(errors[i]) / count;
  }
  double above = 0.0;
  double below = 0.0;
  for (std::size_t i = 0; i < sizes.size(); ++i)
  {
    const double x = std::log(sizes[i]) - meanX;
    above += x * (std::log(errors[i]) - meanY);
    below += x * x;
  }
  return above / below;
}

testing::AssertionResult Refuses(
  const std::function<void()>& call, const std::vector<std::string>& parts, Error::Kind kind)
{
  try
  {
    call();
  }
  catch (const Error& error)
  {
    const std::string sentence = error.what();
    for (const std::string& part : parts)
    {
      if (sentence.find(part) == std::string::npos)
      {
        return testing::AssertionFailure() << "'" << sentence << "' does not say '" << part << "'";
      }
    }
    if (error.GetKind() != kind)
    {
      return testing::AssertionFailure() << "'" << sentence << "' is an error of another kind";
    }
    return testing::AssertionSuccess();
  }
  catch (const std::exception& error)
  {
    return testing::AssertionFailure() << "threw something else: " << error.what();
  }
  return testing::AssertionFailure() << "threw nothing";
}

int Required(const PlanarDomain& domain, const std::vector<CornerChoice>& corners)
{
  return CountQuarters(domain.loops, 0, DefaultCornerAngle, corners).requiredInteriorQuarters;
}

PotentialProblem ProblemOn(const TriangleMesh& mesh, const std::vector<CornerChoice>& corners)
{
  const auto potential = std::make_shared<const PotentialSolver>(ShareTopology(mesh));
  return { potential, AlignWithBoundary(potential->GetTopology(), corners) };
}

PointPotential PointPotentialOn(
  const TriangleMesh& mesh, const std::vector<CornerChoice>& corners, int pointQuarters)
{
  const auto potential = std::make_shared<const PotentialSolver>(ShareTopology(mesh));
  return { potential, AlignWithBoundary(potential->GetTopology(), corners, pointQuarters) };
}
}
