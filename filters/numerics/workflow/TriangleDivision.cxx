#include "TriangleDivision.h"

#include "OptimizerReport.h"
#include "SurfaceParts.h"
#include "SurfaceRefinement.h"

#include <utility>

namespace crossfield
{
TriangleDivision::TriangleDivision(FeaturedPart part, double length, double featureAngle)
  : Given(part.surface)
  , Part(std::move(part))
  , FeatureAngle(featureAngle)
  , Next(length)
{
}

Progress TriangleDivision::PartOf(const Progress& progress) const
{
  const double done = this->Divisions == 0 ? 0.0 : 0.6 + 0.2 * (this->Divisions - 1);
  return progress.Part(done, this->Divisions == 0 ? 0.6 : done + 0.2);
}

void TriangleDivision::Divide(const Error& error)
{
  constexpr double MaximumTriangles = 200000; // a map of these takes ten seconds
  // Equilateral triangles with sides of this length; others are up to three times as many.
  const bool fits = AreaOf(this->Given) / (0.43 * this->Next * this->Next) < MaximumTriangles;
  if (error.GetKind() != Error::Kind::CoarseMesh || error.GetCause().empty() || !fits)
  {
    throw error;
  }
  if (this->Divisions == MaximumDivisions)
  {
    throw Error(error.GetCause() + ", even with the sides of triangles at most " +
        FormatShort(this->Longest) + " long",
      "give other singularities, or a surface with more even triangles", error.GetKind());
  }
  ++this->Divisions;
  this->Longest = this->Next;
  this->Next *= 0.5;
  this->Part.surface = Refined(this->Given, this->Longest);
  this->Part.features = FindFeatureEdges(this->Part.surface, this->FeatureAngle);
}

std::string TriangleDivision::Event() const
{
  return this->Divisions == 0
    ? std::string()
    : "The triangles of the surface were divided, on the same surface, until their sides were "
      "at most " +
      FormatShort(this->Longest) + " long: with larger ones there is no map.";
}
}
