/**
 * @class   LiveFrames
 * @brief   updates and draws a view while a handle is dragged
 *
 * With the built-in server, filters and view are updated and drawn directly. The client's proxies
 * are not notified: they would collect the ranges of all arrays and refresh the lists of arrays in
 * panels after each update, which takes as long as the frame itself. They are updated when the
 * handle is released. On a remote server, this goes through the proxies.
 */

#ifndef LiveFrames_h
#define LiveFrames_h

#include "vtkTimeStamp.h"

class pqView;
class vtkSMProxy;

class LiveFrames
{
public:
  /** Updates the sources that are visible in a view; the view still has its last data. */
  static void UpdateSources(pqView* view);

  /**
   * Marks what a view shows of a proxy, which has changed, and of filters downstream as outdated.
   * Proxies do so only once until their next update, so this is also needed after the last frame.
   */
  static void MarkOutdated(pqView* view, vtkSMProxy* changed);

  /** Draws a view with the data of filters downstream of a proxy, which has changed. */
  void Draw(pqView* view, vtkSMProxy* changed);

private:
  vtkTimeStamp Delivered;
};

#endif
