#include "support/FilterChecks.h"
#include "vtkPlanarDomainSource.h"

#include "vtkCellArray.h"
#include "vtkErrorCode.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <limits>

namespace
{
using Complex = std::complex<double>;
using ComplexLoop = std::vector<Complex>; // without the repeated first point

const double Pi = std::acos(-1.0);

double Area(const ComplexLoop& loop)
{
  double twice = 0.0;
  for (std::size_t i = 0; i < loop.size(); ++i)
  {
    twice += std::imag(std::conj(loop[i]) * loop[(i + 1) % loop.size()]);
  }
  return 0.5 * twice;
}

double LongestSegment(const ComplexLoop& loop)
{
  double longest = 0.0;
  for (std::size_t i = 0; i < loop.size(); ++i)
  {
    longest = std::max(longest, std::abs(loop[(i + 1) % loop.size()] - loop[i]));
  }
  return longest;
}

class PlanarDomainSource : public testing::Test
{
public:
  /** Returns the loops of a domain. Expects each to be one closed polyline in z = 0. */
  std::vector<ComplexLoop> Read(const std::string& name)
  {
    this->Source->SetDomainName(name);
    FilterChecks::UpdateWithoutError(this->Source);
    vtkPolyData* output = this->Source->GetOutput();
    EXPECT_EQ(output->GetNumberOfCells(), output->GetNumberOfLines());
    std::vector<ComplexLoop> loops;
    vtkNew<vtkIdList> ids;
    for (vtkIdType line = 0; line < output->GetNumberOfLines(); ++line)
    {
      output->GetLines()->GetCellAtId(line, ids);
      EXPECT_GT(ids->GetNumberOfIds(), 3);
      EXPECT_EQ(ids->GetId(0), ids->GetId(ids->GetNumberOfIds() - 1)) << name << " is not closed";
      loops.emplace_back();
      for (vtkIdType i = 0; i + 1 < ids->GetNumberOfIds(); ++i)
      {
        const double* point = output->GetPoint(ids->GetId(i));
        EXPECT_EQ(point[2], 0.0);
        loops.back().emplace_back(point[0], point[1]);
      }
    }
    return loops;
  }

  vtkNew<vtkPlanarDomainSource> Source;
};

/** Returns the area of a regular polygon relative to its circle. */
double PolygonShare(const ComplexLoop& loop)
{
  const double angle = 2.0 * Pi / static_cast<double>(loop.size());
  return std::sin(angle) / angle;
}
}

TEST_F(PlanarDomainSource, FollowsFilterConventions)
{
  FilterChecks::CheckRunTwice(
    this->Source, [this] { this->Source->SetDomainName("ring"); },
    [this] { this->Source->SetDomainName("l-shape"); });
  FilterChecks::CheckProgressAndAbort(this->Source, false);
  FilterChecks::CheckPrintSelf(
    this->Source, { "DomainName", "Radius", "InnerRadius", "Width", "Height", "EdgeLength" });
}

TEST_F(PlanarDomainSource, DefaultIsTheUnitDisk)
{
  const std::string output = [this]
  {
    FilterChecks::UpdateWithoutError(this->Source);
    return FilterChecks::Fingerprint(this->Source->GetOutput());
  }();
  this->Source->SetDomainName("disk");
  this->Source->SetRadius(1.0);
  this->Source->Modified();
  FilterChecks::UpdateWithoutError(this->Source);
  EXPECT_TRUE(FilterChecks::Fingerprint(this->Source->GetOutput()) == output);
}

TEST_F(PlanarDomainSource, Disk)
{
  this->Source->SetRadius(3.0);
  const std::vector<ComplexLoop> loops = this->Read("disk");
  ASSERT_EQ(loops.size(), 1u);
  for (const Complex& place : loops[0])
  {
    EXPECT_NEAR(std::abs(place), 3.0, 1e-14);
  }
  EXPECT_NEAR(Area(loops[0]), 9.0 * Pi * PolygonShare(loops[0]), 1e-12);
  EXPECT_LE(LongestSegment(loops[0]), std::hypot(6.0, 6.0) / 40.0);
}

TEST_F(PlanarDomainSource, RingHasTheOuterLoopFirst)
{
  this->Source->SetRadius(2.0);
  this->Source->SetInnerRadius(0.5);
  const std::vector<ComplexLoop> loops = this->Read("ring");
  ASSERT_EQ(loops.size(), 2u);
  EXPECT_NEAR(Area(loops[0]), 4.0 * Pi * PolygonShare(loops[0]), 1e-12);
  // All loops are counter-clockwise.
  EXPECT_NEAR(Area(loops[1]), 0.25 * Pi * PolygonShare(loops[1]), 1e-12);
}

TEST_F(PlanarDomainSource, Ellipse)
{
  this->Source->SetWidth(4.0);
  this->Source->SetHeight(1.0);
  const std::vector<ComplexLoop> loops = this->Read("ellipse");
  ASSERT_EQ(loops.size(), 1u);
  for (const Complex& place : loops[0])
  {
    EXPECT_NEAR(std::hypot(place.real() / 2.0, place.imag() / 0.5), 1.0, 1e-14);
  }
  EXPECT_NEAR(Area(loops[0]), Pi * PolygonShare(loops[0]), 1e-12);
}

TEST_F(PlanarDomainSource, QuarterDisk)
{
  this->Source->SetRadius(2.0);
  const std::vector<ComplexLoop> loops = this->Read("quarter-disk");
  ASSERT_EQ(loops.size(), 1u);
  EXPECT_EQ(std::count(loops[0].begin(), loops[0].end(), Complex(0.0, 0.0)), 1);
  EXPECT_EQ(std::count(loops[0].begin(), loops[0].end(), Complex(2.0, 0.0)), 1);
  EXPECT_EQ(std::count(loops[0].begin(), loops[0].end(), Complex(0.0, 2.0)), 1);
  for (const Complex& place : loops[0])
  {
    EXPECT_TRUE(place == 0.0 || std::abs(std::abs(place) - 2.0) < 1e-14);
    EXPECT_GE(std::min(place.real(), place.imag()), 0.0);
  }
  EXPECT_NEAR(Area(loops[0]), Pi, 1e-3);
}

TEST_F(PlanarDomainSource, StraightSidesAreSingleSegments)
{
  this->Source->SetWidth(3.0);
  this->Source->SetHeight(2.0);
  EXPECT_EQ(this->Read("square"),
    std::vector<ComplexLoop>({ { { 0.0, 0.0 }, { 3.0, 0.0 }, { 3.0, 3.0 }, { 0.0, 3.0 } } }));
  EXPECT_EQ(this->Read("rectangle"),
    std::vector<ComplexLoop>({ { { 0.0, 0.0 }, { 3.0, 0.0 }, { 3.0, 2.0 }, { 0.0, 2.0 } } }));
  EXPECT_EQ(this->Read("l-shape"),
    std::vector<ComplexLoop>(
      { { { 0.0, 0.0 }, { 3.0, 0.0 }, { 3.0, 1.5 }, { 1.5, 1.5 }, { 1.5, 3.0 }, { 0.0, 3.0 } } }));
}

TEST_F(PlanarDomainSource, HexagonAndStar)
{
  this->Source->SetRadius(2.0);
  this->Source->SetInnerRadius(0.5);
  const std::vector<ComplexLoop> hexagon = this->Read("hexagonal");
  ASSERT_EQ(hexagon.size(), 1u);
  ASSERT_EQ(hexagon[0].size(), 6u);
  EXPECT_NEAR(Area(hexagon[0]), 4.0 * 1.5 * std::sqrt(3.0), 1e-13);
  const std::vector<ComplexLoop> star = this->Read("star");
  ASSERT_EQ(star.size(), 1u);
  ASSERT_EQ(star[0].size(), 10u);
  for (std::size_t i = 0; i < 10; ++i)
  {
    EXPECT_NEAR(std::abs(star[0][i]) * std::abs(star[0][(i + 1) % 10]), 2.0 * 0.5, 1e-14);
    EXPECT_NEAR(std::arg(star[0][(i + 1) % 10] / star[0][i]), Pi / 5.0, 1e-14);
  }
  EXPECT_NEAR(std::max(std::abs(star[0][0]), std::abs(star[0][1])), 2.0, 1e-14);
}

TEST_F(PlanarDomainSource, AngularDomainsHaveTheirAngles)
{
  struct Case
  {
    const char* name;
    std::vector<double> angles; ///< Sorted, in degrees.
  };
  const Case cases[] = { { "angular-balanced", { 107.5, 107.5, 107.5, 107.5, 145.0, 145.0 } },
    { "angular-negative", { 100.0, 100.0, 130.0, 130.0, 130.0, 130.0 } },
    { "angular-positive", { 80.0, 80.0, 140.0, 140.0, 140.0, 140.0 } },
    { "angular-hole", { 80.0, 80.0, 140.0, 140.0, 140.0, 140.0 } } };
  for (const Case& test : cases)
  {
    SCOPED_TRACE(test.name);
    const std::vector<ComplexLoop> loops = this->Read(test.name);
    const bool hasHole = std::string(test.name) == "angular-hole";
    ASSERT_EQ(loops.size(), hasHole ? 2u : 1u);
    const ComplexLoop& loop = loops[0];
    ASSERT_EQ(loop.size(), test.angles.size());
    std::vector<double> angles;
    for (std::size_t i = 0; i < loop.size(); ++i)
    {
      const Complex before = loop[(i + loop.size() - 1) % loop.size()] - loop[i];
      const Complex after = loop[(i + 1) % loop.size()] - loop[i];
      angles.push_back(std::arg(before / after) * 180.0 / Pi);
    }
    std::sort(angles.begin(), angles.end());
    for (std::size_t i = 0; i < angles.size(); ++i)
    {
      EXPECT_NEAR(angles[i], test.angles[i], 1e-9);
    }
    if (hasHole)
    {
      EXPECT_NEAR(Area(loops[1]), 0.04 * Pi * PolygonShare(loops[1]), 1e-12);
    }
  }
}

TEST_F(PlanarDomainSource, EdgeLengthAppliesToCurves)
{
  for (const char* name : { "disk", "ring", "ellipse", "quarter-disk" })
  {
    this->Source->SetEdgeLength(0.05);
    for (const ComplexLoop& loop : this->Read(name))
    {
      // Straight sides of the quarter disk are longer.
      const double longest =
        std::string(name) == "quarter-disk" ? std::abs(loop[1] - loop[0]) : LongestSegment(loop);
      EXPECT_LE(longest, 0.05) << name;
      EXPECT_GT(longest, 0.03) << name;
    }
  }
}

TEST_F(PlanarDomainSource, RejectsAnUnknownName)
{
  this->Source->SetDomainName("triangle");
  EXPECT_EQ(FilterChecks::CaptureError(this->Source, { "'triangle'", "disk, ring" }),
    vtkErrorCode::UserError);
  this->Source->SetDomainName("disk");
  FilterChecks::UpdateWithoutError(this->Source);
}

TEST_F(PlanarDomainSource, RejectsLengthsThatAreNotPositive)
{
  using Setter = void (vtkPlanarDomainSource::*)(double);
  struct Case
  {
    const char* domain;
    Setter set;
    double good;
  };
  const Case cases[] = { { "disk", &vtkPlanarDomainSource::SetRadius, 1.0 },
    { "ring", &vtkPlanarDomainSource::SetRadius, 1.0 },
    { "ring", &vtkPlanarDomainSource::SetInnerRadius, 0.4 },
    { "quarter-disk", &vtkPlanarDomainSource::SetRadius, 1.0 },
    { "ellipse", &vtkPlanarDomainSource::SetWidth, 2.0 },
    { "ellipse", &vtkPlanarDomainSource::SetHeight, 1.0 },
    { "square", &vtkPlanarDomainSource::SetWidth, 2.0 },
    { "rectangle", &vtkPlanarDomainSource::SetWidth, 2.0 },
    { "rectangle", &vtkPlanarDomainSource::SetHeight, 1.0 },
    { "l-shape", &vtkPlanarDomainSource::SetWidth, 2.0 } };
  for (const Case& test : cases)
  {
    this->Source->SetDomainName(test.domain);
    for (double bad : { 0.0, -1.0, std::numeric_limits<double>::quiet_NaN(),
           std::numeric_limits<double>::infinity() })
    {
      SCOPED_TRACE(std::string(test.domain) + " " + std::to_string(bad));
      (this->Source->*test.set)(bad);
      FilterChecks::CaptureError(this->Source, { "of a " });
    }
    (this->Source->*test.set)(test.good);
    FilterChecks::UpdateWithoutError(this->Source);
  }
  this->Source->SetDomainName("ring");
  this->Source->SetInnerRadius(1.0);
  FilterChecks::CaptureError(this->Source, { "inner radius", "smaller" });
  this->Source->SetDomainName("disk");
  this->Source->SetEdgeLength(-0.1);
  FilterChecks::CaptureError(this->Source, { "edge length" });
}
