#include "TextLook.h"

#include "AfterRun.h"
#include "Look.h"

#include "pqDataRepresentation.h"
#include "pqOutputPort.h"
#include "pqPipelineSource.h"
#include "pqUndoStack.h"
#include "pqView.h"
#include "vtkAlgorithm.h"
#include "vtkCallbackCommand.h"
#include "vtkDataArray.h"
#include "vtkDataObject.h"
#include "vtkFieldData.h"
#include "vtkNew.h"
#include "vtkPVArrayInformation.h"
#include "vtkPVDataInformation.h"
#include "vtkSMPropertyHelper.h"
#include "vtkSMProxy.h"
#include "vtkSMSourceProxy.h"
#include "vtkSMTrace.h"
#include "vtkWeakPointer.h"

#include <QWidget>

#include <algorithm>
#include <array>
#include <cstring>
#include <functional>
#include <utility>

namespace
{
using Look::Colour;

vtkAlgorithm* AlgorithmOf(vtkSMProxy* proxy)
{
  return vtkAlgorithm::SafeDownCast(proxy->GetClientSideObject());
}

bool IsAlarm(const pqPipelineSource* source, int port)
{
  if (vtkAlgorithm* algorithm = AlgorithmOf(source->getProxy()))
  {
    vtkDataArray* alarm = algorithm->GetOutputDataObject(port)->GetFieldData()->GetArray("Alarm");
    return alarm && alarm->GetTuple1(0) > 0;
  }
  const vtkPVDataInformation* data = vtkSMSourceProxy::SafeDownCast(source->getProxy())
                                       ->GetDataInformation(static_cast<unsigned int>(port));
  vtkPVArrayInformation* alarm = data->GetArrayInformation("Alarm", vtkDataObject::FIELD);
  return alarm && alarm->GetComponentRange(0)[1] > 0;
}

/** Returns the text colour without alarm. */
Colour PlainColour(pqDataRepresentation* representation)
{
  vtkSMProxy* view = representation->getView() ? representation->getView()->getProxy() : nullptr;
  Colour colour = Look::Black;
  if (!view || vtkSMPropertyHelper(view, "UseColorPaletteForBackground").GetAsInt() != 0)
  {
    // ParaView's own colour matches its palette.
    vtkSMPropertyHelper(representation->getProxy(), "Color").Get(colour.data(), 3);
    return colour;
  }
  Colour background;
  vtkSMPropertyHelper(view, "Background").Get(background.data(), 3);
  const double brightness = (background[0] + background[1] + background[2]) / 3;
  colour.fill(brightness > 0.5 ? 0 : 1);
  return colour;
}

/**
 * Paints now and after each update of a proxy, during the lifetime of the representation. With the
 * built-in server it observes the algorithm, since the client is not notified of updates during a
 * drag.
 */
class Painter final : public QObject
{
public:
  Painter(vtkSMProxy* proxy, pqDataRepresentation* representation, std::function<void()> paint)
    : QObject(representation)
    , Paint(std::move(paint))
    , Observed(AlgorithmOf(proxy))
  {
    this->Update->SetClientData(this);
    this->Update->SetCallback(
      [](vtkObject*, unsigned long, void* self, void*) { static_cast<Painter*>(self)->Paint(); });
    const unsigned long event = this->Observed ? vtkCommand::EndEvent : vtkCommand::UpdateDataEvent;
    if (!this->Observed)
    {
      this->Observed = proxy;
    }
    this->Observed->AddObserver(event, this->Update);
    this->Paint();
  }
  ~Painter() override
  {
    if (this->Observed)
    {
      this->Observed->RemoveObserver(this->Update);
    }
  }

private:
  std::function<void()> Paint;
  vtkNew<vtkCallbackCommand> Update;
  vtkWeakPointer<vtkObject> Observed;
};

bool IsTaken(const char* location, pqDataRepresentation* representation)
{
  const QList<pqRepresentation*> all = representation->getView()->getRepresentations();
  return std::any_of(all.begin(), all.end(),
    [&](pqRepresentation* other)
    {
      return other != representation && other->isVisible() &&
        other->getProxy()->GetProperty("WindowLocation") &&
        std::strcmp(
          vtkSMPropertyHelper(other->getProxy(), "WindowLocation").GetAsString(), location) == 0;
    });
}

/** Moves a text to a place of the view where there is no other text. */
void FindPlace(pqDataRepresentation* representation)
{
  vtkSMProxy* shown = representation->getProxy();
  if (!representation->getView() ||
    !IsTaken(vtkSMPropertyHelper(shown, "WindowLocation").GetAsString(), representation))
  {
    return;
  }
  for (const char* location : { "Upper Center", "Lower Center", "Upper Left Corner" })
  {
    if (!IsTaken(location, representation))
    {
      SCOPED_UNDO_EXCLUDE();
      SM_SCOPED_TRACE(PropertiesModified).arg("proxy", shown);
      vtkSMPropertyHelper(shown, "WindowLocation").Set(location);
      shown->UpdateVTKObjects();
      return;
    }
  }
}

/** Shows a text as an alarm, or in a colour without a backdrop. */
void Paint(pqDataRepresentation* representation, bool isAlarm, const Colour& plain)
{
  vtkSMProxy* shown = representation->getProxy();
  const Colour& colour = isAlarm ? Look::Red : plain;
  Colour now;
  vtkSMPropertyHelper(shown, "Color").Get(now.data(), 3);
  if (now == colour)
  {
    return;
  }
  // The colour belongs to the text and is not an undo step of its own.
  SCOPED_UNDO_EXCLUDE();
  vtkSMPropertyHelper(shown, "Color").Set(colour.data(), 3);
  if (shown->GetProperty("BackgroundColor"))
  {
    // ParaView draws the background with the border only, whose thickness is 0 by default.
    constexpr std::array<double, 4> White = { 1, 1, 1, 1 };
    vtkSMPropertyHelper(shown, "BackgroundColor").Set(White.data(), 4);
    vtkSMPropertyHelper(shown, "ShowBorder").Set(isAlarm ? "Always" : "Never");
    Look::Set(shown, "Padding", 5.0);
  }
  shown->UpdateVTKObjects();
  representation->renderViewEventually();
}
}

//------------------------------------------------------------------------------
void TextLook::Show(
  pqPipelineSource* source, pqDataRepresentation* representation, int port, const char* location)
{
  vtkSMProxy* shown = representation->getProxy();
  if (!shown->GetProperty("WindowLocation"))
  {
    return;
  }
  SCOPED_UNDO_EXCLUDE();
  vtkSMPropertyHelper(shown, "WindowLocation").Set(location);
  Look::Set(shown, "FontSize", 12.0);
  shown->UpdateVTKObjects();
  // The representation is added to its view after this call.
  AfterRun(representation,
    [source, representation, port]
    {
      FindPlace(representation);
      const Colour plain = PlainColour(representation);
      new Painter(source->getProxy(), representation,
        [source, representation, port, plain]
        { Paint(representation, IsAlarm(source, port), plain); });
    });
}

//------------------------------------------------------------------------------
bool TextLook::ReportsProblem(const pqPipelineSource* source)
{
  for (int port = 0; port < source->getNumberOfOutputPorts(); ++port)
  {
    for (const pqDataRepresentation* shown : source->getOutputPort(port)->getRepresentations(nullptr))
    {
      pqView* view = shown->getView();
      if (view && view->widget() && view->widget()->isVisible() && shown->isVisible() &&
        shown->getProxy()->GetProperty("WindowLocation"))
      {
        vtkSMSourceProxy::SafeDownCast(source->getProxy())->UpdatePipeline(); // as the next render does
        return IsAlarm(source, port);
      }
    }
  }
  return false;
}
