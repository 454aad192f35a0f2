#include "pqOptionalInputWidget.h"

#include "AfterRun.h"
#include "ViewSources.h"

#include "pqActiveObjects.h"
#include "pqApplicationCore.h"
#include "pqPipelineSource.h"
#include "pqServerManagerModel.h"
#include "vtkSMOutputPort.h"
#include "vtkSMProxy.h"
#include "vtkSMSourceProxy.h"

#include <QComboBox>
#include <QPointer>
#include <QStandardItemModel>

#include <algorithm>

//------------------------------------------------------------------------------
pqOptionalInputWidget::pqOptionalInputWidget(
  vtkSMProxy* proxy, vtkSMProperty* property, QWidget* parent)
  : pqInputSelectorWidget(proxy, property, parent)
  , Choices(this->findChild<QComboBox*>())
{
  // The list is refilled whenever the pipeline changes.
  QObject::connect(this->Choices->model(), &QAbstractItemModel::rowsInserted, this,
    [this](const QModelIndex&, int first, int last) { this->DisableDownstream(first, last); });
  this->DisableDownstream(0, this->Choices->count() - 1);
}

//------------------------------------------------------------------------------
void pqOptionalInputWidget::DisableDownstream(int firstRow, int lastRow)
{
  const auto* model = pqApplicationCore::instance()->getServerManagerModel();
  const auto* filter = model->findItem<pqPipelineSource*>(this->proxy());
  if (!filter)
  {
    return;
  }
  const std::vector<const pqPipelineSource*> downstream = ViewSources::WithDownstream(filter);
  for (int row = firstRow; row <= lastRow; ++row)
  {
    auto* port = vtkSMOutputPort::SafeDownCast(
      static_cast<vtkSMProxy*>(this->Choices->itemData(row).value<void*>()));
    if (port &&
      std::any_of(downstream.begin(), downstream.end(),
        [&](const pqPipelineSource* one) { return one->getProxy() == port->GetSourceProxy(); }))
    {
      qobject_cast<QStandardItemModel*>(this->Choices->model())->item(row)->setEnabled(false);
    }
  }
}

//------------------------------------------------------------------------------
void pqOptionalInputWidget::apply()
{
  const QPointer<pqPipelineSource> active = pqActiveObjects::instance().activeSource();
  pqInputSelectorWidget::apply();
  // A filter with a second input moves in the pipeline browser, which then selects its neighbour.
  AfterRun(this,
    [this, active]
    {
      if (active && active->getProxy() == this->proxy())
      {
        pqActiveObjects::instance().setActiveSource(active);
      }
    });
}
