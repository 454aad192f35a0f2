#include "QuadBudget.h"

#include "DomainQueries.h"
#include "Error.h"
#include "MemoryBudget.h"

#include <sstream>

namespace crossfield
{
namespace
{
std::string Rounded(double number)
{
  std::ostringstream text;
  text.precision(3);
  text << number;
  return text.str();
}

/// `what` describes the mesh.
void RequireCount(double count, const std::string& what, const std::string& remedy)
{
  if (!(count <= MaximumQuads))
  {
    throw Error(what + " would have more than the maximum of " + Rounded(MaximumQuads) +
      " quads, which need 50 GB of memory; " + remedy + ".");
  }
  RequireMemory(count * BytesPerQuad, what, remedy);
}
}

void RequireQuadSize(const PlanarDomain& domain, double quadSize)
{
  if (quadSize > 0.0)
  {
    RequireCount(domain.Area() / quadSize / quadSize,
      "A mesh of quads of size " + Rounded(quadSize), "use a larger size");
  }
}

void RequireQuadBudget(const PlanarDomain& domain, const ResolvedRequest& request)
{
  for (const SidePrescription& one : request.prescribed)
  {
    const std::string& name = request.sides.names[one.side];
    RequireCount(one.count,
      "A mesh with " + Rounded(one.count) + " edges along side '" + name + "'",
      "give the side fewer edges");
  }
  if (request.quadSize == 0.0)
  {
    RequireCount(request.quadCount, "The requested mesh", "request fewer quads");
  }
  else if (request.sizing != Sizing::Field) // whose sizes are factors
  {
    RequireQuadSize(domain, request.quadSize);
  }
}
}
