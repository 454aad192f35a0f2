// The part of pqSingularityHandlesWidget that lives in the 3D view: handles and mouse.

#include "pqSingularityHandlesWidget.h"

#include "pqApplicationCore.h"
#include "pqPipelineSource.h"
#include "pqServerManagerModel.h"
#include "pqUndoStack.h"
#include "pqView.h"
#include "vtkCallbackCommand.h"
#include "vtkPVRenderView.h"
#include "vtkRenderWindow.h"
#include "vtkRenderWindowInteractor.h"
#include "vtkRenderer.h"
#include "vtkSMPropertyHelper.h"
#include "vtkSMViewProxy.h"

#include <QCheckBox>
#include <QEvent>
#include <QScopedValueRollback>
#include <QSignalBlocker>

namespace
{
// Before ParaView's own styles, which have priority 0: what meets a handle does not turn the camera.
constexpr float MousePriority = 1;

/**
 * While it lives the client is not told that pipelines have run: it would gather numbers for panels and load the icons of all
 * filters anew, which takes as long as the layout itself. What follows the last move of a drag tells it.
 */
class Quiet
{
public:
  Quiet()
  {
    for (auto* item : pqApplicationCore::instance()->getServerManagerModel()->findItems<pqPipelineSource*>())
    {
      this->Blockers.emplace_back(item);
    }
  }

private:
  std::vector<QSignalBlocker> Blockers;
};
}

//------------------------------------------------------------------------------
void pqSingularityHandlesWidget::select()
{
  pqPropertyWidget::select();
  this->UpdateHandles();
}

//------------------------------------------------------------------------------
void pqSingularityHandlesWidget::selectPort(int)
{
  this->select();
}

//------------------------------------------------------------------------------
void pqSingularityHandlesWidget::deselect()
{
  pqPropertyWidget::deselect();
  this->UpdateHandles();
}

//------------------------------------------------------------------------------
void pqSingularityHandlesWidget::setView(pqView* view)
{
  this->Detach();
  pqPropertyWidget::setView(view);
  this->UpdateHandles();
}

//------------------------------------------------------------------------------
void pqSingularityHandlesWidget::showEvent(QShowEvent* event)
{
  pqPropertyWidget::showEvent(event);
  this->UpdateHandles();
}

//------------------------------------------------------------------------------
void pqSingularityHandlesWidget::hideEvent(QHideEvent* event)
{
  pqPropertyWidget::hideEvent(event);
  this->UpdateHandles();
}

//------------------------------------------------------------------------------
void pqSingularityHandlesWidget::changeEvent(QEvent* event)
{
  pqPropertyWidget::changeEvent(event);
  if (event->type() == QEvent::EnabledChange)
  {
    this->UpdateHandles();
  }
}

//------------------------------------------------------------------------------
void pqSingularityHandlesWidget::UpdateHandles()
{
  const bool isWanted = this->isSelected() && this->isVisible() && this->isEnabled();
  if (!isWanted || !this->view())
  {
    this->Detach();
    return;
  }
  if (this->Handles.GetRenderer())
  {
    return;
  }
  vtkSMViewProxy* viewProxy = this->view()->getViewProxy();
  if (!viewProxy || !this->view()->widget())
  {
    return; // at the end of a session, where a panel is shown once more while the items before it are deleted
  }
  auto* renderView = vtkPVRenderView::SafeDownCast(viewProxy->GetClientSideObject());
  vtkRenderWindowInteractor* interactor = viewProxy->GetInteractor();
  if (!renderView || !interactor)
  {
    return; // a chart or a table
  }
  this->Handles.SetRenderer(
    renderView->GetNonCompositedRenderer(), this->view()->widget()->devicePixelRatioF());
  this->Handles.SetRows(this->Rows, this->Chosen);
  this->Interactor = interactor;
  for (const unsigned long event : { vtkCommand::LeftButtonPressEvent, vtkCommand::MouseMoveEvent,
         vtkCommand::LeftButtonReleaseEvent })
  {
    interactor->AddObserver(event, this->Mouse, MousePriority);
  }
  this->view()->render();
}

//------------------------------------------------------------------------------
void pqSingularityHandlesWidget::Detach()
{
  this->FollowTimer.stop();
  this->EndDrag();
  if (this->Interactor)
  {
    this->Interactor->RemoveObserver(this->Mouse);
    this->Interactor = nullptr;
  }
  if (this->Handles.GetRenderer())
  {
    this->Handles.SetRenderer(nullptr);
    if (this->view())
    {
      this->view()->render();
    }
  }
}

//------------------------------------------------------------------------------
void pqSingularityHandlesWidget::OnMouse(
  vtkObject* caller, unsigned long event, void* clientData, void*)
{
  auto* self = static_cast<pqSingularityHandlesWidget*>(clientData);
  const int* pixel = static_cast<vtkRenderWindowInteractor*>(caller)->GetEventPosition();
  switch (event)
  {
  case vtkCommand::LeftButtonPressEvent:
    self->Press(pixel[0], pixel[1]);
    break;
  case vtkCommand::MouseMoveEvent:
    if (self->IsDragging)
    {
      self->Pixel = { static_cast<double>(pixel[0]), static_cast<double>(pixel[1]) };
      self->IsBehind = true;
      self->FollowTimer.start();
    }
    else
    {
      self->Hover(pixel[0], pixel[1]);
    }
    break;
  default:
    if (!self->IsDragging)
    {
      break;
    }
    self->Mouse->SetAbortFlag(1);
    self->Release();
    return;
  }
  self->Mouse->SetAbortFlag(self->IsDragging ? 1 : 0);
}

//------------------------------------------------------------------------------
void pqSingularityHandlesWidget::Press(int x, int y)
{
  if (this->IsDragging)
  {
    this->Release(); // its own release went elsewhere
  }
  const int row = this->Handles.RowAt(x, y);
  if (row < 0)
  {
    return;
  }
  // Taken beside its middle, a handle does not jump.
  const SingularityRow& taken = this->Rows[static_cast<std::size_t>(row)];
  const std::array<double, 2> middle = this->Handles.PixelOf({ taken[0], taken[1] });
  this->Grip = { x - middle[0], y - middle[1] };
  this->RowsBeforeDrag = this->Rows;
  this->IsBehind = false;
  this->Choose(row);
  this->IsDragging = true;
}

//------------------------------------------------------------------------------
void pqSingularityHandlesWidget::Follow()
{
  // ParaView handles events while filters tell their progress.
  if (this->IsFollowing || !this->IsDragging || !this->IsBehind)
  {
    return;
  }
  {
    const QScopedValueRollback<bool> following(this->IsFollowing, true);
    this->IsBehind = false;
    const auto point = this->Handles.PlanePointAt(
      this->Pixel[0] - this->Grip[0], this->Pixel[1] - this->Grip[1]);
    if (!point)
    {
      return;
    }
    SingularityRow& row = this->Rows[static_cast<std::size_t>(this->Chosen)];
    row[0] = (*point)[0];
    row[1] = (*point)[1];
    this->ShowRows();
    if (this->LiveBox->isChecked())
    {
      SCOPED_UNDO_EXCLUDE();
      this->TellDragging(true);
      this->WriteProperty(this->Rows);
    }
    // It takes a software renderer 10 ms a frame, and edges that move are not looked at so closely.
    this->SmoothEdges(false);
    const Quiet quiet;
    this->view()->forceRender();
  }
  if (this->IsBehind)
  {
    this->FollowTimer.start();
  }
}

//------------------------------------------------------------------------------
void pqSingularityHandlesWidget::Release()
{
  this->Follow();
  this->EndDrag();
  if (this->Rows != this->RowsBeforeDrag)
  {
    this->Commit(this->RowsBeforeDrag, this->Rows, "Move Singularity");
  }
  else
  {
    this->view()->render();
  }
}

//------------------------------------------------------------------------------
void pqSingularityHandlesWidget::EndDrag()
{
  if (this->IsDragging)
  {
    this->IsDragging = false;
    this->SmoothEdges(true);
  }
  this->TellDragging(false);
}

//------------------------------------------------------------------------------
void pqSingularityHandlesWidget::SmoothEdges(bool isWanted)
{
  vtkSMViewProxy* viewProxy = this->view() ? this->view()->getViewProxy() : nullptr;
  auto* renderView =
    viewProxy ? vtkPVRenderView::SafeDownCast(viewProxy->GetClientSideObject()) : nullptr;
  if (renderView)
  {
    // Not its property: a state or a trace of this moment is to have what a person has set.
    renderView->SetUseFXAA(isWanted && vtkSMPropertyHelper(viewProxy, "UseFXAA").GetAsInt() != 0);
  }
}

//------------------------------------------------------------------------------
void pqSingularityHandlesWidget::TellDragging(bool isDragging)
{
  // A filter is asked again where that changes; undo and trace have no such step.
  if (this->Dragging && vtkSMPropertyHelper(this->Dragging).GetAsInt() != (isDragging ? 1 : 0))
  {
    SCOPED_UNDO_EXCLUDE();
    vtkSMPropertyHelper(this->Dragging).Set(isDragging ? 1 : 0);
    this->proxy()->UpdateVTKObjects();
  }
}

//------------------------------------------------------------------------------
void pqSingularityHandlesWidget::Hover(int x, int y)
{
  const bool isHovering = this->Handles.RowAt(x, y) >= 0;
  if (isHovering != this->IsHovering)
  {
    this->IsHovering = isHovering;
    this->Interactor->GetRenderWindow()->SetCurrentCursor(
      isHovering ? VTK_CURSOR_HAND : VTK_CURSOR_DEFAULT);
  }
}
