#include "TextLook.h"

#include "Look.h"

#include "pqDataRepresentation.h"
#include "pqPipelineSource.h"
#include "pqUndoStack.h"
#include "pqView.h"
#include "vtkDataObject.h"
#include "vtkPVArrayInformation.h"
#include "vtkPVDataInformation.h"
#include "vtkSMPropertyHelper.h"
#include "vtkSMProxy.h"
#include "vtkSMSourceProxy.h"

#include <QTimer>

namespace
{
using Look::Colour;

bool IsAlarm(pqPipelineSource* source, int port)
{
  const vtkPVDataInformation* data =
    source->getSourceProxy()->GetDataInformation(static_cast<unsigned int>(port));
  vtkPVArrayInformation* alarm = data->GetArrayInformation("Alarm", vtkDataObject::FIELD);
  return alarm && alarm->GetComponentRange(0)[1] > 0;
}

/// The colour of what is no alarm.
Colour PlainColour(pqDataRepresentation* representation)
{
  vtkSMProxy* view = representation->getView() ? representation->getView()->getProxy() : nullptr;
  Colour colour = Look::Black;
  if (!view || vtkSMPropertyHelper(view, "UseColorPaletteForBackground").GetAsInt() != 0)
  {
    // ParaView's own goes with its palette.
    vtkSMPropertyHelper(representation->getProxy(), "Color").Get(colour.data(), 3);
    return colour;
  }
  Colour background;
  vtkSMPropertyHelper(view, "Background").Get(background.data(), 3);
  const double brightness = (background[0] + background[1] + background[2]) / 3;
  colour.fill(brightness > 0.5 ? 0 : 1);
  return colour;
}

void Paint(pqDataRepresentation* representation, const Colour& colour)
{
  vtkSMProxy* shown = representation->getProxy();
  Colour now;
  vtkSMPropertyHelper(shown, "Color").Get(now.data(), 3);
  if (now == colour)
  {
    return;
  }
  // It comes with the text, and goes with it: no step of its own.
  SCOPED_UNDO_EXCLUDE();
  vtkSMPropertyHelper(shown, "Color").Set(colour.data(), 3);
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
  // It is put into its view after that.
  QTimer::singleShot(0, representation,
    [source, representation, port]
    {
      const Colour plain = PlainColour(representation);
      const auto paint = [source, representation, port, plain]
      { Paint(representation, IsAlarm(source, port) ? Look::Red : plain); };
      paint();
      QObject::connect(source, QOverload<pqPipelineSource*>::of(&pqPipelineSource::dataUpdated),
        representation, paint);
    });
}
