#include "LiveFrames.h"

#include "ViewSources.h"

#include "pqApplicationCore.h"
#include "pqDataRepresentation.h"
#include "pqPipelineSource.h"
#include "pqServerManagerModel.h"
#include "pqView.h"
#include "vtkAlgorithm.h"
#include "vtkClientServerStream.h"
#include "vtkPVDataDeliveryManager.h"
#include "vtkPVDataRepresentation.h"
#include "vtkPVRenderView.h"
#include "vtkSMPTools.h"
#include "vtkSMSession.h"
#include "vtkSMSourceProxy.h"
#include "vtkSMViewProxy.h"

#include <algorithm>
#include <vector>

namespace
{
vtkAlgorithm* AlgorithmOf(pqPipelineSource* source)
{
  return vtkAlgorithm::SafeDownCast(source->getProxy()->GetClientSideObject());
}

/** Returns whether all visible sources are in this process. */
bool AreLocal(const std::vector<pqPipelineSource*>& sources)
{
  return std::all_of(sources.begin(), sources.end(), &AlgorithmOf);
}

/**
 * Calls a function without threads of VTK: data are small during a drag, and VTK reads the number
 * of processors from a file for each loop.
 */
template <class Function>
void WithoutThreads(Function function)
{
  vtkSMPTools::LocalScope(vtkSMPTools::Config("Sequential"), function);
}
}

//------------------------------------------------------------------------------
void LiveFrames::UpdateSources(pqView* view)
{
  const std::vector<pqPipelineSource*> sources = ViewSources::Visible(view);
  if (!AreLocal(sources))
  {
    for (pqPipelineSource* source : sources)
    {
      source->getSourceProxy()->UpdatePipeline();
    }
    return;
  }
  WithoutThreads(
    [&]
    {
      for (pqPipelineSource* source : sources)
      {
        AlgorithmOf(source)->Update();
      }
    });
}

//------------------------------------------------------------------------------
void LiveFrames::MarkOutdated(pqView* view, vtkSMProxy* changed)
{
  const auto* source =
    pqApplicationCore::instance()->getServerManagerModel()->findItem<pqPipelineSource*>(changed);
  if (!source)
  {
    return; // its session ends
  }
  const std::vector<const pqPipelineSource*> outdated = ViewSources::WithDownstream(source);
  for (pqRepresentation* shown : view->getRepresentations())
  {
    auto* data = qobject_cast<pqDataRepresentation*>(shown);
    auto* representation = data && data->isVisible()
      ? vtkPVDataRepresentation::SafeDownCast(data->getProxy()->GetClientSideObject())
      : nullptr;
    if (representation &&
      std::find(outdated.begin(), outdated.end(), data->getInput()) != outdated.end())
    {
      representation->MarkModified();
    }
  }
}

//------------------------------------------------------------------------------
void LiveFrames::Draw(pqView* view, vtkSMProxy* changed)
{
  vtkSMViewProxy* viewProxy = view->getViewProxy();
  auto* renderView = vtkPVRenderView::SafeDownCast(viewProxy->GetClientSideObject());
  if (!renderView || !AreLocal(ViewSources::Visible(view)))
  {
    view->forceRender();
    return;
  }
  LiveFrames::MarkOutdated(view, changed);
  WithoutThreads(
    [&]
    {
      vtkClientServerStream update;
      update << vtkClientServerStream::Invoke << VTKOBJECT(viewProxy) << "Update"
             << vtkClientServerStream::End;
      viewProxy->GetSession()->ExecuteStream(viewProxy->GetLocation(), update);
      vtkClientServerStream draw;
      std::vector<unsigned int> keys;
      if (renderView->GetDeliveryManager()->NeedsDelivery(
            this->Delivered.GetMTime(), keys, /*use_lod=*/false))
      {
        draw << vtkClientServerStream::Invoke << VTKOBJECT(viewProxy) << "Deliver" << 0
             << static_cast<unsigned int>(keys.size())
             << vtkClientServerStream::InsertArray(keys.data(), static_cast<int>(keys.size()))
             << vtkClientServerStream::End;
      }
      this->Delivered.Modified();
      draw << vtkClientServerStream::Invoke << VTKOBJECT(viewProxy) << "StillRender"
           << vtkClientServerStream::End;
      viewProxy->GetSession()->ExecuteStream(viewProxy->GetLocation(), draw);
    });
}
