#ifndef ViewSources_h
#define ViewSources_h

#include <vector>

class pqPipelineSource;
class pqView;

/** The pipeline as a view shows it. */
namespace ViewSources
{
/** Returns the sources that are visible in a view. */
std::vector<pqPipelineSource*> Visible(pqView* view);
/** Returns whether a visible source has failed or has the result of an earlier input. */
bool HasStale(pqView* view);
}

#endif
