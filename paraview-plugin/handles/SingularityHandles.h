/**
 * @class   SingularityHandles
 * @brief   discs of constant screen size that represent singularities in a 3D view
 *
 * Discs are red for a positive quarter index, blue for a negative one and grey for zero, with the
 * quarter index beside them; the selected one has a wide dark rim. They are placed in a plane of
 * space and drawn over everything else, or on a surface; there, those on the far side are invisible. This class does
 * not use Qt; ParaView's client owns the renderer.
 */

#ifndef SingularityHandles_h
#define SingularityHandles_h

#include "HandlePlane.h"
#include "HandleSurface.h"
#include "SingularityRows.h"

#include "vtkNew.h"
#include "vtkSmartPointer.h"

#include <optional>
#include <utility>
#include <vector>

class vtkActor2D;
class vtkCallbackCommand;
class vtkObject;
class vtkRenderer;
class vtkTextActor;

class SingularityHandles final
{
public:
  SingularityHandles();
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

  /** Sets the surface that rows with x, y and z are on; if it has no triangles, rows are in the plane. */
  void SetSurface(HandleSurface surface);
  const HandleSurface& GetSurface() const;

  /**
   * Sets one handle for each row; `chosen` is the selected row, or -1. The next render shows them.
   */
  void SetRows(const std::vector<SingularityRow>& rows, int chosen);

  /** Returns the row whose disc is under a pixel, the nearest one of several, or -1. */
  int RowAt(int x, int y) const;

  /** Returns a row at the point of the plane or surface under a pixel, if the line of sight meets it. */
  std::optional<SingularityRow> Moved(const SingularityRow& row, double x, double y) const;

  /** Returns the pixel of a row. */
  std::array<double, 2> PixelOf(const SingularityRow& row) const;

  /** Returns the distance in pixels of the centres of new handles: the field between them is visible. */
  double GetSpacing() const;

  /**
   * Returns a row on the surface whose handle is at a distance of at least the spacing from those of others: under
   * a pixel, or the nearest such position on a spiral around it; `row` if there is none.
   */
  SingularityRow FindFreeRow(const std::vector<SingularityRow>& others, const SingularityRow& row,
    const std::array<double, 2>& pixel) const;

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
  HandlePlane::Vector PlaceOf(const SingularityRow& row) const;
  std::array<HandlePlane::Vector, 2> SightThrough(double x, double y) const;
  static void OnRender(vtkObject* caller, unsigned long event, void* self, void* data);
  void ShowVisible();
  void Add(const Handle& handle);
  void Remove(const Handle& handle);

  vtkSmartPointer<vtkRenderer> Renderer;
  double PixelRatio = 1;
  vtkNew<vtkCallbackCommand> Render;
  HandlePlane Plane;
  HandleSurface Surface;
  std::vector<SingularityRow> Rows;
  std::vector<Handle> Handles;
  int Chosen = -1;
};

#endif
