#include "BlasKernels.h"

#include <cstdlib>
#include <cstring>
#include <mutex>

// OpenBLAS's own interface. What chooses kernels is there only in builds that have several of them, as Debian's.
extern "C"
{
  char* openblas_get_corename(void);
  __attribute__((weak)) void openblas_read_env(void);
  __attribute__((weak)) void gotoblas_dynamic_quit(void);
  __attribute__((weak)) void gotoblas_dynamic_init(void);
}

namespace crossfield
{
namespace
{
constexpr const char* Variable = "OPENBLAS_CORETYPE";

/// The best kernels that the processor can run; null if those of Prescott are.
const char* KernelsOfProcessor()
{
#if defined(__x86_64__)
  const auto has512 = []
  {
    return __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512cd") &&
      __builtin_cpu_supports("avx512bw") && __builtin_cpu_supports("avx512dq") &&
      __builtin_cpu_supports("avx512vl");
  };
  if (__builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma"))
  {
    return has512() ? "SkylakeX" : "Haswell";
  }
#endif
  return nullptr;
}

void Choose()
{
  const bool several = openblas_read_env != nullptr && gotoblas_dynamic_quit != nullptr &&
    gotoblas_dynamic_init != nullptr;
  const char* kernels = KernelsOfProcessor();
  if (!several || kernels == nullptr || std::getenv(Variable) != nullptr ||
    std::strcmp(openblas_get_corename(), "Prescott") != 0)
  {
    return;
  }
  // The variable is the only way in; programs that this one starts choose for themselves.
  setenv(Variable, kernels, 0);
  openblas_read_env();
  gotoblas_dynamic_quit();
  gotoblas_dynamic_init();
  unsetenv(Variable);
}
}

void ChooseBlasKernels()
{
  static std::once_flag once;
  std::call_once(once, Choose);
}
}
