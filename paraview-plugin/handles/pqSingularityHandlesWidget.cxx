#include "pqSingularityHandlesWidget.h"

#include "SingularityTable.h"

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

//------------------------------------------------------------------------------
pqSingularityHandlesWidget::pqSingularityHandlesWidget(
  vtkSMProxy* proxy, vtkSMPropertyGroup* group, QWidget* parent)
  : pqPropertyWidget(proxy, parent)
  , Singularities(group->GetProperty("Singularities"))
  , OutputRows(group->GetProperty("Rows"))
  , Plane(group->GetProperty("Plane"))
  , Dragging(group->GetProperty("Dragging"))
{
  this->setShowLabel(false);
  vtkPVXMLElement* hints = group->GetHints();
  this->MakePanel(!(hints && hints->FindNestedElementByName("WithoutRadius")));

  this->Mouse->SetCallback(&pqSingularityHandlesWidget::OnMouse);
  this->Mouse->SetClientData(this);
  // After the events that wait: of several moves the last counts.
  this->FollowTimer.setSingleShot(true);
  this->FollowTimer.setInterval(0);
  QObject::connect(&this->FollowTimer, &QTimer::timeout, this, [this] { this->Follow(); });

  if (!this->Singularities)
  {
    qCritical("A property group of the widget SingularityHandles has no property of the function "
              "Singularities; name it in the XML of the proxy.");
    this->setEnabled(false);
    return;
  }
  this->Connections->Connect(
    this->Singularities, vtkCommand::ModifiedEvent, this, SLOT(ReadProperty()));
  if (this->OutputRows || this->Plane)
  {
    this->Connections->Connect(proxy, vtkCommand::UpdateDataEvent, this, SLOT(ReadOutputLater()));
  }
  this->ReadPlane();
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
  auto* whole = new QVBoxLayout(this);
  whole->setContentsMargins(0, 0, 0, 0);
  this->Table = new SingularityTable(this);
  if (!hasRadius)
  {
    this->Table->HideRadius();
  }
  whole->addWidget(this->Table);

  auto* buttons = new QHBoxLayout;
  whole->addLayout(buttons);
  const auto addButton = [&](const QString& text, const QString& name, const QString& help)
  {
    auto* button = new QPushButton(text, this);
    button->setObjectName(name);
    button->setToolTip(help);
    buttons->addWidget(button);
    return button;
  };
  const QPushButton* add = addButton("Add", "Add",
    "Adds a singularity of quarter index +1 beside the chosen one, or in the middle of the view.");
  const QPushButton* addPair = addButton("Add pair", "AddPair",
    "Adds a singularity of quarter index +1 and one of \u22121, which leave the sum as it is.");
  this->RemoveButton = addButton("Remove", "Remove", "Removes the chosen singularity (Delete).");
  buttons->addStretch();
  auto* deleteKey = new QShortcut(QKeySequence::Delete, this->Table);
  deleteKey->setContext(Qt::WidgetShortcut);
  QObject::connect(deleteKey, &QShortcut::activated, this, [this] { this->RemoveChosen(); });
  QObject::connect(add, &QPushButton::clicked, this, [this] { this->Add({ 1 }); });
  QObject::connect(addPair, &QPushButton::clicked, this, [this] { this->Add({ 1, -1 }); });
  QObject::connect(
    this->RemoveButton, &QPushButton::clicked, this, [this] { this->RemoveChosen(); });

  auto* bottom = new QHBoxLayout;
  whole->addLayout(bottom);
  this->SumLabel = new QLabel(this);
  bottom->addWidget(this->SumLabel);
  this->LiveBox = new QCheckBox("Live", this);
  this->LiveBox->setObjectName("Live");
  this->LiveBox->setChecked(true);
  this->LiveBox->setToolTip("What follows in the pipeline is updated while a handle is dragged; "
                            "off: when it is let go.");
  bottom->addSpacing(20);
  bottom->addWidget(this->LiveBox);
  bottom->addStretch();

  QObject::connect(this->Table, &SingularityTable::NumberTyped, this,
    [this](int row, int column, double number) { this->SetNumber(row, column, number); });
  QObject::connect(
    this->Table, &SingularityTable::RowChosen, this, [this](int row) { this->Choose(row); });
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
  if (rows.empty() && this->OutputRows)
  {
    rows = this->Rows; // until the filter has found others
  }
  this->TakeRows(rows);
}

//------------------------------------------------------------------------------
void pqSingularityHandlesWidget::ReadOutputLater()
{
  // Properties are not to be changed while a pipeline is updated; and if the property has changed until
  // then, by undo for example, what came out is not what comes of it.
  QTimer::singleShot(0, this,
    [this, changes = this->Changes]
    {
      if (this->IsDragging)
      {
        return; // nor does the plane change then
      }
      this->ReadPlane();
      if (changes == this->Changes)
      {
        this->ReadOutput();
      }
    });
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
    HandlePlane::Of(vtkSMPropertyHelper(this->Plane).GetDoubleArray());
  if (plane == this->Handles.GetPlane())
  {
    return;
  }
  this->Handles.SetPlane(plane);
  this->Handles.SetRows(this->Rows, this->Chosen);
  if (this->Handles.GetRenderer())
  {
    this->view()->render();
  }
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
  if (before.empty())
  {
    this->TakeRows(rows);
  }
  else if (!rows.empty() && !HaveSamePlaces(rows, before))
  {
    this->Commit(before, rows, "Move Singularities");
  }
}

//------------------------------------------------------------------------------
std::vector<SingularityRow> pqSingularityHandlesWidget::PropertyRows() const
{
  return RowsOf(vtkSMPropertyHelper(this->Singularities).GetDoubleArray());
}

//------------------------------------------------------------------------------
void pqSingularityHandlesWidget::TakeRows(const std::vector<SingularityRow>& rows)
{
  // What was dragged may not be there any more.
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
    // Moves of a drag have been written already; undo and trace see one change from before to after.
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
    this->view()->render();
  }
}

//------------------------------------------------------------------------------
void pqSingularityHandlesWidget::ShowRows()
{
  this->Table->ShowRows(this->Rows, this->Chosen);
  this->Handles.SetRows(this->Rows, this->Chosen);
  this->RemoveButton->setEnabled(this->Chosen >= 0);
  int sum = 0;
  for (const SingularityRow& row : this->Rows)
  {
    sum += QuarterIndexOf(row);
  }
  this->SumLabel->setText(QString("Sum of k: %1").arg(sum));
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
  this->Commit(this->Rows, rows, "Edit Singularity");
}

//------------------------------------------------------------------------------
void pqSingularityHandlesWidget::Add(const std::vector<int>& quarterIndices)
{
  std::vector<SingularityRow> rows = this->Rows;
  // Without a view, as in the panel of another kind of view, at the origin, a tenth apart.
  std::array<double, 2> middle = { 0, 0 };
  double distance = 0.1;
  if (vtkRenderer* renderer = this->Handles.GetRenderer())
  {
    const int* size = renderer->GetSize();
    std::array<double, 2> pixel = { size[0] / 2.0, size[1] / 2.0 };
    if (this->Chosen >= 0)
    {
      const SingularityRow& chosen = rows[static_cast<std::size_t>(this->Chosen)];
      pixel = this->Handles.PixelOf({ chosen[0], chosen[1] });
    }
    // Five radii from middle to middle: what goes on between them is seen.
    const auto found = this->Handles.PlanePointAt(pixel[0], pixel[1]);
    const auto beside =
      this->Handles.PlanePointAt(pixel[0] + 5 * this->Handles.GetDiscRadius(), pixel[1]);
    middle = found.value_or(middle);
    if (found && beside)
    {
      distance = std::hypot((*beside)[0] - middle[0], (*beside)[1] - middle[1]);
    }
  }
  double radius = 0.1; // that of the defaults
  if (!rows.empty())
  {
    radius = this->Chosen >= 0 ? rows[static_cast<std::size_t>(this->Chosen)][3] : rows.back()[3];
  }
  for (const int quarterIndex : quarterIndices)
  {
    const std::array<double, 2> place = FreePlace(rows, middle, distance);
    rows.push_back({ place[0], place[1], static_cast<double>(quarterIndex), radius });
  }
  this->Chosen = static_cast<int>(rows.size()) - 1;
  this->Commit(
    this->Rows, rows, quarterIndices.size() > 1 ? "Add Pair of Singularities" : "Add Singularity");
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
  this->Commit(this->Rows, rows, "Remove Singularity");
}
