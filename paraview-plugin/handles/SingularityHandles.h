/**
 * @class   SingularityHandles
 * @brief   discs of constant size on the screen that stand for singularities in a 3D view
 *
 * A singularity of positive quarter index is a red disc, of negative a blue one, of zero a grey one, with
 * the quarter index beside it; the chosen one has a wide dark rim. They lie in a plane of space and are
 * drawn over everything else. No Qt here; ParaView's client owns the renderer.
 */

#ifndef SingularityHandles_h
#define SingularityHandles_h

#include "HandlePlane.h"
#include "SingularityRows.h"

#include "vtkSmartPointer.h"

#include <optional>
#include <vector>

class vtkActor2D;
class vtkRenderer;
class vtkTextActor;

class SingularityHandles final
{
public:
  SingularityHandles() = default;
  ~SingularityHandles();
  SingularityHandles(const SingularityHandles&) = delete;
  SingularityHandles& operator=(const SingularityHandles&) = delete;

  /** Where they are drawn; none (nullptr) hides them. `pixelRatio`: pixels of the screen per unit of it. */
  void SetRenderer(vtkRenderer* renderer, double pixelRatio = 1);
  vtkRenderer* GetRenderer() const;

  /** The plane that x and y of the rows are coordinates of. The next call of SetRows or SetRenderer puts the handles there. */
  void SetPlane(const HandlePlane& plane);
  const HandlePlane& GetPlane() const;

  /** One handle for each row. `chosen`: the row with the dark rim, or -1. The next render shows them. */
  void SetRows(const std::vector<SingularityRow>& rows, int chosen);

  /** The row whose disc is under a pixel, the nearest if there are several, or -1. */
  int RowAt(int x, int y) const;

  /** The point of the plane under a pixel; nothing where the line of sight does not meet the plane. */
  std::optional<std::array<double, 2>> PlanePointAt(double x, double y) const;

  /** The pixel of a point of the plane. */
  std::array<double, 2> PixelOf(const std::array<double, 2>& point) const;

  /** The pixels from the middle of a disc to its rim. */
  double GetDiscRadius() const;

private:
  struct Handle
  {
    vtkSmartPointer<vtkActor2D> Disc;
    /** The last one is coloured; the others are white and a pixel beside it, which makes its rim. */
    std::vector<vtkSmartPointer<vtkTextActor>> Labels;
  };
  Handle MakeHandle() const;
  void Add(const Handle& handle);
  void Remove(const Handle& handle);

  vtkSmartPointer<vtkRenderer> Renderer;
  double PixelRatio = 1;
  HandlePlane Plane;
  std::vector<SingularityRow> Rows;
  std::vector<Handle> Handles;
  int Chosen = -1;
};

#endif
