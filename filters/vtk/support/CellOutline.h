#ifndef CellOutline_h
#define CellOutline_h

#include "CellLoop.h"

#include <vector>

/**
 * Lines and surface cells of any order by the points along them: nodes between the ends of edges are vertices,
 * nodes inside of cells are not used.
 */
namespace CellOutline
{
/** A cell of first order. */
struct Outline
{
  int type = VTK_EMPTY_CELL; ///< VTK_POLY_LINE or VTK_POLYGON.
  std::vector<vtkIdType> points;
};

/**
 * Returns the points along a line or around a cell of higher order, whose points in VTK's order are given; no
 * points if the type is another one.
 */
Outline Of(int type, const CellLoop::Points& points);

/**
 * Calls work(corners) for each triangle of a strip. Strips that were joined repeat points, which
 * give none.
 */
template <class Work>
void ForEachTriangle(const CellLoop::Points& strip, const Work& work)
{
  for (vtkIdType i = 0; i + 2 < strip.Size(); ++i)
  {
    const vtkIdType* corners = strip.begin() + i;
    if (corners[0] != corners[1] && corners[1] != corners[2] && corners[2] != corners[0])
    {
      work(CellLoop::Points(corners, 3));
    }
  }
}

/**
 * Calls work(cell, type, points) for every cell of a data set, those of higher order as Of, and for
 * each triangle of a strip.
 */
template <class Work>
void ForEachCell(vtkDataSet* data, const Work& work)
{
  CellLoop::ForEachCell(data,
    [&work](vtkIdType cell, int type, const CellLoop::Points& points)
    {
      if (type == VTK_TRIANGLE_STRIP)
      {
        ForEachTriangle(
          points, [&](const CellLoop::Points& corners) { work(cell, VTK_TRIANGLE, corners); });
        return;
      }
      const Outline outline = Of(type, points);
      outline.points.empty()
        ? work(cell, type, points)
        : work(cell, outline.type,
            CellLoop::Points(outline.points.data(), static_cast<vtkIdType>(outline.points.size())));
    });
}
}

#endif
