#include "HelpPages.h"

#include "pqApplicationCore.h"

#include <QHelpEngine>

//------------------------------------------------------------------------------
void HelpPages::startup()
{
#if QT_VERSION >= QT_VERSION_CHECK(6, 0, 0)
  // From Qt 6 on, an engine does not register pages unless it is told that it may write its file.
  pqApplicationCore::instance()->helpEngine()->setReadOnly(false);
#endif
  pqApplicationCore::instance()->registerDocumentation(":/CrossField/CrossFieldPlugin.qch");
}
