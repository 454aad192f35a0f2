#ifndef UsedPoints_h
#define UsedPoints_h

#include "DomainPlane.h"

#include "vtkType.h"

#include <cstddef>
#include <vector>

class vtkDataSet;

/**
 * The points that lines and surface cells use. Others, which vertices may use, count for nothing: they
 * may be anywhere.
 */
class UsedPoints
{
public:
  explicit UsedPoints(vtkDataSet* input);

  /** In ascending order. */
  const std::vector<vtkIdType>& GetIds() const { return this->Ids; }

  /** Where a used point is among them. */
  int NumberOf(vtkIdType point) const { return this->Numbers[static_cast<std::size_t>(point)]; }

  crossfield::DomainPlane FindPlane(vtkDataSet* input) const;

private:
  std::vector<int> Numbers; ///< −1 for points that are not used.
  std::vector<vtkIdType> Ids;
};

#endif
