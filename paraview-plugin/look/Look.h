/**
 * How things are shown: colours, and the settings of representations that make them. No light, as what is flat has no shades;
 * no legends but of numbers that one reads.
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

// Those of the handles and of the states.
constexpr Colour Black = { 0, 0, 0 };
constexpr Colour Blue = { 0.1, 0.2, 0.85 };
constexpr Colour Grey = { 0.6, 0.6, 0.6 };
constexpr Colour PaleBlue = { 0.85, 0.92, 1 };
constexpr Colour PaleGrey = { 0.75, 0.75, 0.75 };
constexpr Colour Red = { 0.85, 0.1, 0.1 };

void Set(vtkSMProxy* proxy, const char* name, double value);
void Set(vtkSMProxy* proxy, const char* name, const char* value);
void SetFlat(vtkSMProxy* shown);
/** One colour, by no array. */
void SetColour(vtkSMProxy* shown, const Colour& colour);

/** Points of a colour map: a value and its colour. */
void AddColour(std::vector<double>& points, double value, const Colour& colour);
/** Of quarter indices: red, blue, and the colour of 0. */
std::vector<double> SignColours(const Colour& ofZero);
/** Of numbers that mean nothing, as those of blocks: five pale colours in turn. */
std::vector<double> PaleColours();

/** Colours by an array, whatever data there are yet, with a map that stays. */
void ColourBy(
  vtkSMProxy* shown, int association, const char* array, const std::vector<double>& points);
/** Places with a quarter index: red and blue spheres. */
void ShowSingularities(vtkSMProxy* shown);
/** Faces of a T-mesh. */
void ShowFaces(vtkSMProxy* shown);

/** That of the array by which it is coloured now. ParaView shows one after a representation was added. */
void HideLegend(pqDataRepresentation* representation);
}

#endif
