#ifndef LayoutConversion_h
#define LayoutConversion_h

#include "DomainPlane.h"
#include "LayoutDesign.h"

#include <string>
#include <vector>

class vtkFieldData;
class vtkPolyData;

/** Conversion of layout designs to VTK data; see vtkLayoutDesigner. */
namespace LayoutConversion
{
/** Context of the report of a design. */
struct Report
{
  std::string refusal;    ///< Why the design is outdated; empty if it is current.
  double quadSize = 0.0;  ///< Side length of quads, the unit in which the shortest arc is reported.
  bool canSnap = true;    ///< Whether Snap is offered; merged blocks do not need it.
  bool isSnapped = false; ///< Whether Snap has been tried on these singularities.
  bool isDraft = false;   ///< Whether the quads are drafts, about which there are no warnings.
};

/**
 * Adds the cell array `Shade`: the sign of the quarter index where a line starts; 0, grey, if the
 * layout is stale.
 */
void AddShade(bool stale, vtkPolyData* lines);

/**
 * Adds the cell array `Colour` to patches: the number of a colour, which a patch keeps while
 * singularities move; −1, grey, if the layout is stale.
 */
void AddColours(
  const std::vector<crossfield::PatchColour>& colours, bool stale, vtkPolyData* patches);

/** Returns a short text about the quality of the design, or why there is no design. */
std::string Summary(const crossfield::LayoutDesign* design, const Report& report);

/** Returns whether the text gives a refusal or warns of bad quads. */
bool ReportsProblem(const crossfield::LayoutDesign* design, const Report& report);

/** Adds the field data of vtkLayoutDesigner; `design` is null if there never was one. */
void AddReport(const crossfield::LayoutDesign* design, const Report& report, vtkFieldData* data);
}

#endif
