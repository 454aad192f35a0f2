#ifndef LoopText_h
#define LoopText_h

#include <array>
#include <string>
#include <vector>

/**
 * Loops of points in text form. Reading functions throw crossfield::Error, which names the `file`,
 * if there are no points, if an entry is not a number, or if one of several loops has fewer than
 * three points.
 */
namespace LoopText
{
/** Points of a loop in order; the first one is not repeated. */
using Loop = std::vector<std::array<double, 3>>;

/** Formats of text. */
enum class Format
{
  Table,    ///< Comma-separated; see ReadTable.
  Aerofoil, ///< Rows of two numbers; see ReadAerofoil.
};

/**
 * Returns the format by the ending .csv or .dat of the file. With another ending, a text with a
 * comma in its first line is a table.
 */
Format FindFormat(const std::string& text, const std::string& file);

/** Returns whether the first two lines match a format. */
bool LooksLike(const std::string& text, Format format);

/**
 * Reads a table with columns x, y and optionally z, or those of ParaView's export, Points:0 etc.;
 * names are case-insensitive. Points with the same entry in a column `loop` form one loop; without
 * this column all points do.
 */
std::vector<Loop> ReadTable(const std::string& text, const std::string& file);

/**
 * Reads an aerofoil in Selig's format: a line with its name, then x and y of one point per line,
 * from the trailing edge around the profile and back to it. A straight line closes an open trailing
 * edge. Two empty lines (as for gnuplot) or a line 999 999 (as for MSES) start another loop.
 */
std::vector<Loop> ReadAerofoil(const std::string& text, const std::string& file);

/** Reads a text in the format that FindFormat returns. */
std::vector<Loop> Read(const std::string& text, const std::string& file);
}

#endif
