#include "Plane.h"

#include <gtest/gtest.h>

namespace crossfield::test
{
TEST(Plane, DescribesPlacesWithFourDigits)
{
  EXPECT_EQ(Describe({ 0.42426406871192851, -0.5 }), "(0.4243, -0.5)");
  EXPECT_EQ(Describe({ 1.0, 6.123233995736766e-17 }), "(1, 0)");
  EXPECT_EQ(Describe({ -1e-9, 2.0 / 3.0 }), "(0, 0.6667)");
  EXPECT_EQ(Describe({ 12.34567, 0.0123456 }), "(12.35, 0.01)");
  EXPECT_EQ(Describe({ 0.0, 0.0 }), "(0, 0)");
  EXPECT_EQ(Describe({ 1.23456e-6, 0.0 }), "(1.235e-06, 0)");
  // Far from the origin, the digits before the point are needed.
  EXPECT_EQ(Describe({ 512345.67, 5432109.8 }), "(512346, 5432110)");
}
}
