#include "ExactFields.h"

#include <cmath>

namespace crossfield::test
{
namespace
{
using Complex = std::complex<double>;

Complex ToComplex(const Point& point)
{
  return { point.x(), point.y() };
}
}

bool IsOnCircle(const Singularity& singularity)
{
  return singularity.position.norm() > 1.0 - 1e-9;
}

double ExactEnergyOnDisk(const Configuration& configuration)
{
  double energy = 0.0;
  for (std::size_t i = 0; i < configuration.size(); ++i)
  {
    const Complex b = ToComplex(configuration[i].position);
    for (std::size_t j = 0; j < configuration.size(); ++j)
    {
      const Complex c = ToComplex(configuration[j].position);
      const double degrees = configuration[i].quarterIndex * configuration[j].quarterIndex;
      const bool own = i == j;
      energy -= Pi * degrees * (own ? 0.0 : std::log(std::abs(b - c)));
      energy -= Pi * degrees *
        (own && IsOnCircle(configuration[i]) ? 0.0 : std::log(std::abs(1.0 - b * std::conj(c))));
    }
  }
  return energy;
}

Point DiskImage::operator()(Complex z) const
{
  const Complex image = z + this->a * std::pow(z, this->n);
  return { image.real(), image.imag() };
}

Configuration DiskImage::operator()(const Configuration& preimages) const
{
  Configuration images = preimages;
  for (Singularity& singularity : images)
  {
    singularity.position = (*this)(ToComplex(singularity.position));
  }
  return images;
}

Complex DiskImage::Slope(Complex z) const
{
  return 1.0 + static_cast<double>(this->n) * this->a * std::pow(z, this->n - 1);
}

Complex DiskImage::Preimage(const Point& point) const
{
  const Complex image = ToComplex(point);
  Complex z = image;
  for (int i = 0; i < 30; ++i)
  {
    z -= (z + this->a * std::pow(z, this->n) - image) / this->Slope(z);
  }
  return z;
}

Loop DiskImage::Polygon(int count, double radius) const
{
  Loop loop;
  for (int i = 0; i < count; ++i)
  {
    loop.push_back((*this)(std::polar(radius, 2.0 * Pi * i / count)));
  }
  return loop;
}

double DiskImage::PhiAt(const Configuration& preimages, const Point& point) const
{
  const Complex z = this->Preimage(point);
  double value = 4.0 * std::log(std::abs(this->Slope(z)));
  for (const Singularity& singularity : preimages)
  {
    const Complex b = ToComplex(singularity.position);
    value += singularity.quarterIndex * std::log(std::abs((z - b) * (1.0 - std::conj(b) * z)));
  }
  return value;
}

Complex DiskImage::CrossAt(const Configuration& preimages, const Point& point) const
{
  const Complex z = this->Preimage(point);
  const Complex slope = this->Slope(z);
  Complex u = std::pow(slope / std::abs(slope), 4);
  for (const Singularity& singularity : preimages)
  {
    const Complex b = ToComplex(singularity.position);
    const Complex turn = (z - b) * (1.0 - std::conj(b) * z);
    u *= std::pow(turn / std::abs(turn), singularity.quarterIndex);
  }
  return u;
}

double DiskImage::Energy(const Configuration& preimages) const
{
  const double factor = this->n * std::abs(this->a);
  double energy =
    ExactEnergyOnDisk(preimages) - 8.0 * Pi * (this->n - 1) * std::log(1.0 - factor * factor);
  for (const Singularity& singularity : preimages)
  {
    const double k = singularity.quarterIndex;
    const double own = (IsOnCircle(singularity) ? 2.0 : 1.0) * Pi * k * k;
    energy +=
      (own - 8.0 * Pi * k) * std::log(std::abs(this->Slope(ToComplex(singularity.position))));
  }
  return energy;
}

namespace
{
Complex Theta(Complex x, double q)
{
  Complex value = 1.0 - x;
  for (double power = q; power > 1e-18; power *= q)
  {
    value *= (1.0 - power * x) * (1.0 - power / x);
  }
  return value;
}

double LogTheta(Complex x, double q)
{
  return std::log(std::abs(Theta(x, q)));
}
}

double ExactRing::PhiAt(const Configuration& configuration, const Point& point) const
{
  const double q = this->inner * this->inner;
  const Complex z = ToComplex(point);
  double value = 4.0 * std::log(std::abs(z));
  for (const Singularity& singularity : configuration)
  {
    const Complex b = ToComplex(singularity.position);
    value += singularity.quarterIndex * (LogTheta(z / b, q) + LogTheta(z * std::conj(b), q));
  }
  return value;
}

Complex ExactRing::CrossAt(const Configuration& configuration, const Point& point) const
{
  const double q = this->inner * this->inner;
  const Complex z = ToComplex(point);
  Complex u = std::pow(z / std::abs(z), 4);
  for (const Singularity& singularity : configuration)
  {
    const Complex b = ToComplex(singularity.position);
    const Complex turn = Theta(z / b, q) * Theta(z * std::conj(b), q);
    u *= std::pow(turn / std::abs(turn), singularity.quarterIndex);
  }
  return u;
}

double ExactRing::Defect(const Configuration& configuration) const
{
  double sum = 0.0;
  for (const Singularity& singularity : configuration)
  {
    sum += singularity.quarterIndex * std::arg(ToComplex(singularity.position));
  }
  return std::remainder(sum, 2.0 * Pi);
}

double ExactRing::SingleValuedEnergy(const Configuration& configuration) const
{
  const double q = this->inner * this->inner;
  double products = 0.0;
  for (double power = q; power > 1e-18; power *= q)
  {
    products += std::log(1.0 - power);
  }
  double energy = -16.0 * Pi * std::log(this->inner);
  for (std::size_t j = 0; j < configuration.size(); ++j)
  {
    const Complex b = ToComplex(configuration[j].position);
    const double k = configuration[j].quarterIndex;
    double regular = (4.0 - k) * std::log(std::abs(b)) + 2.0 * k * products;
    for (std::size_t i = 0; i < configuration.size(); ++i)
    {
      const Complex c = ToComplex(configuration[i].position);
      regular += configuration[i].quarterIndex *
        (LogTheta(b * std::conj(c), q) + (i == j ? 0.0 : LogTheta(b / c, q)));
    }
    energy -= 4.0 * Pi * k * std::log(std::abs(b)) + Pi * k * regular;
  }
  return energy;
}

double ExactRing::Energy(const Configuration& configuration) const
{
  const double defect = this->Defect(configuration);
  return this->SingleValuedEnergy(configuration) - Pi * defect * defect / std::log(this->inner);
}
}
