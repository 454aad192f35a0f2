/**
 * @class   StalePicture
 * @brief   the last picture of a view, in grey, while there is no result to show
 *
 * If handles are where a filter has no result, its output is empty, or that of earlier positions.
 * The view then shows its last picture in grey, below texts and handles. The pipeline and its data
 * are not affected.
 */

#ifndef StalePicture_h
#define StalePicture_h

#include "vtkSmartPointer.h"
#include "vtkWeakPointer.h"

#include <array>

class vtkActor2D;
class vtkPVRenderView;

class StalePicture
{
public:
  ~StalePicture();

  /** Draws the view without texts and handles, with the data of its last update, and shows it. */
  void Show(vtkPVRenderView* view);
  void Hide();
  bool IsShown() const;
  /** Returns whether the camera and the size of the view are those of the picture. */
  bool FitsView() const;

private:
  using Perspective = std::array<double, 12>;
  static Perspective PerspectiveOf(vtkPVRenderView* view);

  vtkWeakPointer<vtkPVRenderView> View;
  vtkSmartPointer<vtkActor2D> Actor;
  Perspective Taken{};
};

#endif
