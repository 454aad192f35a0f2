#include "PointPlaces.h"

#include "DomainQueries.h"
#include "Error.h"

#include <string>

namespace crossfield
{
void RequirePlaces(const Configuration& configuration, const PlanarDomain& domain)
{
  // Points nearer than this coincide in single precision.
  const double minimum = 1e-6 * domain.Diagonal();
  for (std::size_t i = 0; i < configuration.size(); ++i)
  {
    const Singularity& singularity = configuration[i];
    if (!(SignedDistance(singularity.position, domain) > minimum))
    {
      throw Error("The singularity " + std::to_string(i + 1) + " at " +
        Describe(singularity.position) +
        " lies outside the domain or on its boundary; move it inside.");
    }
    for (std::size_t j = 0; j < i; ++j)
    {
      if ((configuration[j].position - singularity.position).norm() <= minimum)
      {
        throw Error("Singularities " + std::to_string(j + 1) + " and " + std::to_string(i + 1) +
          " are at the same place " + Describe(singularity.position) +
          "; replace them by one with the sum of their quarter indices.");
      }
    }
  }
}
}
