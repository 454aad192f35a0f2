#include "FactorisationCount.h"

#include <atomic>

namespace crossfield
{
namespace
{
std::atomic<long> count = 0;
}

long FactorisationCount()
{
  return count;
}

void CountFactorisation()
{
  ++count;
}
}
