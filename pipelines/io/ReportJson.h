#ifndef ReportJson_h
#define ReportJson_h

#include <nlohmann/json_fwd.hpp>

#include <map>
#include <string>

class vtkDataSet;
class vtkFieldData;
class vtkUnstructuredGrid;

/** The numbers of a run as JSON. */
namespace ReportJson
{
/**
 * One object with the field data of a field under their names in snake_case (`hole_degree`): arrays
 * per hole as lists, flags as true or false, other single values as numbers; then the number of
 * `triangles`, the `seconds` spent in each stage and, unless null, the singularities.
 */
std::string Write(vtkUnstructuredGrid* field, const std::map<std::string, double>& seconds,
  vtkDataSet* singularities);

/**
 * Adds the list `singularities` of x, y, z in planes that are not z = const, and quarter_index, and
 * where they were chosen the list `events`, a sentence for each thing that was decided.
 */
void AddSingularities(nlohmann::ordered_json& report, vtkDataSet* singularities, bool hasHeight);

/** Adds `repair` with `distance` and `defect_before`, if a filter has repaired the holonomy. */
void AddRepair(nlohmann::ordered_json& report, vtkFieldData* field);
}

#endif
