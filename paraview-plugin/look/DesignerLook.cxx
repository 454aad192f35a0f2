#include "DesignerLook.h"

#include "AfterRun.h"
#include "HandlePlane.h"
#include "Look.h"

#include "pqDataRepresentation.h"
#include "pqPipelineSource.h"
#include "pqView.h"
#include "vtkBoundingBox.h"
#include "vtkDataObject.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkPVDataInformation.h"
#include "vtkSMPropertyHelper.h"
#include "vtkSMProxy.h"
#include "vtkSMSourceProxy.h"
#include "vtkSMTrace.h"
#include "vtkSMTransferFunctionManager.h"
#include "vtkWeakPointer.h"


namespace
{
using Look::Set;

bool HasTriangles(vtkSMProxy* designer)
{
  designer->UpdatePropertyInformation(designer->GetProperty("Triangles"));
  return vtkSMPropertyHelper(designer, "Triangles").GetNumberOfElements() > 0;
}

/** Returns the normal of the layout's plane towards the camera. */
HandlePlane::Vector TowardsEye(vtkSMProxy* designer, pqDataRepresentation* representation)
{
  designer->UpdatePropertyInformation(designer->GetProperty("Plane"));
  HandlePlane::Vector normal =
    HandlePlane::FromNumbers(vtkSMPropertyHelper(designer, "Plane").GetDoubleArray()).Normal();
  if (representation->getView() != nullptr)
  {
    vtkSMProxy* view = representation->getView()->getProxy();
    HandlePlane::Vector eye;
    HandlePlane::Vector focus;
    vtkSMPropertyHelper(view, "CameraPosition").Get(eye.data(), 3);
    vtkSMPropertyHelper(view, "CameraFocalPoint").Get(focus.data(), 3);
    vtkMath::Subtract(eye.data(), focus.data(), eye.data());
    if (vtkMath::Dot(eye.data(), normal.data()) < 0)
    {
      vtkMath::MultiplyScalar(normal.data(), -1);
    }
  }
  return normal;
}
}

//------------------------------------------------------------------------------
void DesignerLook::Show(pqPipelineSource* source, pqDataRepresentation* representation, int port)
{
  vtkSMProxy* shown = representation->getProxy();
  const vtkWeakPointer<vtkSMProxy> chosen =
    vtkSMPropertyHelper(shown, "LookupTable").GetAsProxy(); // ParaView's choice, with a legend
  const vtkBoundingBox box(source->getSourceProxy()->GetDataInformation(1)->GetBounds());
  const HandlePlane::Vector up = TowardsEye(source->getProxy(), representation);
  const bool isOnSurface = HasTriangles(source->getProxy());
  const auto lift = [&](double part)
  {
    if (isOnSurface)
    {
      Set(shown, "RenderLinesAsTubes", 1.0); // in front of the patches from all sides
      if (port == 3)
      {
        Set(shown, "LineWidth", 1.5);
      }
      return;
    }
    // Too small to be visible from the side.
    const double height = box.IsValid() ? part * box.GetDiagonalLength() : 0;
    const HandlePlane::Vector position = { height * up[0], height * up[1], height * up[2] };
    const char* const name = shown->GetProperty("Translation") ? "Translation" : "Position"; // ParaView 5.13
    vtkSMPropertyHelper(shown, name).Set(position.data(), 3);
  };
  switch (port)
  {
  case 0:
    Look::SetColourMap(shown, "Shade", Look::SignColours(Look::PaleGrey));
    break;
  case 1:
    Look::SetColourMap(shown, "Colour", Look::PatchColours());
    break;
  case 2:
    Look::SetSingularityColours(shown);
    break;
  default:
    break;
  }
  SM_SCOPED_TRACE(PropertiesModified).arg("proxy", shown);
  if (!isOnSurface || port != 1) // shading shows the shape
  {
    Look::SetFlat(shown);
  }
  switch (port)
  {
  case 0:
    Set(shown, "LineWidth", 3.0);
    lift(0.0005);
    Look::ColourBy(shown, vtkDataObject::CELL, "Shade");
    break;
  case 1:
    Look::ColourBy(shown, vtkDataObject::CELL, "Colour");
    break;
  case 2:
    Look::ShowSingularities(shown);
    lift(0.001);
    break;
  case 5: // the separatrices include the boundary
    Look::SetColour(shown, Look::Black);
    Set(shown, "Visibility", 0.0);
    break;
  default:
    Set(shown, "Representation", "Wireframe");
    lift(0.00025);
    Look::SetColour(shown, Look::Grey);
    break;
  }
  shown->UpdateVTKObjects();
  AfterRun(representation,
    [representation, chosen]
    {
      Look::HideLegend(representation);
      if (chosen && representation->getView())
      {
        vtkNew<vtkSMTransferFunctionManager>()->HideScalarBarIfNotNeeded(
          chosen, representation->getView()->getProxy());
      }
    });
}
