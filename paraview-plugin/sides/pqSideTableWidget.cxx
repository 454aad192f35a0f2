#include "pqSideTableWidget.h"

#include "AfterRun.h"
#include "ViewSources.h"

#include "pqView.h"
#include "vtkCommand.h"
#include "vtkEventQtSlotConnect.h"
#include "vtkPVRenderView.h"
#include "vtkRenderer.h"
#include "vtkSMDocumentation.h"
#include "vtkSMProperty.h"
#include "vtkSMPropertyHelper.h"
#include "vtkSMProxy.h"
#include "vtkSMViewProxy.h"

#include <QCheckBox>
#include <QComboBox>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QPushButton>
#include <QSignalBlocker>
#include <QTableWidget>
#include <QVBoxLayout>

#include <algorithm>

namespace
{
constexpr int Columns = 4;

/** Stands for every side of the holes. */
constexpr const char* AllHoles = "holes";
}

//------------------------------------------------------------------------------
pqSideTableWidget::pqSideTableWidget(vtkSMProxy* proxy, vtkSMProperty* property, QWidget* parent)
  : pqPropertyWidget(proxy, parent)
{
  this->setShowLabel(false);
  this->setChangeAvailableAsChangeFinished(true);
  vtkSMDocumentation* documentation = property->GetDocumentation();
  this->MakePanel(property->GetXMLLabel(),
    documentation ? QString(documentation->GetDescription()).simplified() : QString());
  this->addPropertyLink(this, "texts", SIGNAL(TextsChanged()), property);
  this->Connections->Connect(proxy, vtkCommand::UpdateDataEvent, this, SLOT(ScheduleReadNames()));
  this->ReadNames();
}

//------------------------------------------------------------------------------
pqSideTableWidget::~pqSideTableWidget()
{
  this->Connections->Disconnect();
}

//------------------------------------------------------------------------------
void pqSideTableWidget::MakePanel(const QString& label, const QString& help)
{
  auto* panel = new QVBoxLayout(this);
  panel->setContentsMargins(0, 0, 0, 0);
  auto* top = new QHBoxLayout;
  panel->addLayout(top);
  top->addWidget(new QLabel(label, this));
  this->NamesBox = new QCheckBox("Names in the view", this);
  this->NamesBox->setObjectName("NamesInView");
  this->NamesBox->setToolTip("Shows the names of the sides in the view, after the first Apply.");
  top->addWidget(this->NamesBox);
  top->addStretch();
  auto* add = new QPushButton("Add side", this);
  add->setObjectName("AddSide");
  add->setToolTip("Adds a row: choose or type the name of a side, and what is prescribed for it.");
  top->addWidget(add);
  this->RemoveButton = new QPushButton("Remove", this);
  this->RemoveButton->setObjectName("RemoveSide");
  this->RemoveButton->setToolTip("Removes the selected row, or the last one.");
  top->addWidget(this->RemoveButton);

  this->Table = new QTableWidget(0, Columns, this);
  this->Table->setObjectName("SideTable");
  this->Table->setHorizontalHeaderLabels({ "side", "edges", "progression", "size" });
  const char* tips[Columns] = { "Name of a side; holes stands for every side of the holes.",
    "Number of edges of the whole side, the sum over all loops with its name.",
    "Last edge over first, as 1.5 or both:1.5, or their lengths, as 0.01,0.2.",
    "Length of its edges." };
  for (int column = 0; column < Columns; ++column)
  {
    this->Table->horizontalHeaderItem(column)->setToolTip(tips[column]);
  }
  this->Table->horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
  this->Table->horizontalHeader()->setSectionResizeMode(0, QHeaderView::Stretch);
  this->Table->verticalHeader()->setDefaultSectionSize(this->fontMetrics().height() + 10);
  this->Table->verticalHeader()->hide();
  this->Table->setSelectionBehavior(QAbstractItemView::SelectRows);
  this->Table->setToolTip(help);
  panel->addWidget(this->Table);
  this->FitHeight();

  QObject::connect(add, &QPushButton::clicked, this,
    [this]
    {
      this->AddRow({});
      this->Table->selectRow(this->Table->rowCount() - 1);
      Q_EMIT this->TextsChanged();
    });
  QObject::connect(
    this->RemoveButton, &QPushButton::clicked, this, [this] { this->RemoveRow(); });
  QObject::connect(
    this->Table, &QTableWidget::cellChanged, this, [this] { Q_EMIT this->TextsChanged(); });
  QObject::connect(
    this->NamesBox, &QCheckBox::toggled, this, [this] { this->UpdateLabels(); });
}

//------------------------------------------------------------------------------
QList<QVariant> pqSideTableWidget::GetTexts() const
{
  QList<QVariant> texts;
  for (int row = 0; row < this->Table->rowCount(); ++row)
  {
    texts << static_cast<QComboBox*>(this->Table->cellWidget(row, 0))->currentText().trimmed();
    for (int column = 1; column < Columns; ++column)
    {
      texts << this->Table->item(row, column)->text().trimmed();
    }
  }
  return texts;
}

//------------------------------------------------------------------------------
void pqSideTableWidget::SetTexts(const QList<QVariant>& texts)
{
  if (texts == this->GetTexts())
  {
    return;
  }
  {
    const QSignalBlocker blocker(this->Table);
    this->Table->setRowCount(0);
    for (int first = 0; first + Columns <= texts.size(); first += Columns)
    {
      QStringList row;
      for (int column = 0; column < Columns; ++column)
      {
        row << texts[first + column].toString();
      }
      this->AddRow(row);
    }
    this->FitHeight();
  }
  Q_EMIT this->TextsChanged();
}

//------------------------------------------------------------------------------
/** Adds a row with texts, empty ones if there are none. */
void pqSideTableWidget::AddRow(const QStringList& texts)
{
  const QSignalBlocker blocker(this->Table);
  const int row = this->Table->rowCount();
  this->Table->insertRow(row);
  auto* names = new QComboBox(this->Table);
  names->setEditable(true);
  names->addItems(this->Names);
  names->setCurrentText(texts.value(0));
  QObject::connect(
    names, &QComboBox::currentTextChanged, this, [this] { Q_EMIT this->TextsChanged(); });
  this->Table->setCellWidget(row, 0, names);
  for (int column = 1; column < Columns; ++column)
  {
    this->Table->setItem(row, column, new QTableWidgetItem(texts.value(column)));
  }
  this->FitHeight();
}

//------------------------------------------------------------------------------
void pqSideTableWidget::RemoveRow()
{
  const int chosen = this->Table->currentRow();
  this->Table->removeRow(chosen >= 0 ? chosen : this->Table->rowCount() - 1);
  this->FitHeight();
  Q_EMIT this->TextsChanged();
}

//------------------------------------------------------------------------------
void pqSideTableWidget::FitHeight()
{
  const int shown = std::clamp(this->Table->rowCount(), 1, 8);
  this->Table->setFixedHeight(this->Table->horizontalHeader()->sizeHint().height() +
    shown * this->Table->verticalHeader()->defaultSectionSize() + 2 * this->Table->frameWidth());
  this->RemoveButton->setEnabled(this->Table->rowCount() > 0);
}

//------------------------------------------------------------------------------
void pqSideTableWidget::ScheduleReadNames()
{
  AfterRun(this, [this] { this->ReadNames(); });
}

//------------------------------------------------------------------------------
void pqSideTableWidget::ReadNames()
{
  vtkSMProperty* names = this->proxy()->GetProperty("SideNames");
  vtkSMProperty* places = this->proxy()->GetProperty("SidePlaces");
  if (!names || !places)
  {
    return;
  }
  this->proxy()->UpdatePropertyInformation(names);
  this->proxy()->UpdatePropertyInformation(places);
  const std::vector<double> numbers = vtkSMPropertyHelper(places).GetDoubleArray();
  const unsigned int count = vtkSMPropertyHelper(names).GetNumberOfElements();
  this->Names.clear();
  this->Sides.clear();
  for (unsigned int i = 0; i < count; ++i)
  {
    const std::string name = vtkSMPropertyHelper(names).GetAsString(i);
    this->Names << QString::fromStdString(name);
    if (3 * i + 2 < numbers.size())
    {
      this->Sides.push_back({ name, { numbers[3 * i], numbers[3 * i + 1], numbers[3 * i + 2] } });
    }
  }
  if (!this->Names.isEmpty())
  {
    this->Names << AllHoles;
  }
  for (int row = 0; row < this->Table->rowCount(); ++row)
  {
    auto* list = static_cast<QComboBox*>(this->Table->cellWidget(row, 0));
    const QSignalBlocker blocker(list);
    const QString text = list->currentText();
    list->clear();
    list->addItems(this->Names);
    list->setCurrentText(text);
  }
  this->UpdateLabels();
}

//------------------------------------------------------------------------------
/** Shows the names in the view if the box is checked and the panel shows the proxy. */
void pqSideTableWidget::UpdateLabels()
{
  if (!this->view() || !this->view()->widget())
  {
    this->Labels.Show(nullptr, {}, 1);
    return;
  }
  vtkSMViewProxy* viewProxy = this->view()->getViewProxy();
  auto* renderView =
    viewProxy ? vtkPVRenderView::SafeDownCast(viewProxy->GetClientSideObject()) : nullptr;
  const bool isShown = this->NamesBox->isChecked() && this->isSelected() && this->isVisible() &&
    renderView && ViewSources::IsConnected(this->proxy(), this->view());
  if (!isShown && !this->Labels.IsShown())
  {
    return;
  }
  this->Labels.Show(isShown ? renderView->GetNonCompositedRenderer() : nullptr, this->Sides,
    this->view()->widget()->devicePixelRatioF());
  this->view()->render();
}

//------------------------------------------------------------------------------
void pqSideTableWidget::select()
{
  pqPropertyWidget::select();
  this->UpdateLabels();
}

//------------------------------------------------------------------------------
void pqSideTableWidget::selectPort(int)
{
  this->select();
}

//------------------------------------------------------------------------------
void pqSideTableWidget::deselect()
{
  pqPropertyWidget::deselect();
  this->UpdateLabels();
}

//------------------------------------------------------------------------------
void pqSideTableWidget::setView(pqView* view)
{
  this->Labels.Show(nullptr, {}, 1);
  pqPropertyWidget::setView(view);
  this->UpdateLabels();
}

//------------------------------------------------------------------------------
void pqSideTableWidget::showEvent(QShowEvent* event)
{
  pqPropertyWidget::showEvent(event);
  this->UpdateLabels();
}

//------------------------------------------------------------------------------
void pqSideTableWidget::hideEvent(QHideEvent* event)
{
  pqPropertyWidget::hideEvent(event);
  this->UpdateLabels();
}
