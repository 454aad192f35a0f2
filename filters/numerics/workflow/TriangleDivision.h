#pragma once

#include "Error.h"
#include "Progress.h"
#include "SurfaceCones.h"

#include <string>

namespace crossfield
{
/// Makes something of a part of a surface that may need smaller triangles than it has: then those are divided, on the
/// same surface, until no side is longer than a length, then half of it.
class TriangleDivision
{
public:
  /// `length` is that of quads; sharp edges are found again by an angle in radians.
  TriangleDivision(FeaturedPart part, double length, double featureAngle);

  /// Returns make(part, isLast, progress), where `make` may change its part. It is called again with smaller triangles,
  /// up to 200,000, after an error of kind CoarseMesh, up to three times in all; `isLast` is true the third time. Throws its last error.
  template <class Make>
  auto Run(const Make& make, const Progress& progress = {})
  {
    while (true)
    {
      try
      {
        FeaturedPart triangles = this->Part;
        return make(triangles, this->Divisions == MaximumDivisions, this->PartOf(progress));
      }
      catch (const Error& error)
      {
        this->Divide(error);
      }
    }
  }

  /// Returns one sentence if triangles were divided.
  std::string Event() const;

private:
  static constexpr int MaximumDivisions = 2;

  Progress PartOf(const Progress& progress) const;
  void Divide(const Error& error);

  SurfaceMesh Given;
  FeaturedPart Part; ///< With the triangles in use.
  double FeatureAngle;
  double Next;          ///< Side of triangles of the next division.
  double Longest = 0.0; ///< Side of the triangles in use.
  int Divisions = 0;
};
}
