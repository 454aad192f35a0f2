#include "Look.h"

#include "pqDataRepresentation.h"
#include "pqView.h"
#include "vtkDataObject.h"
#include "vtkNew.h"
#include "vtkSMPVRepresentationProxy.h"
#include "vtkSMPropertyHelper.h"
#include "vtkSMProxy.h"
#include "vtkSMTrace.h"
#include "vtkSMTransferFunctionManager.h"

namespace
{
using Look::Colour;

constexpr std::array<Colour, 5> Pale = { { { 0.98, 0.85, 0.8 }, { 0.82, 0.9, 0.98 },
  { 0.85, 0.96, 0.84 }, { 0.97, 0.94, 0.76 }, { 0.91, 0.85, 0.96 } } };
// Patches or blocks beyond this number take the last colour; useful layouts have fewer.
constexpr int PaleColourCount = 200;
}

namespace Look
{
//------------------------------------------------------------------------------
void Set(vtkSMProxy* proxy, const char* name, double value)
{
  vtkSMPropertyHelper(proxy, name).Set(value);
}

//------------------------------------------------------------------------------
void Set(vtkSMProxy* proxy, const char* name, const char* value)
{
  vtkSMPropertyHelper(proxy, name).Set(value);
}

//------------------------------------------------------------------------------
void SetFlat(vtkSMProxy* shown)
{
  Set(shown, "Ambient", 1.0);
  Set(shown, "Diffuse", 0.0);
}

//------------------------------------------------------------------------------
void SetColour(vtkSMProxy* shown, const Colour& colour)
{
  vtkSMPropertyHelper(shown, "ColorArrayName").SetInputArrayToProcess(vtkDataObject::POINT, "");
  vtkSMPropertyHelper(shown, "AmbientColor").Set(colour.data(), 3);
  vtkSMPropertyHelper(shown, "DiffuseColor").Set(colour.data(), 3);
}

//------------------------------------------------------------------------------
void AddColour(std::vector<double>& points, double value, const Colour& colour)
{
  points.push_back(value);
  points.insert(points.end(), colour.begin(), colour.end());
}

//------------------------------------------------------------------------------
std::vector<double> SignColours(const Colour& ofZero)
{
  std::vector<double> points;
  AddColour(points, -1, Blue);
  AddColour(points, 0, ofZero);
  AddColour(points, 1, Red);
  return points;
}

//------------------------------------------------------------------------------
std::vector<double> PaleColours()
{
  std::vector<double> points;
  for (int number = 0; number < PaleColourCount; ++number)
  {
    AddColour(points, number, Pale[number * 7 % 5]);
  }
  return points;
}

//------------------------------------------------------------------------------
std::vector<double> PatchColours()
{
  std::vector<double> points;
  AddColour(points, -1, { 0.95, 0.95, 0.95 });
  for (std::size_t number = 0; number < Pale.size(); ++number)
  {
    AddColour(points, static_cast<double>(number), Pale[number]);
  }
  return points;
}

//------------------------------------------------------------------------------
void SetColourMap(vtkSMProxy* shown, const char* array, const std::vector<double>& points)
{
  const vtkNew<vtkSMTransferFunctionManager> manager;
  vtkSMProxy* colours = manager->GetColorTransferFunction(array, shown->GetSessionProxyManager());
  SM_SCOPED_TRACE(PropertiesModified).arg("proxy", colours);
  vtkSMPropertyHelper(colours, "AutomaticRescaleRangeMode")
    .Set(vtkSMTransferFunctionManager::NEVER);
  vtkSMPropertyHelper(colours, "ColorSpace").Set("RGB");
  vtkSMPropertyHelper(colours, "Discretize").Set(0);
  vtkSMPropertyHelper(colours, "RGBPoints")
    .Set(points.data(), static_cast<unsigned int>(points.size()));
  colours->UpdateVTKObjects();
}

//------------------------------------------------------------------------------
void ColourBy(vtkSMProxy* shown, int association, const char* array)
{
  const vtkNew<vtkSMTransferFunctionManager> manager;
  vtkSMProxy* colours = manager->GetColorTransferFunction(array, shown->GetSessionProxyManager());
  // Does not access the data, which may not exist yet.
  vtkSMPropertyHelper(shown, "ColorArrayName").SetInputArrayToProcess(association, array);
  vtkSMPropertyHelper(shown, "LookupTable").Set(colours);
}

//------------------------------------------------------------------------------
void ShowSingularities(vtkSMProxy* shown)
{
  Set(shown, "Representation", "Points");
  Set(shown, "PointSize", 12.0);
  Set(shown, "RenderPointsAsSpheres", 1.0);
  ColourBy(shown, vtkDataObject::POINT, "QuarterIndex");
}

//------------------------------------------------------------------------------
void SetSingularityColours(vtkSMProxy* shown)
{
  SetColourMap(shown, "QuarterIndex", SignColours(Grey));
}

//------------------------------------------------------------------------------
void ShowPatches(vtkSMProxy* shown)
{
  ColourBy(shown, vtkDataObject::CELL, "FaceId");
}

//------------------------------------------------------------------------------
void SetPatchColours(vtkSMProxy* shown)
{
  SetColourMap(shown, "FaceId", PaleColours());
}

//------------------------------------------------------------------------------
void HideLegend(pqDataRepresentation* representation)
{
  auto* coloured = vtkSMPVRepresentationProxy::SafeDownCast(representation->getProxy());
  if (representation->getView() && coloured && coloured->GetUsingScalarColoring())
  {
    coloured->SetScalarBarVisibility(representation->getView()->getProxy(), false);
  }
}
}
