#ifndef LoopText_h
#define LoopText_h

#include <array>
#include <string>
#include <vector>

/**
 * Loops of points that come as text. What reads throws crossfield::Error, which names the `file`: what
 * has no points, what is no number, and one of several loops with fewer than three points.
 */
namespace LoopText
{
/** The points of a loop in order, the first one not again. */
using Loop = std::vector<std::array<double, 3>>;

/** The kinds of text. */
enum class Format
{
  Table,    ///< Comma-separated, as ReadTable takes it.
  Aerofoil, ///< Rows of two numbers, as ReadAerofoil takes it.
};

/** By the ending .csv or .dat of the file; of others, a table has a comma in its first line. */
Format FindFormat(const std::string& text, const std::string& file);

/** Whether the first two lines look like those of a text of the format. */
bool LooksLike(const std::string& text, Format format);

/**
 * The points of a table with columns x, y and maybe z, or those of ParaView's export, Points:0 and so
 * on, in large or small letters. Points with the same entry in a column `loop` are one loop; without
 * this column all of them are.
 */
std::vector<Loop> ReadTable(const std::string& text, const std::string& file);

/**
 * An aerofoil in Selig's format: a line with its name, then x and y of a point in each line, from the
 * trailing edge around the profile and back to it. Where the trailing edge is open, its two ends are
 * joined by a straight line. Two empty lines (as for gnuplot) or a line 999 999 (as for MSES) begin
 * another loop.
 */
std::vector<Loop> ReadAerofoil(const std::string& text, const std::string& file);

/** By the format. */
std::vector<Loop> Read(const std::string& text, const std::string& file);
}

#endif
