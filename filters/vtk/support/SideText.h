#ifndef SideText_h
#define SideText_h

#include "BoundaryPieces.h"
#include "DomainPlane.h"
#include "QuadRequest.h"

#include <array>
#include <map>
#include <string>
#include <vector>

/**
 * What is prescribed for sides of the boundary, in text form: rows of a table, or entries NAME:VALUE separated
 * by semicolons. Functions throw crossfield::Error for texts of another form.
 */
namespace SideText
{
/** What is prescribed for a side; empty texts prescribe nothing. */
struct Row
{
  std::string
    side; ///< Name; with cornerRows also a position X,Y[,Z] or a range of angles such as 200-300.
  std::string count;
  std::string progression; ///< RATIO or FIRST,LAST, also after `both:`.
  std::string size;
  std::string sizeInside; ///< Size of the quads in what the side encloses.
  std::string curve;      ///< circle, ellipse, spline or line.
  std::string layerFirst; ///< Height of the first row.
  std::string layerGrowth;
  std::string layerRows;
  std::string partner;    ///< Name of the side that is the image of this one.
  std::string cornerRows; ///< end, turn or leave.
};

/** A column of a table of sides. */
struct Column
{
  const char* name;
  std::string Row::*text;
};

/** The columns, `Side` first. */
extern const std::array<Column, 11> Columns;

/** Reads names; empty ones are left out. */
std::vector<std::string> ReadNames(const std::string& text);
/** Reads entries NAME:FIRST[,GROWTH[,ROWS]]. */
std::vector<Row> ReadLayers(const std::string& text);
/** Reads entries A:B. */
std::vector<Row> ReadPartners(const std::string& text);
/** Reads entries NAME:TYPE, types of patches by names of sides. */
std::map<std::string, std::string> ReadPatchTypes(const std::string& text);
/** Reads entries WHERE:end, WHERE:turn or WHERE:leave. */
std::vector<Row> ReadCornerRows(const std::string& text);
/** Reads entries NAME:circle, NAME:ellipse, NAME:spline, NAME:line and auto. */
crossfield::CurveRequest ReadCurves(const std::string& text);

/** Adds what a row prescribes to a request. */
void Prescribe(
  const Row& row, const crossfield::DomainPlane& plane, crossfield::QuadRequest& request);
}

#endif
