/**
 * @class   pqSideTableWidget
 * @brief   table in the panel of what is prescribed for the sides of a domain
 *
 * Shows a property of texts, four in each row: the name of a side, its number of edges, their
 * progression and their length. Names are typed, or chosen from those of the last mesh, which the
 * proxy reports in the information properties `SideNames` and `SidePlaces` (three numbers each); a
 * check box shows them in the view. Like other properties, the rows take effect with *Apply*.
 *
 * In the XML of a proxy, set `panel_widget="side_table"` on a StringVectorProperty.
 */

#ifndef pqSideTableWidget_h
#define pqSideTableWidget_h

#include "SideLabels.h"

#include "pqPropertyWidget.h"
#include "vtkNew.h"

#include <QList>
#include <QStringList>
#include <QVariant>

#include <vector>

class QCheckBox;
class QPushButton;
class QTableWidget;
class vtkEventQtSlotConnect;

class pqSideTableWidget : public pqPropertyWidget
{
  Q_OBJECT
  Q_PROPERTY(QList<QVariant> texts READ GetTexts WRITE SetTexts NOTIFY TextsChanged)

public:
  pqSideTableWidget(vtkSMProxy* proxy, vtkSMProperty* property, QWidget* parent = nullptr);
  ~pqSideTableWidget() override;

  QList<QVariant> GetTexts() const;
  void SetTexts(const QList<QVariant>& texts);

  void select() override;
  void selectPort(int port) override;
  void deselect() override;

public Q_SLOTS:
  void setView(pqView* view) override;

Q_SIGNALS:
  void TextsChanged();

protected:
  void showEvent(QShowEvent* event) override;
  void hideEvent(QHideEvent* event) override;

private Q_SLOTS:
  void ScheduleReadNames();

private:
  Q_DISABLE_COPY(pqSideTableWidget)

  void MakePanel(const QString& label, const QString& help);
  void AddRow(const QStringList& texts);
  void RemoveRow();
  void FitHeight();
  void ReadNames();
  void UpdateLabels();

  vtkNew<vtkEventQtSlotConnect> Connections;
  QStringList Names; ///< From which a name is chosen.
  std::vector<SideLabels::Label> Sides;
  SideLabels Labels;
  QTableWidget* Table = nullptr;
  QCheckBox* NamesBox = nullptr;
  QPushButton* RemoveButton = nullptr;
};

#endif
