/**
 * @class   DefaultDisplay
 * @brief   how what a person makes in the menu is shown at first
 *
 * Domains as thick black lines, singularities as red and blue spheres, meshes as their edges, fields by their norm on a map from 0 to 1,
 * sizes on a map of one hue after the other, crosses and separatrices as black lines, faces and blocks in pale colours, and
 * a Layout Designer as DesignerLook.h says, and texts as TextLook.h says. It acts once, when an output is shown for the first time; what Python or a state
 * file makes stays as it was made.
 */

#ifndef FirstLook_h
#define FirstLook_h

#include <QObject>

class DefaultDisplay : public QObject
{
  Q_OBJECT

public:
  explicit DefaultDisplay(QObject* parent = nullptr);

  /** Called by ParaView when the plugin is loaded, and at the end. */
  void startup();
  void shutdown();
};

#endif
