#include "ViewMessages.h"

#include "AfterRun.h"
#include "TextLook.h"
#include "ViewSources.h"

#include "pqApplicationCore.h"
#include "pqCoreUtilities.h"
#include "pqOutputWidget.h"
#include "pqPipelineSource.h"
#include "pqServer.h"
#include "pqServerManagerModel.h"
#include "vtkAlgorithm.h"
#include "vtkCallbackCommand.h"
#include "vtkNew.h"
#include "vtkOutputWindow.h"
#include "vtkSMProxy.h"

#include <QSignalBlocker>

#include <algorithm>
#include <functional>
#include <utility>

namespace
{
int Suspensions = 0;

/** Adds a message to the window Output Messages, which its signal would open. */
void AddQuietly(const QString& text, bool isError)
{
  if (auto* window = pqCoreUtilities::mainWidget()->findChild<pqOutputWidget*>())
  {
    const QSignalBlocker blocker(window);
    window->displayMessage(text, isError ? QtCriticalMsg : QtWarningMsg);
  }
}
}

//------------------------------------------------------------------------------
ViewMessages::Suspension::Suspension()
{
  ++Suspensions;
}

//------------------------------------------------------------------------------
ViewMessages::Suspension::~Suspension()
{
  --Suspensions;
}

//------------------------------------------------------------------------------
ViewMessages::ViewMessages(QObject* parent)
  : QObject(parent)
{
}

//------------------------------------------------------------------------------
void ViewMessages::startup()
{
  pqServerManagerModel* model = pqApplicationCore::instance()->getServerManagerModel();
  QObject::connect(model, &pqServerManagerModel::sourceAdded, this, &ViewMessages::Observe);
  for (auto* source : model->findItems<pqPipelineSource*>())
  {
    this->Observe(source);
  }
}

//------------------------------------------------------------------------------
void ViewMessages::shutdown()
{
  if (pqApplicationCore* core = pqApplicationCore::instance())
  {
    QObject::disconnect(core->getServerManagerModel(), nullptr, this, nullptr);
  }
}

//------------------------------------------------------------------------------
void ViewMessages::Observe(pqPipelineSource* source)
{
  auto* algorithm = vtkAlgorithm::SafeDownCast(source->getProxy()->GetClientSideObject());
  if (!algorithm || source->getServer()->isRemote() || !ViewSources::IsOwn(source->getProxy()))
  {
    return;
  }
  // VTK shows no message for which there is an observer.
  using Observer = std::function<void(unsigned long, const char*)>;
  vtkNew<vtkCallbackCommand> command;
  command->SetClientData(new Observer(
    [self = QPointer<ViewMessages>(this), observed = QPointer<pqPipelineSource>(source)](
      unsigned long event, const char* text)
    {
      if (self)
      {
        self->Add({ observed, QString::fromUtf8(text), event == vtkCommand::ErrorEvent });
      }
    }));
  command->SetClientDataDeleteCallback([](void* data) { delete static_cast<Observer*>(data); });
  command->SetCallback([](vtkObject*, unsigned long event, void* data, void* text)
    { (*static_cast<Observer*>(data))(event, static_cast<const char*>(text)); });
  algorithm->AddObserver(vtkCommand::ErrorEvent, command);
  algorithm->AddObserver(vtkCommand::WarningEvent, command);
}

//------------------------------------------------------------------------------
void ViewMessages::Add(const Message& message)
{
  if (Suspensions > 0)
  {
    return;
  }
  if (this->Pending.empty())
  {
    // Texts are written at the end of the update.
    AfterRun(this, [this] { this->Show(); });
  }
  this->Pending.push_back(message);
}

//------------------------------------------------------------------------------
void ViewMessages::Show()
{
  for (const Message& message : std::exchange(this->Pending, {}))
  {
    const std::vector<const pqPipelineSource*> sources = message.source
      ? ViewSources::WithDownstream(message.source)
      : std::vector<const pqPipelineSource*>();
    if (std::any_of(sources.begin(), sources.end(), &TextLook::ReportsProblem))
    {
      AddQuietly(message.text, message.isError);
    }
    else if (message.isError)
    {
      vtkOutputWindow::GetInstance()->DisplayErrorText(message.text.toUtf8());
    }
    else
    {
      vtkOutputWindow::GetInstance()->DisplayWarningText(message.text.toUtf8());
    }
  }
}
