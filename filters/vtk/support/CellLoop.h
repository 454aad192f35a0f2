#ifndef CellLoop_h
#define CellLoop_h

#include "vtkCellArray.h"
#include "vtkCellArrayIterator.h"
#include "vtkCellType.h"
#include "vtkDataSet.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkSmartPointer.h"
#include "vtkUnstructuredGrid.h"

/**
 * Loops over cells that read the arrays of their points directly. Requesting one cell after the
 * other from a data set takes several times as long. The lists must be valid (see InputCheck).
 */
namespace CellLoop
{
/** Points of one cell. Valid until the loop goes to the next cell. */
class Points
{
public:
  Points(const vtkIdType* first, vtkIdType count)
    : First(first)
    , Count(count)
  {
  }
  vtkIdType Size() const { return this->Count; }
  vtkIdType operator[](vtkIdType i) const { return this->First[i]; }
  const vtkIdType* begin() const { return this->First; }
  const vtkIdType* end() const { return this->First + this->Count; }

private:
  const vtkIdType* First;
  vtkIdType Count;
};

/** Calls work(cell, points) for every cell of a list, whatever arrays the list consists of. */
template <class Work>
void ForEachInList(vtkCellArray* list, const Work& work)
{
  const auto iterator = vtk::TakeSmartPointer(list->NewIterator());
  for (iterator->GoToFirstCell(); !iterator->IsDoneWithTraversal(); iterator->GoToNextCell())
  {
    vtkIdType count = 0;
    const vtkIdType* points = nullptr;
    iterator->GetCurrentCell(count, points);
    work(iterator->GetCurrentCellId(), Points(points, count));
  }
}

/** Calls work(cell, type, points) for every cell of a data set. */
template <class Work>
void ForEachCell(vtkDataSet* data, const Work& work)
{
  auto* grid = vtkUnstructuredGrid::SafeDownCast(data);
  if (grid != nullptr && grid->GetCells() != nullptr && grid->GetNumberOfCells() > 0)
  {
    ForEachInList(grid->GetCells(),
      [&work, grid](vtkIdType cell, const Points& points)
      { work(cell, grid->GetCellType(cell), points); });
    return;
  }
  // The cells are in several lists or defined by a structure.
  vtkNew<vtkIdList> ids;
  for (vtkIdType cell = 0; cell < data->GetNumberOfCells(); ++cell)
  {
    const int type = data->GetCellType(cell);
    data->GetCellPoints(cell, ids);
    work(cell, type, Points(ids->GetPointer(0), ids->GetNumberOfIds()));
  }
}
}

#endif
