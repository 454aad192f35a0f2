#ifndef ReportJson_h
#define ReportJson_h

#include "Json.h"

#include <map>
#include <string>
#include <vector>

class vtkDataObject;

/**
 * Writes the numbers of a run as JSON. The table filters/vtk/reports.json lists the keys of every
 * report, the arrays that they come from, and explains its kinds of entries.
 */
namespace ReportJson
{
/** Data, times and names that a report is written from. */
struct Sources
{
  using Others = std::map<std::string, vtkDataObject*>;

  Sources(vtkDataObject* given, const Others& givenOthers = {},
    const std::vector<double>& givenSeconds = {}, const std::vector<std::string>& givenFiles = {})
    : data(given)
    , others(givenOthers)
    , seconds(givenSeconds)
    , files(givenFiles)
  {
  }

  vtkDataObject* data; ///< Data set or table whose field data the report reads.
  /**
   * Other sources by the names that the table gives them; null if there is none. Every report reads
   * `domain`, the domain after its boundary was simplified, and `singularities`, those that the
   * command has used.
   */
  Others others;
  std::vector<double> seconds;    ///< Times of the stages, in the order of the table.
  std::vector<std::string> files; ///< Names of the input files.
};

/** Adds what every report has: singularities, events and changes to the domain's boundary. */
void AddCommon(const Sources& sources, nlohmann::ordered_json& report);

/** Returns the report of this name as text, with a line break at the end. */
std::string Write(const std::string& name, const Sources& sources);

/** Returns the value of one key of a report in one line, for the summary that a command prints. */
std::string Write(const std::string& name, const std::string& key, const Sources& sources);
}

#endif
