#include "FactorisationCount.h"

#include <atomic>

namespace crossfield
{
namespace
{
std::atomic<long> factorisations = 0;
}

long FactorisationCount()
{
  return factorisations;
}

void CountFactorisation()
{
  ++factorisations;
}
}
