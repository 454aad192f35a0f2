#ifndef LayoutConversion_h
#define LayoutConversion_h

#include "DomainPlane.h"
#include "LayoutDesign.h"

#include <string>

class vtkFieldData;
class vtkPolyData;

/** Conversion of layout designs to VTK data; see vtkLayoutDesigner. */
namespace LayoutConversion
{
/** What is said of a design: of the one that is shown, or of one that could not be. */
struct Report
{
  std::string refusal;   ///< Empty: it is shown.
  double quadSize = 0.0; ///< What the shortest arc is counted in.
};

/** The cell array `Shade` of lines: the sign of the quarter index where a line starts; 0, grey, where the layout is stale. */
void AddShade(bool stale, vtkPolyData* lines);

/** One line with what the design that is shown is good for, or why there is none. */
std::string Summary(const crossfield::LayoutDesign* design, const Report& report);

/** The field data of vtkLayoutDesigner; `design` is null where there never was one. */
void AddReport(const crossfield::LayoutDesign* design, const Report& report, vtkFieldData* data);
}

#endif
