#include "DesignerLook.h"

#include "pqApplicationCore.h"
#include "pqDataRepresentation.h"
#include "pqObjectBuilder.h"
#include "pqPipelineSource.h"
#include "pqView.h"
#include "vtkBoundingBox.h"
#include "vtkDataObject.h"
#include "vtkNew.h"
#include "vtkPVDataInformation.h"
#include "vtkSMPVRepresentationProxy.h"
#include "vtkSMPropertyHelper.h"
#include "vtkSMProxy.h"
#include "vtkSMSourceProxy.h"
#include "vtkSMTransferFunctionManager.h"

#include <QTimer>

#include <array>
#include <cstring>
#include <memory>
#include <vector>

namespace
{
using Colour = std::array<double, 3>;

// Those of the handles and of states/design.py.
constexpr Colour Blue = { 0.1, 0.2, 0.85 };
constexpr Colour Grey = { 0.6, 0.6, 0.6 };
constexpr Colour PaleGrey = { 0.75, 0.75, 0.75 };
constexpr Colour Red = { 0.85, 0.1, 0.1 };
constexpr std::array<Colour, 5> Pale = { { { 0.98, 0.85, 0.8 }, { 0.82, 0.9, 0.98 },
  { 0.85, 0.96, 0.84 }, { 0.97, 0.94, 0.76 }, { 0.91, 0.85, 0.96 } } };
// Of more faces the last colour; a layout that is a help has fewer.
constexpr int Faces = 200;
constexpr int SummaryPort = 4;

void Set(vtkSMProxy* proxy, const char* name, double value)
{
  vtkSMPropertyHelper(proxy, name).Set(value);
}

void SetColour(vtkSMProxy* shown, const Colour& colour)
{
  vtkSMPropertyHelper(shown, "AmbientColor").Set(colour.data(), 3);
  vtkSMPropertyHelper(shown, "DiffuseColor").Set(colour.data(), 3);
}

void AddColour(std::vector<double>& points, double value, const Colour& colour)
{
  points.push_back(value);
  points.insert(points.end(), colour.begin(), colour.end());
}

/// Colours of the signs -1, 0 and 1.
std::vector<double> SignColours(const Colour& ofZero)
{
  std::vector<double> points;
  AddColour(points, -1, Blue);
  AddColour(points, 0, ofZero);
  AddColour(points, 1, Red);
  return points;
}

std::vector<double> FaceColours()
{
  std::vector<double> points;
  for (int face = 0; face < Faces; ++face)
  {
    AddColour(points, face, Pale[static_cast<std::size_t>(face * 7 % 5)]);
  }
  return points;
}

void ColourBy(
  vtkSMProxy* shown, int association, const char* array, const std::vector<double>& points)
{
  const vtkNew<vtkSMTransferFunctionManager> manager;
  vtkSMProxy* colours = manager->GetColorTransferFunction(array, shown->GetSessionProxyManager());
  vtkSMPropertyHelper(colours, "AutomaticRescaleRangeMode")
    .Set(vtkSMTransferFunctionManager::NEVER);
  vtkSMPropertyHelper(colours, "ColorSpace").Set("RGB");
  vtkSMPropertyHelper(colours, "Discretize").Set(0);
  vtkSMPropertyHelper(colours, "RGBPoints")
    .Set(points.data(), static_cast<unsigned int>(points.size()));
  colours->UpdateVTKObjects();
  // Without a look at the data, which there may not be yet.
  vtkSMPropertyHelper(shown, "ColorArrayName").SetInputArrayToProcess(association, array);
  vtkSMPropertyHelper(shown, "LookupTable").Set(colours);
}

bool HasLayout(pqPipelineSource* designer)
{
  return designer->getSourceProxy()->GetDataInformation(0)->GetNumberOfCells() > 0;
}

/// What the layout is good for, as a text below it.
void ShowSummary(pqDataRepresentation* representation)
{
  vtkSMProxy* shown = representation->getProxy();
  vtkSMPropertyHelper(shown, "WindowLocation").Set("Lower Center");
  Set(shown, "FontSize", 12);
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

void Show(pqPipelineSource* source, pqDataRepresentation* representation, int port)
{
  vtkSMProxy* shown = representation->getProxy();
  const vtkBoundingBox box(source->getSourceProxy()->GetDataInformation(1)->GetBounds());
  const auto lift = [&](double part)
  {
    // Towards the eye, by less than can be seen from aside.
    const std::array<double, 3> place = { 0, 0,
      box.IsValid() ? part * box.GetDiagonalLength() : 0 };
    vtkSMPropertyHelper(shown, "Position").Set(place.data(), 3);
  };
  Set(shown, "Ambient", 1);
  Set(shown, "Diffuse", 0);
  switch (port)
  {
  case 0:
    Set(shown, "LineWidth", 3);
    lift(0.0005);
    ColourBy(shown, vtkDataObject::CELL, "Shade", SignColours(PaleGrey));
    break;
  case 1:
    ColourBy(shown, vtkDataObject::CELL, "FaceId", FaceColours());
    break;
  case 2:
    vtkSMPropertyHelper(shown, "Representation").Set("Points");
    Set(shown, "PointSize", 12);
    Set(shown, "RenderPointsAsSpheres", 1);
    lift(0.001);
    ColourBy(shown, vtkDataObject::POINT, "QuarterIndex", SignColours(Grey));
    break;
  default:
    vtkSMPropertyHelper(shown, "Representation").Set("Wireframe");
    lift(0.00025);
    SetColour(shown, Grey);
    break;
  }
  shown->UpdateVTKObjects();
  // ParaView shows legends after that.
  QTimer::singleShot(0, representation,
    [representation]
    {
      if (representation->getView() &&
        vtkSMPVRepresentationProxy::GetUsingScalarColoring(representation->getProxy()))
      {
        vtkSMPVRepresentationProxy::SetScalarBarVisibility(
          representation->getProxy(), representation->getView()->getProxy(), false);
      }
    });
}

void ShowAtFirst(pqPipelineSource* source)
{
  if (std::strcmp(source->getProxy()->GetXMLName(), "LayoutDesigner") != 0)
  {
    return;
  }
  QObject::connect(source, &pqPipelineSource::representationAdded, source,
    [](pqPipelineSource* designer, pqDataRepresentation* added, int port)
    {
      if (port == SummaryPort)
      {
        // A text, also where there is no layout; a spreadsheet has no place for one.
        if (added->getProxy()->GetProperty("WindowLocation") != nullptr)
        {
          ShowSummary(added);
        }
        return;
      }
      // A spreadsheet or the like has none of this.
      if (!vtkSMPVRepresentationProxy::SafeDownCast(added->getProxy()))
      {
        return;
      }
      if (HasLayout(designer))
      {
        Show(designer, added, port);
        return;
      }
      // When what is wrong with the input has been mended; ParaView warns of colours by arrays that there are not.
      const auto later = std::make_shared<QMetaObject::Connection>();
      *later = QObject::connect(designer,
        QOverload<pqPipelineSource*>::of(&pqPipelineSource::dataUpdated), added,
        [designer, added, port, later](pqPipelineSource*)
        {
          if (HasLayout(designer))
          {
            QObject::disconnect(*later);
            Show(designer, added, port);
          }
        });
    });
}
}

//------------------------------------------------------------------------------
DesignerLook::DesignerLook(QObject* parent)
  : QObject(parent)
{
}

//------------------------------------------------------------------------------
void DesignerLook::startup()
{
  QObject::connect(pqApplicationCore::instance()->getObjectBuilder(),
    &pqObjectBuilder::filterCreated, this, &ShowAtFirst);
}

//------------------------------------------------------------------------------
void DesignerLook::shutdown()
{
  if (pqApplicationCore* core = pqApplicationCore::instance())
  {
    QObject::disconnect(core->getObjectBuilder(), nullptr, this, nullptr);
  }
}
