#ifndef LoopText_h
#define LoopText_h

#include "vtkSmartPointer.h"

#include <string>

class vtkPolyData;

/** Loops of points that come as text; both throw PipelineRun::Error, which names the `file`. */
namespace LoopText
{
/**
 * The points of a table with columns x, y and maybe z, or those of ParaView's export, Points:0 and so
 * on, in large or small letters, joined to one closed polyline.
 */
vtkSmartPointer<vtkPolyData> ReadTable(const std::string& text, const std::string& file);

/**
 * An aerofoil in Selig's format: a line with its name, then x and y of a point in each line, from the
 * trailing edge around the profile and back to it. Where the trailing edge is open, its two ends are
 * joined by a straight line.
 */
vtkSmartPointer<vtkPolyData> ReadAerofoil(const std::string& text, const std::string& file);
}

#endif
