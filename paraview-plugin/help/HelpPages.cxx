#include "HelpPages.h"

#include "pqApplicationCore.h"

#include <QHelpEngine>

//------------------------------------------------------------------------------
void HelpPages::startup()
{
#if QT_VERSION >= QT_VERSION_CHECK(6, 0, 0)
  // From Qt 6 on, an engine does not register pages unless it may write its file, which it opens again.
  QHelpEngine* engine = pqApplicationCore::instance()->helpEngine();
  engine->setReadOnly(false);
  engine->setupData();
#endif
  pqApplicationCore::instance()->registerDocumentation(":/CrossField/CrossFieldPlugin.qch");
}
