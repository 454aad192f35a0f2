#include "SingularityTable.h"

#include <QDoubleValidator>
#include <QHeaderView>
#include <QIntValidator>
#include <QLineEdit>
#include <QScrollBar>
#include <QSignalBlocker>
#include <QStyledItemDelegate>

#include <algorithm>

namespace
{
constexpr int QuarterIndexColumn = 2;
constexpr int RadiusColumn = 3;
constexpr const char* RadiusHeader = "radius";

QString ShortText(double number, int column)
{
  if (column != QuarterIndexColumn)
  {
    // -0.000763 would be too wide for its column.
    return QString::number(number, 'g', qAbs(number) < 1e-3 ? 1 : 3);
  }
  const int quarterIndex = qRound(number);
  const QString digits = QString::number(qAbs(quarterIndex));
  return quarterIndex == 0 ? digits : (quarterIndex > 0 ? "+" : "\u2212") + digits;
}

/** Shows rounded numbers; the model keeps all digits unless the user types another number. */
class NumberDelegate final : public QStyledItemDelegate
{
public:
  using QStyledItemDelegate::QStyledItemDelegate;

  QWidget* createEditor(
    QWidget* parent, const QStyleOptionViewItem&, const QModelIndex& index) const override
  {
    auto* editor = new QLineEdit(parent);
    editor->setFrame(false);
    if (index.column() == QuarterIndexColumn)
    {
      editor->setValidator(new QIntValidator(editor));
    }
    else
    {
      auto* validator = new QDoubleValidator(editor);
      validator->setLocale(QLocale::c()); // a decimal point in every language, as in ParaView
      const QAbstractItemModel* model = index.model();
      if (index.column() == RadiusColumn &&
        model->headerData(RadiusColumn, Qt::Horizontal).toString() == RadiusHeader)
      {
        validator->setBottom(0);
      }
      editor->setValidator(validator);
    }
    return editor;
  }

  void setEditorData(QWidget* editor, const QModelIndex& index) const override
  {
    static_cast<QLineEdit*>(editor)->setText(
      QString::number(index.data(Qt::EditRole).toDouble(), 'g', 6));
  }

  void setModelData(
    QWidget* editor, QAbstractItemModel* model, const QModelIndex& index) const override
  {
    const auto* line = static_cast<QLineEdit*>(editor);
    bool isNumber = false;
    const double number = QLocale::c().toDouble(line->text(), &isNumber);
    if (line->isModified() && isNumber)
    {
      model->setData(index, number, Qt::EditRole);
    }
  }

  void initStyleOption(QStyleOptionViewItem* option, const QModelIndex& index) const override
  {
    QStyledItemDelegate::initStyleOption(option, index);
    const double number = index.data(Qt::EditRole).toDouble();
    option->text = ShortText(number, index.column());
    option->displayAlignment = Qt::AlignRight | Qt::AlignVCenter;
    if (index.column() == QuarterIndexColumn && qRound(number) != 0)
    {
      option->font.setBold(true);
      // Same colours as the handles.
      option->palette.setColor(
        QPalette::Text, number > 0 ? QColor(217, 26, 26) : QColor(26, 51, 217));
    }
  }
};
}

//------------------------------------------------------------------------------
SingularityTable::SingularityTable(QWidget* parent)
  : QTableWidget(0, 4, parent)
{
  this->setObjectName("SingularityTable");
  this->setHorizontalHeaderLabels({ "x", "y", "k", RadiusHeader });
  this->horizontalHeaderItem(QuarterIndexColumn)
    ->setToolTip(
      "Quarter index, four times the index of the singularity: "
      "+1 is a node of valence 3 of a quad mesh, \u22121 one of valence 5; see docs/glossary.md.");
  // The panel may be wider than its visible part: columns are as narrow as the numbers allow, and
  // k, which identifies handles, comes first.
  this->horizontalHeader()->setDefaultSectionSize(
    this->fontMetrics().horizontalAdvance("-0.12345") + 8);
  this->horizontalHeader()->resizeSection(
    QuarterIndexColumn, this->fontMetrics().horizontalAdvance("+10") + 12);
  this->horizontalHeader()->moveSection(QuarterIndexColumn, 0);
  this->verticalHeader()->setDefaultSectionSize(this->fontMetrics().height() + 6);
  this->setSelectionBehavior(QAbstractItemView::SelectRows);
  this->setSelectionMode(QAbstractItemView::SingleSelection);
  this->setAlternatingRowColors(true);
  this->setItemDelegate(new NumberDelegate(this));
  QObject::connect(this, &QTableWidget::cellChanged, this,
    [this](int row, int column) {
      Q_EMIT this->NumberTyped(row, column, this->item(row, column)->data(Qt::EditRole).toDouble());
    });
  QObject::connect(this, &QTableWidget::itemSelectionChanged, this,
    [this]
    {
      const QModelIndexList chosen = this->selectionModel()->selectedRows();
      Q_EMIT this->RowChosen(chosen.empty() ? -1 : chosen.front().row());
    });
  this->ShowHeight(false);
}

//------------------------------------------------------------------------------
void SingularityTable::HideRadius()
{
  this->HasRadius = false;
  this->ShowHeight(false);
}

//------------------------------------------------------------------------------
void SingularityTable::ShowHeight(bool isShown)
{
  QTableWidgetItem* header = this->horizontalHeaderItem(RadiusColumn);
  header->setText(isShown ? "z" : RadiusHeader);
  header->setToolTip(isShown ? "" : "Radius of the hole that Drill Holes drills there.");
  this->setColumnHidden(RadiusColumn, !isShown && !this->HasRadius);
  this->UpdateFixedSize(this->rowCount());
}

//------------------------------------------------------------------------------
void SingularityTable::ShowRows(const std::vector<SingularityRow>& rows, int chosen)
{
  const QSignalBlocker blocker(this);
  const int count = static_cast<int>(rows.size());
  if (this->rowCount() != count)
  {
    this->setRowCount(count);
    this->UpdateFixedSize(count);
  }
  for (int row = 0; row < count; ++row)
  {
    for (int column = 0; column < 4; ++column)
    {
      const double number = rows[row][column];
      QTableWidgetItem* item = this->item(row, column);
      if (!item)
      {
        item = new QTableWidgetItem;
        this->setItem(row, column, item);
      }
      item->setData(Qt::EditRole, number);
      item->setToolTip(QString::number(number, 'g', 17));
    }
  }
  if (chosen < 0)
  {
    this->clearSelection();
  }
  else if (!this->selectionModel()->isRowSelected(chosen, QModelIndex()))
  {
    this->selectRow(chosen);
  }
}

//------------------------------------------------------------------------------
void SingularityTable::UpdateFixedSize(int rows)
{
  // Usual configurations fit without scrolling.
  const int shown = std::clamp(rows, 2, 12);
  const int height = this->horizontalHeader()->sizeHint().height() +
    shown * this->verticalHeader()->defaultSectionSize();
  int width = this->verticalHeader()->sizeHint().width() + this->horizontalHeader()->length();
  if (rows > shown)
  {
    width += this->verticalScrollBar()->sizeHint().width();
  }
  this->setFixedSize(width + 2 * this->frameWidth(), height + 2 * this->frameWidth());
}
