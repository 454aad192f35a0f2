#include "StalePicture.h"

#include "vtkActor2D.h"
#include "vtkCamera.h"
#include "vtkImageData.h"
#include "vtkImageMapper.h"
#include "vtkNew.h"
#include "vtkPVRenderView.h"
#include "vtkPointData.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkUnsignedCharArray.h"

namespace
{
/**
 * Removes colour and contrast from a picture with three components. The background, which is that
 * of the first pixel, stays.
 */
void Grey(vtkUnsignedCharArray* picture)
{
  constexpr double Contrast = 0.35;
  const std::array<double, 3> background = { picture->GetTypedComponent(0, 0) * 1.0,
    picture->GetTypedComponent(0, 1) * 1.0, picture->GetTypedComponent(0, 2) * 1.0 };
  for (vtkIdType i = 0; i < picture->GetNumberOfTuples(); ++i)
  {
    double brightness = 0.0;
    for (int c = 0; c < 3; ++c)
    {
      brightness += picture->GetTypedComponent(i, c) / 3.0;
    }
    for (int c = 0; c < 3; ++c)
    {
      const double from = background[c];
      // Equal in all components but for the tint of the background.
      const double mean = (background[0] + background[1] + background[2]) / 3.0;
      picture->SetTypedComponent(
        i, c, static_cast<unsigned char>(from + Contrast * (brightness - mean)));
    }
  }
}
}

//------------------------------------------------------------------------------
StalePicture::~StalePicture()
{
  this->Hide();
}

//------------------------------------------------------------------------------
void StalePicture::Show(vtkPVRenderView* view)
{
  this->Hide();
  vtkRenderWindow* window = view->GetRenderWindow();
  vtkRenderer* annotations = view->GetNonCompositedRenderer();
  annotations->DrawOff();
  window->Render();
  annotations->DrawOn();
  const int* size = window->GetSize();
  vtkNew<vtkUnsignedCharArray> pixels;
  window->GetPixelData(0, 0, size[0] - 1, size[1] - 1, 0, pixels);
  if (pixels->GetNumberOfComponents() != 3 || pixels->GetNumberOfTuples() == 0)
  {
    return;
  }
  Grey(pixels);
  vtkNew<vtkImageData> image;
  image->SetDimensions(size[0], size[1], 1);
  image->GetPointData()->SetScalars(pixels);
  vtkNew<vtkImageMapper> mapper;
  mapper->SetInputData(image);
  mapper->SetColorWindow(255);
  mapper->SetColorLevel(127.5);
  this->Actor = vtkSmartPointer<vtkActor2D>::New();
  this->Actor->SetMapper(mapper);
  this->Actor->PickableOff();
  this->View = view;
  this->Taken = PerspectiveOf(view);
  view->GetRenderer()->AddActor2D(this->Actor);
}

//------------------------------------------------------------------------------
void StalePicture::Hide()
{
  if (this->View && this->Actor)
  {
    this->View->GetRenderer()->RemoveActor2D(this->Actor);
  }
  this->Actor = nullptr;
}

//------------------------------------------------------------------------------
bool StalePicture::IsShown() const
{
  return this->Actor != nullptr;
}

//------------------------------------------------------------------------------
bool StalePicture::FitsView() const
{
  return this->View && PerspectiveOf(this->View) == this->Taken;
}

//------------------------------------------------------------------------------
StalePicture::Perspective StalePicture::PerspectiveOf(vtkPVRenderView* view)
{
  vtkCamera* camera = view->GetActiveCamera();
  const double* from = camera->GetPosition();
  const double* to = camera->GetFocalPoint();
  const double* up = camera->GetViewUp();
  const int* size = view->GetRenderWindow()->GetSize();
  return { from[0], from[1], from[2], to[0], to[1], to[2], up[0], up[1], up[2],
    camera->GetParallelScale(), static_cast<double>(size[0]), static_cast<double>(size[1]) };
}
