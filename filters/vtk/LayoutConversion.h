#ifndef LayoutConversion_h
#define LayoutConversion_h

#include "DomainPlane.h"
#include "LayoutDesign.h"

#include <string>

class vtkFieldData;

/** Conversion of layout designs to VTK data; see vtkLayoutDesigner. */
namespace LayoutConversion
{
/** What is said of a design: of the one that is shown, or of one that could not be. */
struct Report
{
  std::string refusal;   ///< Empty: it is shown.
  double quadSize = 0.0; ///< What the shortest arc is counted in.
};

/** The field data of vtkLayoutDesigner; `design` is null where there never was one. */
void AddReport(const crossfield::LayoutDesign* design, const Report& report, vtkFieldData* data);
}

#endif
