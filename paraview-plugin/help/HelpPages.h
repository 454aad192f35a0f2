/**
 * @class   HelpPages
 * @brief   registers the help pages of the plugin with the client
 *
 * The pages are made from the definitions of the proxies (expand_proxies.py) and are a resource of the plugin.
 */

#ifndef HelpPages_h
#define HelpPages_h

#include <QObject>

class HelpPages : public QObject
{
  Q_OBJECT

public:
  using QObject::QObject;

  /** Called by ParaView when the plugin is loaded, and when ParaView exits. */
  void startup();
  void shutdown() {}
};

#endif
