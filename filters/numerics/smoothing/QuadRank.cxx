#include "QuadRank.h"

#include "Index.h"
#include "Parts.h"
#include "QuadQuality.h"

#include <algorithm>
#include <vector>

namespace crossfield
{
QuadRank RankOf(const QuadMesh& mesh)
{
  const auto quads = static_cast<std::ptrdiff_t>(mesh.quads.size());
  std::vector<QuadRank> ranks(PartCount(quads));
  ForParts(ranks.size(),
    [&](std::size_t part)
    {
      QuadRank& rank = ranks[part];
      const auto [begin, end] = PartRange(quads, part, ranks.size());
      for (std::size_t q = Index(begin); q < Index(end); ++q)
      {
        const double jacobian = ScaledJacobian(mesh, q);
        rank.inverted += jacobian <= 0.0 ? 1 : 0;
        rank.minimum = std::min(rank.minimum, jacobian);
      }
    });
  QuadRank rank;
  for (const QuadRank& part : ranks)
  {
    rank.inverted += part.inverted;
    rank.minimum = std::min(rank.minimum, part.minimum);
  }
  return rank;
}
}
