#ifndef LayerText_h
#define LayerText_h

#include "CornerRows.h"
#include "DomainPlane.h"
#include "LayeredMesh.h"

#include <string>
#include <vector>

/**
 * Boundary layers and treatments of corners in text form: entries separated by semicolons. Reading
 * functions throw crossfield::Error.
 */
namespace LayerText
{
/** Reads entries NAME:FIRST[,GROWTH[,ROWS]]. */
std::vector<crossfield::LayerPrescription> ReadLayers(const std::string& text);

/**
 * Reads entries WHERE:end, WHERE:turn or WHERE:leave, where WHERE is a position X,Y or X,Y,Z, a
 * range of interior angles in degrees such as 200-300, or the name of a side.
 */
std::vector<crossfield::CornerRule> ReadCornerRows(
  const std::string& text, const crossfield::DomainPlane& plane);
}

#endif
