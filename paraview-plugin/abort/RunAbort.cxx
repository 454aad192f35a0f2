#include "RunAbort.h"

#include "ViewSources.h"

#include "pqApplicationCore.h"
#include "pqPipelineSource.h"
#include "pqProgressManager.h"
#include "pqServer.h"
#include "pqServerManagerModel.h"
#include "vtkAlgorithm.h"
#include "vtkCallbackCommand.h"
#include "vtkDemandDrivenPipeline.h"
#include "vtkNew.h"
#include "vtkPVVersion.h"
#include "vtkSMSourceProxy.h"

#include <QApplication>
#include <QKeyEvent>
#include <QScopedValueRollback>
#include <QTimer>

#include <algorithm>
#include <functional>
#include <memory>

namespace
{
int Suspensions = 0;

/** Returns the time of the last change of an algorithm or of its inputs. */
vtkMTimeType PipelineTime(vtkAlgorithm* algorithm)
{
  auto* executive = vtkDemandDrivenPipeline::SafeDownCast(algorithm->GetExecutive());
  return std::max(algorithm->GetMTime(), executive ? executive->GetPipelineMTime() : 0);
}

/** Calls a function at each event of an algorithm, as long as the algorithm exists. */
void AddObserver(vtkAlgorithm* algorithm, unsigned long event, std::function<void()> function)
{
  vtkNew<vtkCallbackCommand> command;
  command->SetClientData(new std::function<void()>(std::move(function)));
  command->SetClientDataDeleteCallback(
    [](void* data) { delete static_cast<std::function<void()>*>(data); });
  command->SetCallback([](vtkObject*, unsigned long, void* data, void*)
    { (*static_cast<std::function<void()>*>(data))(); });
  algorithm->AddObserver(event, command);
}

/**
 * Enables Apply, which then changes the algorithm so that it runs again, once the command that has
 * started the run has ended: it may be Apply itself.
 */
void EnableApply(QPointer<pqPipelineSource> source, vtkWeakPointer<vtkAlgorithm> algorithm)
{
  constexpr int Interval = 100; // in milliseconds
  QTimer::singleShot(Interval, source,
    [source, algorithm]
    {
      if (!algorithm || !algorithm->GetAbortExecute())
      {
        return; // it has run again
      }
      if (source->modifiedState() != pqProxy::UNMODIFIED)
      {
        EnableApply(source, algorithm);
        return;
      }
      source->setModifiedState(pqProxy::MODIFIED);
      const auto applied = std::make_shared<QMetaObject::Connection>();
      *applied = QObject::connect(source, &pqProxy::modifiedStateChanged, source,
        [source, algorithm, applied]
        {
          if (source->modifiedState() == pqProxy::UNMODIFIED && algorithm)
          {
            QObject::disconnect(*applied);
            algorithm->Modified();
            source->getSourceProxy()->MarkDirty(nullptr);
          }
        });
    });
}

/** Returns whether an event is input of the user, who expects an effect on the window. */
bool IsInput(const QEvent* event)
{
  switch (event->type())
  {
  case QEvent::MouseButtonPress:
  case QEvent::MouseButtonRelease:
  case QEvent::MouseButtonDblClick:
  case QEvent::MouseMove:
  case QEvent::Wheel:
  case QEvent::KeyPress:
  case QEvent::KeyRelease:
  case QEvent::Shortcut:
  case QEvent::ShortcutOverride:
  case QEvent::ContextMenu:
  case QEvent::Close:
    return true;
  default:
    return false;
  }
}
}

//------------------------------------------------------------------------------
RunAbort::Suspension::Suspension()
{
  ++Suspensions;
}

//------------------------------------------------------------------------------
RunAbort::Suspension::~Suspension()
{
  --Suspensions;
}

//------------------------------------------------------------------------------
RunAbort::RunAbort(QObject* parent)
  : QObject(parent)
{
}

//------------------------------------------------------------------------------
void RunAbort::startup()
{
#if PARAVIEW_VERSION_MAJOR < 6 || (PARAVIEW_VERSION_MAJOR == 6 && PARAVIEW_VERSION_MINOR < 1)
  pqServerManagerModel* model = pqApplicationCore::instance()->getServerManagerModel();
  QObject::connect(model, &pqServerManagerModel::sourceAdded, this, &RunAbort::Observe);
  for (auto* source : model->findItems<pqPipelineSource*>())
  {
    this->Observe(source);
  }
  pqProgressManager* progress = pqApplicationCore::instance()->getProgressManager();
  QObject::connect(progress, &pqProgressManager::progress, this,
    [this](const QString&, int value) { this->ProcessEvents(value); });
  QObject::connect(progress, &pqProgressManager::abort, this, &RunAbort::Abort);
#endif
}

//------------------------------------------------------------------------------
void RunAbort::shutdown()
{
  if (pqApplicationCore* core = pqApplicationCore::instance())
  {
    QObject::disconnect(core->getServerManagerModel(), nullptr, this, nullptr);
    QObject::disconnect(core->getProgressManager(), nullptr, this, nullptr);
  }
}

//------------------------------------------------------------------------------
void RunAbort::Observe(pqPipelineSource* source)
{
  auto* algorithm = vtkAlgorithm::SafeDownCast(source->getProxy()->GetClientSideObject());
  if (!algorithm || source->getServer()->isRemote() || !ViewSources::IsOwn(source->getProxy()))
  {
    return;
  }
  const QPointer<RunAbort> self(this);
  const QPointer<pqPipelineSource> observed(source);
  const auto aborted = std::make_shared<vtkMTimeType>(0);
  AddObserver(algorithm, vtkCommand::StartEvent,
    [self, observed, algorithm, aborted]
    {
      // The pipeline repeats an aborted run at each request. The flag ends it at once, until there
      // is a change.
      if (algorithm->GetAbortExecute() && PipelineTime(algorithm) > *aborted)
      {
        algorithm->SetAbortExecute(0);
      }
      if (self && observed)
      {
        self->Begin(observed, algorithm);
      }
    });
  AddObserver(algorithm, vtkCommand::EndEvent,
    [self, algorithm, aborted]
    {
      if (algorithm->GetAbortExecute())
      {
        *aborted = PipelineTime(algorithm);
      }
      if (self)
      {
        self->End(algorithm);
      }
    });
}

//------------------------------------------------------------------------------
void RunAbort::Begin(pqPipelineSource* source, vtkAlgorithm* algorithm)
{
  if (Suspensions == 0)
  {
    this->Source = source;
    this->Running = algorithm;
    pqApplicationCore::instance()->getProgressManager()->setEnableAbort(true);
  }
}

//------------------------------------------------------------------------------
void RunAbort::End(vtkAlgorithm* algorithm)
{
  if (this->Running == algorithm)
  {
    this->Running = nullptr;
    pqApplicationCore::instance()->getProgressManager()->setEnableAbort(false);
  }
}

//------------------------------------------------------------------------------
void RunAbort::ProcessEvents(int progress)
{
  // As in later versions of ParaView, not at progress 0: other classes rely on it.
  if (progress > 0 && this->Running && !this->IsProcessing)
  {
    const QScopedValueRollback<bool> processing(this->IsProcessing, true);
    QApplication::instance()->installEventFilter(this); // comes before ParaView's own filter
    QCoreApplication::processEvents(QEventLoop::X11ExcludeTimers);
    QApplication::instance()->removeEventFilter(this);
  }
}

//------------------------------------------------------------------------------
bool RunAbort::eventFilter(QObject* object, QEvent* event)
{
  if (!this->IsProcessing || !IsInput(event))
  {
    return false;
  }
  if (event->type() == QEvent::KeyPress && static_cast<QKeyEvent*>(event)->key() == Qt::Key_Escape)
  {
    this->Abort();
    return true;
  }
  // The native window that holds the button receives its clicks first.
  const auto& allowed =
    pqApplicationCore::instance()->getProgressManager()->nonBlockableObjects();
  if (allowed.contains(object) || object->inherits("QWidgetWindow"))
  {
    return event->type() == QEvent::Close;
  }
  event->ignore();
  return true;
}

//------------------------------------------------------------------------------
void RunAbort::Abort()
{
  if (!this->Running || this->Running->GetAbortExecute())
  {
    return;
  }
  this->Running->SetAbortExecute(1);
  EnableApply(this->Source, this->Running);
}
