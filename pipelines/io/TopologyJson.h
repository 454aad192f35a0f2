#ifndef TopologyJson_h
#define TopologyJson_h

#include <string>

class vtkBoundaryCornerClassifier;
class vtkPoincareHopfCheck;

/** The results of the topological filters as JSON; the filters must have been updated. */
namespace TopologyJson
{
/**
 * Counts, flags and the reason, and the lists `holonomy_defect`, `loops` and `corners`; of a solved field
 * also `hole_degree`, `hole_degree_reliable` and `unwanted_singularities`.
 */
std::string Write(vtkPoincareHopfCheck* check);

/** The chosen scenario, all three under `scenarios`, `corners` and `split`. */
std::string Write(vtkBoundaryCornerClassifier* classifier);
}

#endif
