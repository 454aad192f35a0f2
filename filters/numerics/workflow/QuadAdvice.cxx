#include "QuadAdvice.h"

#include "BoundaryCorners.h"
#include "DomainQueries.h"
#include "Error.h"

#include <sstream>

namespace crossfield
{
namespace
{
bool IsInside(const PlanarDomain& domain, const Singularity& singularity)
{
  return SignedDistance(singularity.position, domain) > BoundaryReach * domain.Diagonal();
}

/// Returns "The singularity at (1, 2) of quarter index 3".
std::string Name(const Singularity& singularity)
{
  return "The singularity at " + Describe(singularity.position) + " of quarter index " +
    std::to_string(singularity.quarterIndex);
}

std::string SplitAdvice(int count, int sign)
{
  return "; to have " + std::to_string(count) + " of index " + std::to_string(sign) +
    " instead, split it (SplitSingularities, --split).";
}
}

void RequireNodes(const PlanarDomain& domain, const Configuration& singularities)
{
  for (const Singularity& singularity : singularities)
  {
    if (singularity.quarterIndex > 2 && IsInside(domain, singularity))
    {
      throw Error(Name(singularity) + " would be a node with " +
        std::to_string(4 - singularity.quarterIndex) + " quads, which no mesh has" +
        SplitAdvice(singularity.quarterIndex, 1));
    }
  }
}

std::vector<std::string> DescribeFlatNodes(
  const PlanarDomain& domain, const Configuration& singularities)
{
  std::vector<std::string> sentences;
  for (const Singularity& singularity : singularities)
  {
    if (singularity.quarterIndex == 2 && IsInside(domain, singularity))
    {
      sentences.push_back(Name(singularity) +
        " is a node of valence 2, between two quads with angles of 180°" + SplitAdvice(2, 1));
    }
  }
  return sentences;
}

std::vector<std::string> DescribeCrowdedNodes(
  const PlanarDomain& domain, const Configuration& singularities)
{
  std::vector<std::string> sentences;
  for (const Singularity& singularity : singularities)
  {
    if (singularity.quarterIndex <= -2 && IsInside(domain, singularity))
    {
      sentences.push_back(Name(singularity) + " is a node of valence " +
        std::to_string(4 - singularity.quarterIndex) + SplitAdvice(-singularity.quarterIndex, -1));
    }
  }
  return sentences;
}

std::string DescribeInverted(const QuadQuality& quality, const std::optional<SmallerSize>& smaller)
{
  std::ostringstream text;
  text << quality.inverted << (quality.inverted == 1 ? " quad is" : " quads are")
       << " inverted, the worst near " << Describe(quality.where);
  if (smaller)
  {
    text << "; use a smaller size: with " << smaller->size << ", " << smaller->quads
         << " quads, none is inverted.";
  }
  else
  {
    text << ", and smaller sizes do not help; choose other positions for the singularities nearby.";
  }
  return text.str();
}

std::string RepairAdvice(const HolonomyRepair& repair)
{
  std::ostringstream text;
  text.precision(3);
  text << "; the repair of the holonomy (RepairHolonomy, --repair-holonomy) avoids this and moves "
          "singularities by up to "
       << repair.largestMove;
  return text.str();
}

std::string WithAdvice(std::string sentence, const std::string& clause)
{
  if (!sentence.empty() && sentence.back() == '.')
  {
    sentence.pop_back();
  }
  return sentence + clause + ".";
}
}
