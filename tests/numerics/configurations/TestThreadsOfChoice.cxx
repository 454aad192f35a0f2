// The chosen singularities are the same to the last bit with any number of threads.

#include "AutomaticConfiguration.h"
#include "Support.h"

#include <omp.h>

namespace crossfield::test
{
namespace
{
AutomaticConfiguration ChooseWith(int threads, const PlanarDomain& domain)
{
  const int before = omp_get_max_threads();
  omp_set_num_threads(threads);
  AutomaticOptions options;
  options.quadCount = 500;
  options.proposal.chooseCorners = true;
  options.proposal.variations = true;
  AutomaticConfiguration chosen = ChooseConfiguration(domain, options);
  omp_set_num_threads(before);
  return chosen;
}

TEST(AutomaticConfiguration, IsTheSameWithAnyNumberOfThreads)
{
  Random random(7301);
  const std::vector<PlanarDomain> domains = { RandomSmoothDomain(random), Builtin("l-shape"),
    Builtin("ring") };
  for (const PlanarDomain& domain : domains)
  {
    const AutomaticConfiguration expected = ChooseWith(1, domain);
    for (const int threads : { 2, 3, 8 })
    {
      const AutomaticConfiguration actual = ChooseWith(threads, domain);
      ASSERT_EQ(actual.singularities.size(), expected.singularities.size()) << threads;
      for (std::size_t i = 0; i < expected.singularities.size(); ++i)
      {
        EXPECT_EQ(actual.singularities[i].position, expected.singularities[i].position) << threads;
        EXPECT_EQ(actual.singularities[i].quarterIndex, expected.singularities[i].quarterIndex);
      }
      EXPECT_EQ(actual.optimum.energyAfter, expected.optimum.energyAfter) << threads;
      EXPECT_EQ(actual.optimum.solves, expected.optimum.solves) << threads;
      EXPECT_EQ(actual.events, expected.events) << threads;
    }
  }
}
}
}
