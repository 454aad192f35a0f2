#include "SerialBlas.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <string>

extern "C" char* openblas_get_corename(void);

namespace
{
TEST(BlasKernels, AreThoseOfTheProcessorUnlessTheUserSaysWhich)
{
  const char* asked = std::getenv("OPENBLAS_CORETYPE");
  const crossfield::SerialBlas serial;
  const std::string kernels = openblas_get_corename();
  if (asked != nullptr)
  {
    EXPECT_EQ(kernels, asked);
  }
#if defined(__x86_64__)
  else if (__builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma"))
  {
    EXPECT_NE(kernels, "Prescott");
  }
#endif
  // Nothing is left for the programs that this one starts.
  EXPECT_EQ(std::getenv("OPENBLAS_CORETYPE"), asked);
}
}
