/**
 * @class   pqOptionalInputWidget
 * @brief   list in the panel for the choice of an optional input of a filter
 *
 * ParaView's list of inputs, with sources downstream of the filter disabled: they would make the
 * pipeline cyclic, which crashes ParaView. Without this widget, optional inputs can only be set in
 * the dialog *Change Input*, since a selection of several items is not accepted by a filter with
 * one input at port 0.
 *
 * In the XML of a proxy, set `panel_widget="optional_input"` on an InputProperty.
 */

#ifndef pqOptionalInputWidget_h
#define pqOptionalInputWidget_h

#include "pqInputSelectorWidget.h"

class pqOptionalInputWidget : public pqInputSelectorWidget
{
  Q_OBJECT

public:
  pqOptionalInputWidget(vtkSMProxy* proxy, vtkSMProperty* property, QWidget* parent = nullptr);

  void apply() override;

private:
  void DisableDownstream(int firstRow, int lastRow);

  class QComboBox* Choices;
};

#endif
