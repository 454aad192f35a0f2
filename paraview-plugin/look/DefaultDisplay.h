/**
 * @class   DefaultDisplay
 * @brief   default display of sources and filters created from the menus
 *
 * Shows domains as thick black lines, singularities as red and blue spheres, meshes as their edges,
 * fields coloured by their norm from 0 to 1, sizes in a sequential colour map, crosses and
 * separatrices as black lines, patches and blocks in pale colours, a Layout Designer as in
 * DesignerLook.h, and texts as in TextLook.h. It is applied once, when an output is shown for the
 * first time; sources created by Python or a state file are not changed.
 */

#ifndef DefaultDisplay_h
#define DefaultDisplay_h

#include <QObject>

class DefaultDisplay : public QObject
{
  Q_OBJECT

public:
  explicit DefaultDisplay(QObject* parent = nullptr);

  /** Called by ParaView when the plugin is loaded, and when ParaView exits. */
  void startup();
  void shutdown();
};

#endif
