#ifndef UsedPoints_h
#define UsedPoints_h

#include "DomainPlane.h"

#include "vtkType.h"

#include <cstddef>
#include <vector>

class vtkDataSet;

/**
 * Points that lines and surface cells use. All other points, even of vertex cells, are ignored:
 * they may be anywhere.
 */
class UsedPoints
{
public:
  explicit UsedPoints(vtkDataSet* input);

  /** Returns the ids of the used points in ascending order. */
  const std::vector<vtkIdType>& GetIds() const { return this->Ids; }

  /** Returns the index of a used point in GetIds(). */
  int IndexOf(vtkIdType point) const { return this->Indices[point]; }

  /** Returns the plane of the used points. Throws crossfield::Error if they are in none. */
  crossfield::DomainPlane FindPlane(vtkDataSet* input) const;
  /** Returns the plane nearest to the used points. */
  crossfield::DomainPlane NearestPlane(vtkDataSet* input) const;

private:
  Eigen::Matrix3Xd PlacesOf(vtkDataSet* input) const;

  std::vector<int> Indices; ///< Indices in Ids; −1 for points that are not used.
  std::vector<vtkIdType> Ids;
};

#endif
