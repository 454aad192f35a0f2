// The part of pqSingularityHandlesWidget in the 3D view: handles and mouse.

#include "pqSingularityHandlesWidget.h"

#include "RunAbort.h"
#include "ViewMessages.h"
#include "ViewSources.h"

#include "pqApplicationCore.h"
#include "pqPipelineSource.h"
#include "pqRepresentation.h"
#include "pqServerManagerModel.h"
#include "pqUndoStack.h"
#include "pqView.h"
#include "vtkCallbackCommand.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkOutputWindow.h"
#include "vtkPVRenderView.h"
#include "vtkRenderWindow.h"
#include "vtkRenderWindowInteractor.h"
#include "vtkRenderer.h"
#include "vtkSMPropertyHelper.h"
#include "vtkSMSourceProxy.h"
#include "vtkSMViewProxy.h"
#include "vtkSmartPointer.h"

#include <QCheckBox>
#include <QEvent>
#include <QScopedValueRollback>
#include <QSignalBlocker>


namespace
{
// Above ParaView's interactor styles, which have priority 0: a click on a handle does not turn the
// camera.
constexpr float MousePriority = 1;

/**
 * Blocks the client's signals of pipeline updates during its lifetime. The client would collect
 * numbers for panels and reload the icons of all filters, which takes as long as the layout itself.
 * The update after the last move of a drag is signalled.
 */
class PipelineSignalBlocker
{
public:
  PipelineSignalBlocker()
  {
    for (auto* item :
      pqApplicationCore::instance()->getServerManagerModel()->findItems<pqPipelineSource*>())
    {
      this->Blockers.emplace_back(item);
    }
  }

private:
  std::vector<QSignalBlocker> Blockers;
};

class QuietOutputWindow final : public vtkOutputWindow
{
public:
  static QuietOutputWindow* New();
  vtkTypeMacro(QuietOutputWindow, vtkOutputWindow);
  void DisplayText(const char*) override {}
};
vtkStandardNewMacro(QuietOutputWindow);

/**
 * Hides messages of filters during its lifetime. ParaView switches vtkObject's global display of
 * warnings on before each update.
 */
class MessageBlocker
{
public:
  MessageBlocker() { vtkOutputWindow::SetInstance(vtkNew<QuietOutputWindow>()); }
  ~MessageBlocker() { vtkOutputWindow::SetInstance(this->Before); }
  Q_DISABLE_COPY(MessageBlocker)

private:
  vtkSmartPointer<vtkOutputWindow> Before = vtkOutputWindow::GetInstance();
  ViewMessages::Suspension Own;
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
  if (this->view())
  {
    QObject::disconnect(this->view(), nullptr, this, nullptr);
  }
  pqPropertyWidget::setView(view);
  if (view)
  {
    const auto update = [this] { this->UpdateHandles(); };
    QObject::connect(view, &pqView::representationVisibilityChanged, this, update);
    QObject::connect(view, &pqView::representationRemoved, this, update);
    QObject::connect(view, &pqView::endRender, this, [this] { this->CheckPicture(); });
  }
  this->UpdateHandles();
}

//------------------------------------------------------------------------------
void pqSingularityHandlesWidget::showEvent(QShowEvent* event)
{
  pqPropertyWidget::showEvent(event);
  this->FollowCommands();
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
  const bool isShown = this->isSelected() && this->isVisible() && this->isEnabled();
  if (!isShown || !this->view() || !ViewSources::IsConnected(this->proxy(), this->view()))
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
    return; // at the end of a session the panel is shown once more while pipeline items are deleted
  }
  auto* renderView = vtkPVRenderView::SafeDownCast(viewProxy->GetClientSideObject());
  vtkRenderWindowInteractor* interactor = viewProxy->GetInteractor();
  if (!renderView || !interactor)
  {
    return; // not a 3D view
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
void pqSingularityHandlesWidget::UpdatePipeline()
{
  auto* renderView =
    vtkPVRenderView::SafeDownCast(this->view()->getViewProxy()->GetClientSideObject());
  if (!this->Handles.GetRenderer() || !renderView || this->IsUpdating)
  {
    return;
  }
  // ParaView processes events while filters report their progress.
  const QScopedValueRollback<bool> updating(this->IsUpdating, true);
  if (this->IsHandlingMove)
  {
    LiveFrames::UpdateSources(this->view());
  }
  else
  {
    for (pqPipelineSource* source : ViewSources::Visible(this->view()))
    {
      source->getSourceProxy()->UpdatePipeline();
    }
  }
  // The view still has the data of its last update.
  if (!ViewSources::HasStale(this->view()))
  {
    this->Picture.Hide();
  }
  else if (!this->Picture.IsShown())
  {
    this->Picture.Show(renderView);
  }
}

//------------------------------------------------------------------------------
void pqSingularityHandlesWidget::CheckPicture()
{
  // Other commands change the pipeline and the view as well.
  if (this->Picture.IsShown() && !this->IsUpdating &&
    (!this->Picture.FitsView() || !ViewSources::HasStale(this->view())))
  {
    this->Picture.Hide();
    this->view()->render();
  }
}

//------------------------------------------------------------------------------
void pqSingularityHandlesWidget::Detach()
{
  this->FollowTimer.stop();
  this->EndDrag();
  this->Picture.Hide();
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
      self->HasPendingMove = true;
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
    this->Release(); // the release event of the last drag was not delivered
  }
  const int row = this->Handles.RowAt(x, y);
  if (row < 0)
  {
    return;
  }
  // A handle does not jump when the mouse button is pressed off its centre.
  const SingularityRow& pressed = this->Rows[row];
  const std::array<double, 2> middle = this->Handles.PixelOf(pressed);
  this->Grip = { x - middle[0], y - middle[1] };
  this->RowsBeforeDrag = this->Rows;
  this->PropertyBeforeDrag = this->PropertyRows();
  this->HasPendingMove = false;
  this->Choose(row);
  this->IsDragging = true;
}

//------------------------------------------------------------------------------
void pqSingularityHandlesWidget::FollowMouse()
{
  // ParaView processes events while filters report their progress.
  if (this->IsHandlingMove || !this->IsDragging || !this->HasPendingMove)
  {
    return;
  }
  {
    const QScopedValueRollback<bool> handling(this->IsHandlingMove, true);
    const MessageBlocker messages;
    const RunAbort::Suspension abort;
    this->HasPendingMove = false;
    SingularityRow& row = this->Rows[this->Chosen];
    const auto moved =
      this->Handles.Moved(row, this->Pixel[0] - this->Grip[0], this->Pixel[1] - this->Grip[1]);
    if (!moved)
    {
      return; // beside the surface
    }
    row = *moved;
    this->ShowRows();
    if (this->LiveBox->isChecked())
    {
      SCOPED_UNDO_EXCLUDE();
      this->SetDragging(true);
      this->WriteProperty(this->Rows);
    }
    // Anti-aliasing takes a software renderer 10 ms a frame and is hardly visible on moving edges.
    this->SmoothEdges(false);
    const PipelineSignalBlocker blocker;
    this->UpdatePipeline();
    this->Frames.Draw(this->view(), this->proxy());
  }
  if (this->HasPendingMove)
  {
    this->FollowTimer.start();
  }
}

//------------------------------------------------------------------------------
void pqSingularityHandlesWidget::Release()
{
  this->FollowMouse();
  this->EndDrag();
  if (this->Rows != this->RowsBeforeDrag)
  {
    this->Commit(this->PropertyBeforeDrag, this->Rows, "Move Singularity");
  }
  else
  {
    LiveFrames::MarkOutdated(this->view(), this->proxy());
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
  this->SetDragging(false);
}

//------------------------------------------------------------------------------
void pqSingularityHandlesWidget::SmoothEdges(bool isEnabled)
{
  vtkSMViewProxy* viewProxy = this->view() ? this->view()->getViewProxy() : nullptr;
  auto* renderView =
    viewProxy ? vtkPVRenderView::SafeDownCast(viewProxy->GetClientSideObject()) : nullptr;
  if (renderView)
  {
    // The property stays unchanged, so that a state or trace saved now has the user's setting.
    renderView->SetUseFXAA(isEnabled && vtkSMPropertyHelper(viewProxy, "UseFXAA").GetAsInt() != 0);
  }
}

//------------------------------------------------------------------------------
void pqSingularityHandlesWidget::SetDragging(bool isDragging)
{
  // The filter runs again after a change; undo and trace have no such step.
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
