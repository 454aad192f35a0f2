#ifndef CellLoop_h
#define CellLoop_h

#include "vtkCellArray.h"
#include "vtkCellType.h"
#include "vtkDataSet.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"

/**
 * Loops over cells that read the arrays of their points directly. Requesting one cell after the
 * other from a data set takes several times as long. The lists must be valid (see InputCheck).
 */
namespace CellLoop
{
/** Points of one cell, with ids of 32 or 64 bits. */
template <class Id>
class Points
{
public:
  Points(const Id* first, vtkIdType count)
    : First(first)
    , Count(count)
  {
  }
  vtkIdType Size() const { return this->Count; }
  vtkIdType operator[](vtkIdType i) const { return static_cast<vtkIdType>(this->First[i]); }
  const Id* begin() const { return this->First; }
  const Id* end() const { return this->First + this->Count; }

private:
  const Id* First;
  vtkIdType Count;
};

/** Calls work(cell, points) for every cell of a list. */
template <class Work>
void ForEachInList(vtkCellArray* list, const Work& work)
{
  list->Visit(
    [&work](auto& state)
    {
      const auto* ids = state.GetConnectivity()->GetPointer(0);
      const auto* offsets = state.GetOffsets()->GetPointer(0);
      for (vtkIdType cell = 0; cell < state.GetNumberOfCells(); ++cell)
      {
        work(cell,
          Points(ids + offsets[cell], static_cast<vtkIdType>(offsets[cell + 1] - offsets[cell])));
      }
    });
}

/** Calls work(cell, type, points) for every cell of a data set. */
template <class Work>
void ForEachCell(vtkDataSet* data, const Work& work)
{
  auto* grid = vtkUnstructuredGrid::SafeDownCast(data);
  if (grid != nullptr && grid->GetCells() != nullptr && grid->GetNumberOfCells() > 0)
  {
    const unsigned char* types = grid->GetCellTypesArray()->GetPointer(0);
    ForEachInList(grid->GetCells(),
      [&work, types](vtkIdType cell, const auto& points) { work(cell, types[cell], points); });
    return;
  }
  // The cells are in several lists or defined by a structure.
  vtkNew<vtkIdList> ids;
  for (vtkIdType cell = 0; cell < data->GetNumberOfCells(); ++cell)
  {
    const int type = data->GetCellType(cell);
    data->GetCellPoints(cell, ids);
    work(cell, type, Points<vtkIdType>(ids->GetPointer(0), ids->GetNumberOfIds()));
  }
}
}

#endif
