#include "ViewSources.h"

#include "pqDataRepresentation.h"
#include "pqPipelineSource.h"
#include "pqView.h"
#include "vtkAlgorithm.h"
#include "vtkDataArray.h"
#include "vtkDataObject.h"
#include "vtkFieldData.h"
#include "vtkSMProxy.h"

#include <algorithm>

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
bool HasStale(pqView* view)
{
  const std::vector<pqPipelineSource*> sources = Visible(view);
  return std::any_of(sources.begin(), sources.end(), &IsStale);
}
}
