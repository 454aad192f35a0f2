#include "DesignerLook.h"

#include "HandlePlane.h"
#include "Look.h"

#include "pqDataRepresentation.h"
#include "pqPipelineSource.h"
#include "pqView.h"
#include "vtkBoundingBox.h"
#include "vtkDataObject.h"
#include "vtkMath.h"
#include "vtkPVDataInformation.h"
#include "vtkSMPropertyHelper.h"
#include "vtkSMProxy.h"
#include "vtkSMSourceProxy.h"

#include <QTimer>

namespace
{
using Look::Colour;
using Look::Set;

constexpr int SummaryPort = 4;

/// The normal of the layout's plane, on the side that is looked at.
HandlePlane::Vector TowardsEye(vtkSMProxy* designer, pqDataRepresentation* representation)
{
  designer->UpdatePropertyInformation(designer->GetProperty("Plane"));
  HandlePlane::Vector normal =
    HandlePlane::Of(vtkSMPropertyHelper(designer, "Plane").GetDoubleArray()).Normal();
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

/// What the layout is good for, as a text below it.
void ShowSummary(pqDataRepresentation* representation)
{
  vtkSMProxy* shown = representation->getProxy();
  vtkSMPropertyHelper(shown, "WindowLocation").Set("Lower Center");
  Set(shown, "FontSize", 12.0);
  shown->UpdateVTKObjects();
  // It is put into its view after that.
  QTimer::singleShot(0, representation,
    [representation]
    {
      // The colours of the palette go together; those of a view of its own need not.
      vtkSMProxy* view =
        representation->getView() ? representation->getView()->getProxy() : nullptr;
      if (view == nullptr ||
        vtkSMPropertyHelper(view, "UseColorPaletteForBackground").GetAsInt() != 0)
      {
        return;
      }
      Colour background;
      vtkSMPropertyHelper(view, "Background").Get(background.data(), 3);
      const double brightness = (background[0] + background[1] + background[2]) / 3;
      const double grey = brightness > 0.5 ? 0 : 1;
      const Colour colour = { grey, grey, grey };
      vtkSMPropertyHelper(representation->getProxy(), "Color").Set(colour.data(), 3);
      representation->getProxy()->UpdateVTKObjects();
      representation->renderViewEventually();
    });
}
}

//------------------------------------------------------------------------------
bool DesignerLook::IsText(int port)
{
  return port == SummaryPort;
}

//------------------------------------------------------------------------------
void DesignerLook::Show(pqPipelineSource* source, pqDataRepresentation* representation, int port)
{
  vtkSMProxy* shown = representation->getProxy();
  if (IsText(port))
  {
    // A text, also where there is no layout; a spreadsheet has no place for one.
    if (shown->GetProperty("WindowLocation") != nullptr)
    {
      ShowSummary(representation);
    }
    return;
  }
  const vtkBoundingBox box(source->getSourceProxy()->GetDataInformation(1)->GetBounds());
  const HandlePlane::Vector up = TowardsEye(source->getProxy(), representation);
  const auto lift = [&](double part)
  {
    // By less than can be seen from aside.
    const double height = box.IsValid() ? part * box.GetDiagonalLength() : 0;
    const HandlePlane::Vector place = { height * up[0], height * up[1], height * up[2] };
    vtkSMPropertyHelper(shown, "Position").Set(place.data(), 3);
  };
  Look::SetFlat(shown);
  switch (port)
  {
  case 0:
    Set(shown, "LineWidth", 3.0);
    lift(0.0005);
    Look::ColourBy(shown, vtkDataObject::CELL, "Shade", Look::SignColours(Look::PaleGrey));
    break;
  case 1:
    Look::ShowFaces(shown);
    break;
  case 2:
    Look::ShowSingularities(shown);
    lift(0.001);
    break;
  default:
    Set(shown, "Representation", "Wireframe");
    lift(0.00025);
    Look::SetColour(shown, Look::Grey);
    break;
  }
  shown->UpdateVTKObjects();
  QTimer::singleShot(0, representation, [representation] { Look::HideLegend(representation); });
}
