#include "HelpPages.h"

#include "pqApplicationCore.h"

//------------------------------------------------------------------------------
void HelpPages::startup()
{
  pqApplicationCore::instance()->registerDocumentation(":/CrossField/CrossFieldPlugin.qch");
}
