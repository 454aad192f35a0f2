#include "BodyLayout.h"

#include "Stopwatch.h"
#include "SurfaceMap.h"
#include "SurfaceTopology.h"
#include "TMeshPatches.h"

#include <string>
#include <utility>

namespace crossfield
{
Layout LayOutFace(const ConedSurface& face, QuadSeconds& seconds, const Progress& progress)
{
  if (face.GivenQuarters() != face.RequiredQuarters())
  {
    throw Error(DescribeQuarters(face), Error::Kind::Inconsistent);
  }
  Stopwatch clock;
  Layout layout;
  layout.map = SolveSurfaceMap(face.topology, face.cones, progress.Part(0.0, 0.7));
  seconds.map += clock.Lap();
  layout.separatrices = TraceSeparatrices(layout.map, progress.Part(0.7, 1.0));
  layout.tMesh = MakeTMesh(layout.map, layout.separatrices);
  seconds.trace += clock.Lap();
  return layout;
}

Error InFace(const SurfaceBody& body, const ConedSurface& face, const Error& error)
{
  if (body.lines.empty())
  {
    return error;
  }
  const std::string start = DescribeFace(face) + ": ";
  return error.GetCause().empty()
    ? Error(start + error.what(), error.GetKind())
    : Error(start + error.GetCause(), error.GetRemedy(), error.GetKind());
}

void RequireCover(const SurfaceBody& body, const QuadMesh& mesh)
{
  if (mesh.EulerCharacteristic() != body.eulerCharacteristic)
  {
    throw Error("The quads do not cover the surface; use a smaller size.");
  }
}

LayoutSet JoinBody(const SurfaceBody& body, const SurfaceNames& names, std::vector<Layout> layouts)
{
  return body.IsWhole() ? LayoutSet(std::move(layouts.front())) : JoinFaces(body, names, layouts);
}
}
