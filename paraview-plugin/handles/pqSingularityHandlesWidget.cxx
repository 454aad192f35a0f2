#include "pqSingularityHandlesWidget.h"

#include "AfterRun.h"
#include "SingularityTable.h"

#include "pqApplicationCore.h"
#include "pqCommandButtonPropertyWidget.h"
#include "pqPipelineSource.h"
#include "pqServerManagerModel.h"
#include "pqUndoStack.h"
#include "pqView.h"
#include "vtkCallbackCommand.h"
#include "vtkEventQtSlotConnect.h"
#include "vtkPVXMLElement.h"
#include "vtkRenderWindowInteractor.h"
#include "vtkRenderer.h"
#include "vtkSMPropertyGroup.h"
#include "vtkSMPropertyHelper.h"
#include "vtkSMProxy.h"
#include "vtkSMTrace.h"

#include <QCheckBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QScopedValueRollback>
#include <QShortcut>
#include <QVBoxLayout>

#include <algorithm>
#include <cmath>
#include <utility>

//------------------------------------------------------------------------------
pqSingularityHandlesWidget::pqSingularityHandlesWidget(
  vtkSMProxy* proxy, vtkSMPropertyGroup* group, QWidget* parent)
  : pqPropertyWidget(proxy, parent)
  , Singularities(group->GetProperty("Singularities"))
  , OutputRows(group->GetProperty("Rows"))
  , Plane(group->GetProperty("Plane"))
  , Triangles(group->GetProperty("Triangles"))
  , Dragging(group->GetProperty("Dragging"))
  , RequiredSum(group->GetProperty("RequiredSum"))
  , Reasons(group->GetProperty("Reasons"))
{
  this->setShowLabel(false);
  vtkPVXMLElement* hints = group->GetHints();
  this->MakePanel(!(hints && hints->FindNestedElementByName("WithoutRadius")));
  vtkPVXMLElement* fit = hints ? hints->FindNestedElementByName("RowsFitDomain") : nullptr;
  this->Domain = fit ? proxy->GetProperty(fit->GetAttribute("property")) : nullptr;

  this->Mouse->SetCallback(&pqSingularityHandlesWidget::OnMouse);
  this->Mouse->SetClientData(this);
  // Fires after pending events, so only the last of several moves is handled.
  this->FollowTimer.setSingleShot(true);
  this->FollowTimer.setInterval(0);
  QObject::connect(&this->FollowTimer, &QTimer::timeout, this, [this] { this->FollowMouse(); });

  if (!this->Singularities)
  {
    qCritical(
      "A property group with the widget SingularityHandles has no property with the function "
      "Singularities. Add it in the XML of the proxy.");
    this->setEnabled(false);
    return;
  }
  this->Connections->Connect(
    this->Singularities, vtkCommand::ModifiedEvent, this, SLOT(ReadProperty()));
  if (this->OutputRows || this->Plane)
  {
    this->Connections->Connect(
      proxy, vtkCommand::UpdateDataEvent, this, SLOT(ScheduleReadOutput()));
  }
  if (this->Domain)
  {
    this->Connections->Connect(this->Domain, vtkCommand::ModifiedEvent, this, SLOT(ReadProperty()));
  }
  this->FollowPipeline();
  this->ReadPlane();
  this->ReadExplanations();
  this->ReadProperty();
}

//------------------------------------------------------------------------------
pqSingularityHandlesWidget::~pqSingularityHandlesWidget()
{
  this->Connections->Disconnect();
  this->Detach();
}

//------------------------------------------------------------------------------
void pqSingularityHandlesWidget::MakePanel(bool hasRadius)
{
  auto* panel = new QVBoxLayout(this);
  panel->setContentsMargins(0, 0, 0, 0);
  // Buttons and sum are above the table, where they do not move when it grows.
  auto* buttons = new QHBoxLayout;
  panel->addLayout(buttons);
  const auto addButton = [&](const QString& text, const QString& name, const QString& help)
  {
    auto* button = new QPushButton(text, this);
    button->setObjectName(name);
    button->setToolTip(help);
    buttons->addWidget(button);
    return button;
  };
  const QPushButton* add = addButton("Add", "Add",
    "Adds a singularity beside the selected one, or at the view's centre: of quarter index \u22121 if the "
    "domain needs a smaller sum, otherwise +1.");
  const QPushButton* addPair = addButton("Add pair", "AddPair",
    "Adds a singularity of quarter index +1 and one of \u22121, which does not change the sum.");
  this->RemoveButton = addButton("Remove", "Remove", "Removes the selected singularity (Delete).");
  buttons->addStretch();

  auto* sum = new QHBoxLayout;
  panel->addLayout(sum);
  this->SumLabel = new QLabel(this);
  this->SumLabel->setObjectName("Sum");
  sum->addWidget(this->SumLabel);
  this->LiveBox = new QCheckBox("Live", this);
  this->LiveBox->setObjectName("Live");
  this->LiveBox->setChecked(true);
  this->LiveBox->setToolTip("Updates the pipeline while a handle is dragged; "
                            "off: when it is released.");
  sum->addSpacing(20);
  sum->addWidget(this->LiveBox);
  sum->addStretch();

  this->Table = new SingularityTable(this);
  if (!hasRadius)
  {
    this->Table->HideRadius();
  }
  panel->addWidget(this->Table);
  this->NoteLabel = new QLabel(this);
  this->NoteLabel->setObjectName("Note");
  this->NoteLabel->setWordWrap(true);
  panel->addWidget(this->NoteLabel);

  auto* deleteKey = new QShortcut(QKeySequence::Delete, this->Table);
  deleteKey->setContext(Qt::WidgetShortcut);
  QObject::connect(deleteKey, &QShortcut::activated, this, [this] { this->RemoveChosen(); });
  QObject::connect(add, &QPushButton::clicked, this, [this] { this->Add({ this->SumNeeded().value_or(this->Sum() + 1) < this->Sum() ? -1 : 1 }); });
  QObject::connect(addPair, &QPushButton::clicked, this, [this] { this->Add({ 1, -1 }); });
  QObject::connect(
    this->RemoveButton, &QPushButton::clicked, this, [this] { this->RemoveChosen(); });
  QObject::connect(this->Table, &SingularityTable::NumberTyped, this,
    [this](int row, int column, double number) { this->SetNumber(row, column, number); });
  QObject::connect(
    this->Table, &SingularityTable::RowChosen, this, [this](int row) { this->Choose(row); });
}

//------------------------------------------------------------------------------
void pqSingularityHandlesWidget::FollowPipeline()
{
  // A new connection may link the proxy to something that the view shows.
  auto* model = pqApplicationCore::instance()->getServerManagerModel();
  const auto update = [this] { this->UpdateHandles(); };
  QObject::connect(model,
    QOverload<pqPipelineSource*, pqPipelineSource*, int>::of(&pqServerManagerModel::connectionAdded),
    this, update);
  QObject::connect(model,
    QOverload<pqPipelineSource*, pqPipelineSource*, int>::of(
      &pqServerManagerModel::connectionRemoved),
    this, update);
}

//------------------------------------------------------------------------------
void pqSingularityHandlesWidget::ReadProperty()
{
  ++this->Changes;
  if (this->IsWriting)
  {
    return;
  }
  std::vector<SingularityRow> rows = this->PropertyRows();
  if (this->AreRowsComputed() && !this->Rows.empty())
  {
    rows = this->Rows; // until the filter has computed new ones
  }
  this->AdoptRows(rows);
}

//------------------------------------------------------------------------------
void pqSingularityHandlesWidget::ScheduleReadOutput()
{
  // Properties must not change during a pipeline update. If the property changes before the timer
  // fires, by undo for example, the output is out of date.
  AfterRun(this,
    [this, changes = this->Changes]
    {
      if (this->IsDragging)
      {
        return; // the plane does not change during a drag
      }
      this->ReadPlane();
      this->ReadExplanations();
      if (changes == this->Changes)
      {
        this->ReadOutput();
      }
    });
}

//------------------------------------------------------------------------------
void pqSingularityHandlesWidget::FollowCommands()
{
  // A command changes no property, so its button is the only sign of it.
  for (const auto* command : this->window()->findChildren<pqCommandButtonPropertyWidget*>())
  {
    for (const auto* button : command->findChildren<QPushButton*>())
    {
      if (command->proxy() == this->proxy())
      {
        QObject::connect(button, &QPushButton::clicked, this,
          &pqSingularityHandlesWidget::NoteCommand, Qt::UniqueConnection);
      }
    }
  }
}

//------------------------------------------------------------------------------
void pqSingularityHandlesWidget::NoteCommand()
{
  // Desktops add keyboard accelerators, marked by &.
  this->Command = qobject_cast<QPushButton*>(this->sender())->text().remove("&");
}

//------------------------------------------------------------------------------
void pqSingularityHandlesWidget::ReadPlane()
{
  if (!this->Plane)
  {
    return;
  }
  this->proxy()->UpdatePropertyInformation(this->Plane);
  const HandlePlane plane =
    HandlePlane::FromNumbers(vtkSMPropertyHelper(this->Plane).GetDoubleArray());
  HandleSurface surface;
  if (this->Triangles)
  {
    this->proxy()->UpdatePropertyInformation(this->Triangles);
    surface = HandleSurface(vtkSMPropertyHelper(this->Triangles).GetDoubleArray());
  }
  if (plane == this->Handles.GetPlane() && surface == this->Handles.GetSurface())
  {
    return;
  }
  this->Table->ShowHeight(!surface.IsEmpty());
  this->Handles.SetPlane(plane);
  this->Handles.SetSurface(std::move(surface));
  this->Handles.SetRows(this->Rows, this->Chosen);
  if (this->Handles.GetRenderer())
  {
    this->view()->render();
  }
}

//------------------------------------------------------------------------------
void pqSingularityHandlesWidget::ReadExplanations()
{
  if (this->RequiredSum)
  {
    this->proxy()->UpdatePropertyInformation(this->RequiredSum);
  }
  if (this->Reasons)
  {
    this->proxy()->UpdatePropertyInformation(this->Reasons);
    const vtkSMPropertyHelper reasons(this->Reasons);
    this->RowReasons.clear();
    for (unsigned int i = 0; i < reasons.GetNumberOfElements(); ++i)
    {
      this->RowReasons << QString::fromUtf8(reasons.GetAsString(i));
    }
  }
  if (this->RequiredSum || this->Reasons)
  {
    this->ShowRows();
  }
}

//------------------------------------------------------------------------------
int pqSingularityHandlesWidget::Sum() const
{
  int sum = 0;
  for (const SingularityRow& row : this->Rows)
  {
    sum += QuarterIndexOf(row);
  }
  return sum;
}

//------------------------------------------------------------------------------
/** Returns the sum that the filter reports. */
std::optional<int> pqSingularityHandlesWidget::SumNeeded() const
{
  if (!this->RequiredSum || vtkSMPropertyHelper(this->RequiredSum).GetNumberOfElements() == 0)
  {
    return std::nullopt;
  }
  return vtkSMPropertyHelper(this->RequiredSum).GetAsInt();
}

//------------------------------------------------------------------------------
bool pqSingularityHandlesWidget::AreSame(
  const std::vector<SingularityRow>& rows, const std::vector<SingularityRow>& others) const
{
  return HaveSamePositions(rows, others, !this->Handles.GetSurface().IsEmpty());
}

//------------------------------------------------------------------------------
void pqSingularityHandlesWidget::ReadOutput()
{
  if (!this->OutputRows || this->IsWriting)
  {
    return;
  }
  this->proxy()->UpdatePropertyInformation(this->OutputRows);
  const std::vector<SingularityRow> rows =
    RowsOf(vtkSMPropertyHelper(this->OutputRows).GetDoubleArray());
  const std::vector<SingularityRow> before = this->PropertyRows();
  const QString command = std::exchange(this->Command, QString());
  const bool isComputed = this->AreRowsComputed();
  if (isComputed && (command.isEmpty() || rows.empty() || this->AreSame(rows, this->Rows)))
  {
    this->AdoptRows(rows);
  }
  else if (!this->Domain && !rows.empty() && !this->AreSame(rows, before))
  {
    this->Commit(before, rows, command.isEmpty() ? "Move Singularities" : command);
  }
}

//------------------------------------------------------------------------------
std::vector<SingularityRow> pqSingularityHandlesWidget::PropertyRows() const
{
  return RowsOf(vtkSMPropertyHelper(this->Singularities).GetDoubleArray());
}

//------------------------------------------------------------------------------
/** Returns whether the value of the property stands for rows that the filter computes. */
bool pqSingularityHandlesWidget::AreRowsComputed() const
{
  if (this->Domain)
  {
    return vtkSMPropertyHelper(this->Domain).GetAsProxy() && this->Singularities->IsValueDefault();
  }
  return this->OutputRows && this->PropertyRows().empty();
}

//------------------------------------------------------------------------------
void pqSingularityHandlesWidget::AdoptRows(const std::vector<SingularityRow>& rows)
{
  // The dragged row may have been removed.
  this->EndDrag();
  this->Rows = rows;
  this->Chosen = std::min(this->Chosen, static_cast<int>(rows.size()) - 1);
  this->ShowRows();
  if (this->Handles.GetRenderer())
  {
    this->view()->render();
  }
}

//------------------------------------------------------------------------------
void pqSingularityHandlesWidget::WriteProperty(const std::vector<SingularityRow>& rows)
{
  const QScopedValueRollback<bool> writing(this->IsWriting, true);
  const std::vector<double> numbers = NumbersOf(rows);
  vtkSMPropertyHelper helper(this->Singularities);
  helper.SetNumberOfElements(static_cast<unsigned int>(numbers.size()));
  helper.Set(numbers.data(), static_cast<unsigned int>(numbers.size()));
  this->proxy()->UpdateVTKObjects();
}

//------------------------------------------------------------------------------
void pqSingularityHandlesWidget::Commit(const std::vector<SingularityRow>& before,
  const std::vector<SingularityRow>& after, const QString& what)
{
  {
    // The moves of a drag have been written already; undo and trace record one change from before
    // to after.
    SCOPED_UNDO_EXCLUDE();
    this->WriteProperty(before);
  }
  {
    SCOPED_UNDO_SET(what);
    SM_SCOPED_TRACE(PropertiesModified).arg("proxy", this->proxy());
    this->WriteProperty(after);
  }
  this->Rows = after;
  this->Chosen = std::min(this->Chosen, static_cast<int>(this->Rows.size()) - 1);
  this->ShowRows();
  if (this->view())
  {
    this->UpdatePipeline();
    LiveFrames::MarkOutdated(this->view(), this->proxy());
    this->view()->render();
  }
}

//------------------------------------------------------------------------------
void pqSingularityHandlesWidget::ShowRows()
{
  this->Table->ShowRows(this->Rows, this->Chosen);
  this->Handles.SetRows(this->Rows, this->Chosen);
  this->RemoveButton->setEnabled(this->Chosen >= 0);
  const int sum = this->Sum();
  const std::optional<int> needed = this->SumNeeded();
  this->SumLabel->setText(QString("Sum of quarter indices k: %1").arg(sum) +
    (!needed              ? QString()
        : *needed == sum ? QString(", as needed")
                         : QString(", needed: <b>%1</b>").arg(*needed)));
  this->ShowNote();
}

//------------------------------------------------------------------------------
void pqSingularityHandlesWidget::ShowNote()
{
  QString text;
  if (this->Domain && !vtkSMPropertyHelper(this->Domain).GetAsProxy())
  {
    text = "No domain is connected, so nothing checks whether these rows fit yours.";
    if (this->Singularities->IsValueDefault())
    {
      text = "No domain is connected: these rows are for the unit disk. Choose your domain as "
             "Domain for rows that fit it.";
    }
  }
  else if (this->Domain && this->Singularities->IsValueDefault())
  {
    text = "These rows fit the domain, and follow it until you change them.";
  }
  else if (this->Chosen >= 0 && this->Chosen < this->RowReasons.size())
  {
    text = QString("Row %1: %2").arg(this->Chosen + 1).arg(this->RowReasons[this->Chosen]);
  }
  this->NoteLabel->setText(text);
  this->NoteLabel->setVisible(!text.isEmpty());
}

//------------------------------------------------------------------------------
void pqSingularityHandlesWidget::Choose(int row)
{
  if (row == this->Chosen)
  {
    return;
  }
  this->Chosen = row;
  this->ShowRows();
  if (this->Handles.GetRenderer())
  {
    this->view()->render();
  }
}

//------------------------------------------------------------------------------
void pqSingularityHandlesWidget::SetNumber(int row, int column, double number)
{
  std::vector<SingularityRow> rows = this->Rows;
  rows.at(static_cast<std::size_t>(row)).at(static_cast<std::size_t>(column)) = number;
  this->Commit(this->PropertyRows(), rows, "Edit Singularity");
}

//------------------------------------------------------------------------------
void pqSingularityHandlesWidget::Add(const std::vector<int>& quarterIndices)
{
  std::vector<SingularityRow> rows = this->Rows;
  // Defaults if the active view has no handles: at the origin, 0.1 apart.
  SingularityRow middle = { 0, 0, 0, 0.1 }; // the radius as in the default rows
  if (!rows.empty())
  {
    middle[3] = this->Chosen >= 0 ? rows[this->Chosen][3] : rows.back()[3];
  }
  double distance = 0.1;
  std::array<double, 2> pixel = { 0, 0 };
  if (vtkRenderer* renderer = this->Handles.GetRenderer())
  {
    const int* size = renderer->GetSize();
    pixel = { size[0] / 2.0, size[1] / 2.0 };
    if (this->Chosen >= 0)
    {
      pixel = this->Handles.PixelOf(rows[this->Chosen]);
    }
    const auto found = this->Handles.Moved(middle, pixel[0], pixel[1]);
    const auto beside =
      this->Handles.Moved(middle, pixel[0] + this->Handles.GetSpacing(), pixel[1]);
    middle = found.value_or(middle);
    if (found && beside)
    {
      distance = std::hypot((*beside)[0] - middle[0], (*beside)[1] - middle[1]);
    }
  }
  for (const int quarterIndex : quarterIndices)
  {
    SingularityRow added = middle;
    if (this->Handles.GetSurface().IsEmpty())
    {
      const std::array<double, 2> free = FindFreePosition(rows, { middle[0], middle[1] }, distance);
      added[0] = free[0];
      added[1] = free[1];
    }
    else if (this->Handles.GetRenderer())
    {
      added = this->Handles.FindFreeRow(rows, middle, pixel);
    }
    added[2] = quarterIndex;
    rows.push_back(added);
  }
  this->Chosen = static_cast<int>(rows.size()) - 1;
  this->Commit(this->PropertyRows(), rows,
    quarterIndices.size() > 1 ? "Add Pair of Singularities" : "Add Singularity");
}

//------------------------------------------------------------------------------
void pqSingularityHandlesWidget::RemoveChosen()
{
  if (this->Chosen < 0)
  {
    return;
  }
  std::vector<SingularityRow> rows = this->Rows;
  rows.erase(rows.begin() + this->Chosen);
  this->Commit(this->PropertyRows(), rows, "Remove Singularity");
}
