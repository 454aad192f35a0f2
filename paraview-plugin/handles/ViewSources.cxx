#include "ViewSources.h"

#include "pqApplicationCore.h"
#include "pqDataRepresentation.h"
#include "pqPipelineSource.h"
#include "pqServerManagerModel.h"
#include "pqView.h"
#include "vtkAlgorithm.h"
#include "vtkDataArray.h"
#include "vtkDataObject.h"
#include "vtkFieldData.h"
#include "vtkPVXMLElement.h"
#include "vtkSMProxy.h"

#include <algorithm>
#include <cstring>

namespace
{
/** Returns whether a source has failed or has the result of an earlier input. */
bool IsStale(pqPipelineSource* source)
{
  auto* algorithm = vtkAlgorithm::SafeDownCast(source->getProxy()->GetClientSideObject());
  if (!algorithm)
  {
    return false; // on a remote server
  }
  vtkDataObject* output = algorithm->GetOutputDataObject(0);
  vtkDataArray* stale = output ? output->GetFieldData()->GetArray("Stale") : nullptr;
  return algorithm->GetErrorCode() != 0 || (stale && stale->GetTuple1(0) != 0);
}
}

namespace ViewSources
{
//------------------------------------------------------------------------------
std::vector<pqPipelineSource*> Visible(pqView* view)
{
  std::vector<pqPipelineSource*> sources;
  for (pqRepresentation* shown : view->getRepresentations())
  {
    auto* data = qobject_cast<pqDataRepresentation*>(shown);
    if (data && data->isVisible() && data->getInput())
    {
      sources.push_back(data->getInput());
    }
  }
  return sources;
}

//------------------------------------------------------------------------------
std::vector<const pqPipelineSource*> WithDownstream(const pqPipelineSource* source)
{
  std::vector<const pqPipelineSource*> found = { source };
  for (std::size_t i = 0; i < found.size(); ++i) // grows
  {
    for (const pqPipelineSource* consumer : found[i]->getAllConsumers())
    {
      if (std::find(found.begin(), found.end(), consumer) == found.end())
      {
        found.push_back(consumer);
      }
    }
  }
  return found;
}

//------------------------------------------------------------------------------
bool IsConnected(vtkSMProxy* proxy, pqView* view)
{
  const auto* source =
    pqApplicationCore::instance()->getServerManagerModel()->findItem<pqPipelineSource*>(proxy);
  if (!source)
  {
    return false; // its session ends
  }
  const std::vector<pqPipelineSource*> visible = Visible(view);
  const std::vector<const pqPipelineSource*> downstream = WithDownstream(source);
  return std::any_of(downstream.begin(), downstream.end(),
    [&](const pqPipelineSource* one)
    { return std::find(visible.begin(), visible.end(), one) != visible.end(); });
}

//------------------------------------------------------------------------------
bool IsOwn(vtkSMProxy* proxy)
{
  vtkPVXMLElement* hints = proxy->GetHints();
  vtkPVXMLElement* menu = hints ? hints->FindNestedElementByName("ShowInMenu") : nullptr;
  const char* icon = menu ? menu->GetAttribute("icon") : nullptr;
  return icon && std::strncmp(icon, ":/CrossField/", 13) == 0;
}

//------------------------------------------------------------------------------
bool HasStale(pqView* view)
{
  const std::vector<pqPipelineSource*> sources = Visible(view);
  return std::any_of(sources.begin(), sources.end(), &IsStale);
}
}
