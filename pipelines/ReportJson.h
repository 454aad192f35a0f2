#ifndef ReportJson_h
#define ReportJson_h

#include <map>
#include <string>

class vtkFieldData;
class vtkPolyData;

/** The numbers of a run as JSON. */
namespace ReportJson
{
/**
 * One object with the arrays of the field data under their names in snake_case (`hole_degree`):
 * arrays per hole as lists, flags as true or false, other single values as numbers; then the extra
 * counts, and the seconds spent in each stage under `seconds`.
 */
std::string Write(vtkFieldData* data, const std::map<std::string, long long>& counts,
  const std::map<std::string, double>& seconds);

/** A report with the list `singularities` of x, y, z if asked for, and quarter_index added. */
std::string AddSingularities(
  const std::string& report, vtkPolyData* singularities, bool hasHeight = false);
}

#endif
