/**
 * @class   DesignerLook
 * @brief   how a Layout Designer made in the menu is shown at first
 *
 * Faces in pale colours, draft quads as thin lines, separatrices as thick ones in the colours of the handles, grey where they
 * are stale, singularities as spheres, the summary as a text below, and no legends: as in states/design.py. It acts once, when a designer that a person
 * has made is shown for the first time; what Python or a state file makes stays as it was made.
 */

#ifndef DesignerLook_h
#define DesignerLook_h

#include <QObject>

class DesignerLook : public QObject
{
  Q_OBJECT

public:
  explicit DesignerLook(QObject* parent = nullptr);

  /** Called by ParaView when the plugin is loaded, and at the end. */
  void startup();
  void shutdown();
};

#endif
