/**
 * @class   SingularityHandles
 * @brief   discs of constant screen size that represent singularities in a 3D view
 *
 * Discs are red for a positive quarter index, blue for a negative one and grey for zero, with the
 * quarter index beside them; the selected one has a wide dark rim. They are placed in a plane of
 * space and drawn over everything else. This class does not use Qt; ParaView's client owns the
 * renderer.
 */

#ifndef SingularityHandles_h
#define SingularityHandles_h

#include "HandlePlane.h"
#include "SingularityRows.h"

#include "vtkSmartPointer.h"

#include <optional>
#include <utility>
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

  /**
   * Sets the renderer; nullptr hides the handles. `pixelRatio` is in device pixels per logical
   * pixel.
   */
  void SetRenderer(vtkRenderer* renderer, double pixelRatio = 1);
  vtkRenderer* GetRenderer() const;

  /**
   * Sets the plane of the coordinates x and y of rows, for the next call of SetRows or SetRenderer.
   */
  void SetPlane(const HandlePlane& plane);
  const HandlePlane& GetPlane() const;

  /**
   * Sets one handle for each row; `chosen` is the selected row, or -1. The next render shows them.
   */
  void SetRows(const std::vector<SingularityRow>& rows, int chosen);

  /** Returns the row whose disc is under a pixel, the nearest one of several, or -1. */
  int RowAt(int x, int y) const;

  /** Returns the point of the plane under a pixel, if the line of sight meets the plane. */
  std::optional<std::array<double, 2>> PlanePointAt(double x, double y) const;

  /** Returns the pixel of a point of the plane. */
  std::array<double, 2> PixelOf(const std::array<double, 2>& point) const;

  /** Returns the radius of a disc in pixels. */
  double GetDiscRadius() const;

private:
  struct Handle
  {
    vtkSmartPointer<vtkActor2D> Disc;
    /** The last label is coloured; the others are white copies offset by a pixel, its outline. */
    std::vector<vtkSmartPointer<vtkTextActor>> Labels;
    /** Quarter index that is drawn, and whether as the selected row. */
    std::optional<std::pair<int, bool>> Drawn;
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
