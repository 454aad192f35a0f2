#include "DefaultDisplay.h"

#include "AfterRun.h"
#include "DesignerLook.h"
#include "Look.h"
#include "TextLook.h"

#include "pqApplicationCore.h"
#include "pqDataRepresentation.h"
#include "pqObjectBuilder.h"
#include "pqPipelineSource.h"
#include "pqUndoStack.h"
#include "pqView.h"
#include "vtkDataObject.h"
#include "vtkNew.h"
#include "vtkPVDataInformation.h"
#include "vtkPVRepresentedArrayListSettings.h"
#include "vtkSMPVRepresentationProxy.h"
#include "vtkSMPropertyHelper.h"
#include "vtkSMProxy.h"
#include "vtkSMSourceProxy.h"
#include "vtkSMTrace.h"
#include "vtkSMTransferFunctionManager.h"
#include "vtkSMTransferFunctionProxy.h"


#include <algorithm>
#include <array>
#include <cstring>
#include <memory>
#include <vector>

namespace
{
using Look::Set;

//------------------------------------------------------------------------------
void ShowOutline(vtkSMProxy* shown)
{
  Look::SetColour(shown, Look::Black);
  Set(shown, "LineWidth", 3.0);
}

//------------------------------------------------------------------------------
void ShowMesh(vtkSMProxy* shown)
{
  Set(shown, "Representation", "Surface With Edges");
  Look::SetColour(shown, Look::PaleBlue);
  vtkSMPropertyHelper(shown, "EdgeColor").Set(Look::Grey.data(), 3);
}

//------------------------------------------------------------------------------
void SetNormColours(vtkSMProxy* shown)
{
  // Dark where the field vanishes, light at norm 1, where black crosses are visible.
  std::vector<double> points;
  Look::AddColour(points, 0, { 0.2, 0.08, 0.3 });
  Look::AddColour(points, 0.5, { 0.35, 0.55, 0.8 });
  Look::AddColour(points, 1, { 0.93, 0.96, 1 });
  Look::SetColourMap(shown, "CrossNorm", points);
}

//------------------------------------------------------------------------------
void ShowNorm(vtkSMProxy* shown)
{
  Look::ColourBy(shown, vtkDataObject::POINT, "CrossNorm");
}

//------------------------------------------------------------------------------
void ShowSizes(vtkSMProxy* shown)
{
  if (auto* representation = vtkSMPVRepresentationProxy::SafeDownCast(shown))
  {
    representation->SetScalarColoring("SizeMap", vtkDataObject::POINT);
  }
  if (vtkSMProxy* colours = vtkSMPropertyHelper(shown, "LookupTable").GetAsProxy())
  {
    vtkSMTransferFunctionProxy::ApplyPreset(colours, "Viridis (matplotlib)");
  }
}

//------------------------------------------------------------------------------
void ShowCrosses(vtkSMProxy* shown)
{
  Look::SetColour(shown, Look::Black);
}

//------------------------------------------------------------------------------
void ShowLines(vtkSMProxy* shown)
{
  Look::SetColour(shown, Look::Black);
  Set(shown, "LineWidth", 2.0);
}

//------------------------------------------------------------------------------
void ShowQuads(vtkSMProxy* shown)
{
  Set(shown, "Representation", "Surface With Edges");
  vtkSMPropertyHelper(shown, "EdgeColor").Set(Look::Grey.data(), 3);
  Look::ColourBy(shown, vtkDataObject::CELL, "BlockId");
}

//------------------------------------------------------------------------------
void SetBlockColours(vtkSMProxy* shown)
{
  Look::SetColourMap(shown, "BlockId", Look::PaleColours());
}

//------------------------------------------------------------------------------
/** Applies a display to an output that the user shows only on demand. */
template <void (*show)(vtkSMProxy*)>
void Hide(vtkSMProxy* shown)
{
  show(shown);
  Set(shown, "Visibility", 0.0);
}

struct Rule
{
  const char* proxy;
  int port;
  void (*show)(vtkSMProxy*);
  void (*setColourMap)(vtkSMProxy*) = nullptr; ///< Before `show`.
  bool hasLegend = false;
};

constexpr std::array<Rule, 27> Rules = { {
  { "PlanarDomainSource", 0, ShowOutline },
  { "PlanarDomainReader", 0, ShowOutline },
  { "DrawingReader", 0, ShowOutline },
  { "SingularitySource", 0, Look::ShowSingularities, Look::SetSingularityColours },
  { "SingularityHandles", 0, Look::ShowSingularities, Look::SetSingularityColours },
  { "ConfigurationProposal", 0, Look::ShowSingularities, Look::SetSingularityColours },
  { "SingularityOptimizer", 0, Look::ShowSingularities, Look::SetSingularityColours },
  { "CrossFieldSingularities", 0, Look::ShowSingularities, Look::SetSingularityColours },
  { "DrillHoles", 0, ShowMesh },
  { "PerforatedCrossField", 0, ShowNorm, SetNormColours, true },
  { "GinzburgLandauCrossField", 0, ShowNorm, SetNormColours, true },
  { "HField", 0, ShowSizes, nullptr, true },
  { "CrossGlyphs", 0, ShowCrosses },
  { "Separatrices", 0, ShowLines },
  { "Separatrices", 1, Look::ShowPatches, Look::SetPatchColours },
  { "QuadMesher", 0, ShowQuads, SetBlockColours },
  { "QuadMesher", 1, Hide<ShowQuads>, SetBlockColours }, // the blocks would cover the quads
  { "QuadMesher", 2, ShowOutline },
  { "QuadMesher", 3, Hide<Look::ShowSingularities>, Look::SetSingularityColours }, // the irregular nodes are shown
  { "QuadMesher", 4, Hide<Look::ShowSingularities>, Look::SetSingularityColours }, // corners are visible in the outline
  { "QuadMesher", 5, Hide<ShowOutline> },
  { "QuadMesher", 6, Look::ShowSingularities, Look::SetSingularityColours },
  { "QuadMesher", 7, Hide<ShowLines> },
  { "SmoothQuads", 0, ShowQuads, SetBlockColours },
  // ParaView 5.11 crashes if edges of order 2 have a Nonlinear Subdivision Level above 1.
  { "QuadsToHigherOrder", 0, ShowQuads, SetBlockColours },
  { "ExtrudeQuads", 0, ShowQuads, SetBlockColours },
  { "ExtrudeQuads", 1, Hide<ShowQuads>, SetBlockColours },
} };

/** Output that is a text for the view. */
struct Text
{
  const char* proxy;
  int port;
  const char* location;
};

// Texts on inputs are at the top, texts on results at the bottom.
constexpr std::array<Text, 4> Texts = { {
  { "PoincareHopfCheck", 3, "Upper Left Corner" },
  { "PerforatedCrossField", 1, "Lower Center" },
  { "LayoutDesigner", 4, "Lower Center" },
  { "QuadMesher", 8, "Lower Center" },
} };

bool IsProxy(pqPipelineSource* source, const char* proxy)
{
  return std::strcmp(source->getProxy()->GetXMLName(), proxy) == 0;
}

//------------------------------------------------------------------------------
const Text* TextOf(pqPipelineSource* source, int port)
{
  const auto* text = std::find_if(Texts.begin(), Texts.end(),
    [&](const Text& one) { return one.port == port && IsProxy(source, one.proxy); });
  return text == Texts.end() ? nullptr : text;
}

//------------------------------------------------------------------------------
void ApplyDefaults(pqPipelineSource* source, pqDataRepresentation* representation, int port)
{
  // Part of the creation of the source, not an undo step of its own.
  SCOPED_UNDO_EXCLUDE();
  if (IsProxy(source, "LayoutDesigner"))
  {
    DesignerLook::Show(source, representation, port);
    return;
  }
  for (const Rule& rule : Rules)
  {
    if (IsProxy(source, rule.proxy) && rule.port == port)
    {
      vtkSMProxy* shown = representation->getProxy();
      vtkSMProxy* view =
        representation->getView() ? representation->getView()->getProxy() : nullptr;
      vtkSMProxy* chosen =
        vtkSMPropertyHelper(shown, "LookupTable").GetAsProxy(); // ParaView's choice
      if (rule.setColourMap)
      {
        rule.setColourMap(shown);
      }
      {
        // A trace replays the same picture.
        SM_SCOPED_TRACE(PropertiesModified).arg("proxy", shown);
        Look::SetFlat(shown);
        rule.show(shown);
        shown->UpdateVTKObjects();
      }
      if (chosen && view)
      {
        vtkNew<vtkSMTransferFunctionManager>()->HideScalarBarIfNotNeeded(chosen, view);
      }
      auto* coloured = vtkSMPVRepresentationProxy::SafeDownCast(shown);
      if (view && coloured && coloured->GetUsingScalarColoring())
      {
        coloured->SetScalarBarVisibility(view, rule.hasLegend);
      }
      representation->renderViewEventually();
    }
  }
}

bool HasData(pqPipelineSource* source, int port)
{
  const auto output = static_cast<unsigned int>(port);
  return source->getSourceProxy()->GetDataInformation(output)->GetNumberOfPoints() > 0;
}

//------------------------------------------------------------------------------
/** Leaves the field data that describe a drawing to other filters out of the lists of colours. */
void HideDrawingData()
{
  vtkPVRepresentedArrayListSettings* settings = vtkPVRepresentedArrayListSettings::GetInstance();
  const int count = settings->GetNumberOfFilterExpressions();
  settings->SetNumberOfFilterExpressions(count + 1);
  settings->SetFilterExpression(count, "^(Curve(Kind|Offset|Values)|DrawingUnit|LargestGap)$");
}

//------------------------------------------------------------------------------
void ApplyAtFirstShow(pqPipelineSource* source)
{
  QObject::connect(source, &pqPipelineSource::representationAdded, source,
    [](pqPipelineSource* made, pqDataRepresentation* added, int port)
    {
      if (const Text* text = TextOf(made, port))
      {
        // Shown even if the other outputs are empty.
        TextLook::Show(made, added, port, text->location);
        return;
      }
      // Spreadsheets and charts have no such settings.
      if (!vtkSMPVRepresentationProxy::SafeDownCast(added->getProxy()))
      {
        return;
      }
      if (HasData(made, port))
      {
        // Applied after ParaView's own defaults.
        AfterRun(added, [made, added, port] { ApplyDefaults(made, added, port); });
        return;
      }
      // If there are no data yet, the display is applied after the first update that yields some,
      // because ParaView warns of colouring by a missing array.
      const auto later = std::make_shared<QMetaObject::Connection>();
      *later = QObject::connect(made,
        QOverload<pqPipelineSource*>::of(&pqPipelineSource::dataUpdated), added,
        [made, added, port, later](pqPipelineSource*)
        {
          if (HasData(made, port))
          {
            QObject::disconnect(*later);
            ApplyDefaults(made, added, port);
          }
        });
    });
}
}

//------------------------------------------------------------------------------
DefaultDisplay::DefaultDisplay(QObject* parent)
  : QObject(parent)
{
}

//------------------------------------------------------------------------------
void DefaultDisplay::startup()
{
  HideDrawingData();
  pqObjectBuilder* builder = pqApplicationCore::instance()->getObjectBuilder();
  QObject::connect(builder, &pqObjectBuilder::filterCreated, this, &ApplyAtFirstShow);
  QObject::connect(builder, &pqObjectBuilder::sourceCreated, this, &ApplyAtFirstShow);
  QObject::connect(builder,
    QOverload<pqPipelineSource*, const QString&>::of(&pqObjectBuilder::readerCreated), this,
    [](pqPipelineSource* reader, const QString&) { ApplyAtFirstShow(reader); });
}

//------------------------------------------------------------------------------
void DefaultDisplay::shutdown()
{
  if (pqApplicationCore* core = pqApplicationCore::instance())
  {
    QObject::disconnect(core->getObjectBuilder(), nullptr, this, nullptr);
  }
}
