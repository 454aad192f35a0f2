#ifndef ViewSources_h
#define ViewSources_h

#include <vector>

class pqPipelineSource;
class pqView;
class vtkSMProxy;

/** The pipeline as a view shows it. */
namespace ViewSources
{
/** Returns the sources that are visible in a view. */
std::vector<pqPipelineSource*> Visible(pqView* view);
/** Returns whether a proxy, or a filter downstream of it, is visible in a view. */
bool IsConnected(vtkSMProxy* proxy, pqView* view);
/** Returns a source and all filters downstream of it. */
std::vector<const pqPipelineSource*> WithDownstream(const pqPipelineSource* source);
/** Returns whether a proxy is one of this plugin: it has one of its icons. */
bool IsOwn(vtkSMProxy* proxy);
/** Returns whether a visible source has failed or has the result of an earlier input. */
bool HasStale(pqView* view);
}

#endif
