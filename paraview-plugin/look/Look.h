/**
 * Colours, and settings of representations. Lighting is off, since domains are flat; only
 * quantities with a meaningful scale have a legend.
 */

#ifndef Look_h
#define Look_h

#include <array>
#include <vector>

class pqDataRepresentation;
class vtkSMProxy;

namespace Look
{
using Colour = std::array<double, 3>;

// Colours of the handles and of the states.
constexpr Colour Black = { 0, 0, 0 };
constexpr Colour Blue = { 0.1, 0.2, 0.85 };
constexpr Colour Grey = { 0.6, 0.6, 0.6 };
constexpr Colour PaleBlue = { 0.85, 0.92, 1 };
constexpr Colour PaleGrey = { 0.75, 0.75, 0.75 };
constexpr Colour Red = { 0.85, 0.1, 0.1 };

void Set(vtkSMProxy* proxy, const char* name, double value);
void Set(vtkSMProxy* proxy, const char* name, const char* value);
/** Switches lighting off. */
void SetFlat(vtkSMProxy* shown);
/** Sets a uniform colour. */
void SetColour(vtkSMProxy* shown, const Colour& colour);

/** Adds a point to a colour map: a value and its colour. */
void AddColour(std::vector<double>& points, double value, const Colour& colour);
/** Returns the colour map of quarter indices: blue for −1, red for 1, and `ofZero`. */
std::vector<double> SignColours(const Colour& ofZero);
/** Returns a colour map for identifiers, as those of blocks: five pale colours in turn. */
std::vector<double> PaleColours();
/** Returns the same pale colours for the numbers 0 to 4, and grey for −1. */
std::vector<double> PatchColours();

/** Gives an array a fixed colour map, a step of its own in a trace. */
void SetColourMap(vtkSMProxy* shown, const char* array, const std::vector<double>& points);
/** Colours by an array, which may not exist yet, with its colour map. */
void ColourBy(vtkSMProxy* shown, int association, const char* array);
/** Shows points with a quarter index as red and blue spheres, with the colours below. */
void ShowSingularities(vtkSMProxy* shown);
void SetSingularityColours(vtkSMProxy* shown);
/** Shows the patches of a T-mesh in pale colours, those below. */
void ShowPatches(vtkSMProxy* shown);
void SetPatchColours(vtkSMProxy* shown);

/** Hides the legend of the colouring array, which ParaView shows for a new representation. */
void HideLegend(pqDataRepresentation* representation);
}

#endif
