#include "QuadBudget.h"

#include "DomainQueries.h"
#include "Error.h"
#include "LoopArc.h"
#include "MemoryBudget.h"

#include <algorithm>
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
  double perimeter = 0.0;
  for (const Loop& loop : domain.loops)
  {
    perimeter += LoopArc(loop).Length();
  }
  for (const SizeNear& near : request.sizesNear)
  {
    RequireCount(
      std::max(near.radius * near.radius / (near.size * near.size), domain.Diagonal() / near.size),
      "A mesh with quads of size " + Rounded(near.size) + " near " + Describe(near.place),
      "use a larger size");
  }
  for (const SidePrescription& one : request.prescribed)
  {
    const std::string& name = request.sides.names[one.side];
    for (const double size : { one.size, one.inside })
    {
      if (size > 0.0)
      {
        RequireCount(perimeter / size,
          "A mesh with edges of length " + Rounded(size) + " at side '" + name + "'",
          "use a larger size");
      }
    }
    RequireCount(one.count,
      "A mesh with " + Rounded(one.count) + " edges along side '" + name + "'",
      "give the side fewer edges");
  }
  if (request.quadCount < 0)
  {
    throw Error("The requested number of quads is negative; give a positive one, or a size.");
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
