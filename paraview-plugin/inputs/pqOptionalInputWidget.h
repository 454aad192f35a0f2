/**
 * @class   pqOptionalInputWidget
 * @brief   a list in the panel from which an optional input of a filter is chosen
 *
 * ParaView's list of that kind, with what follows from the filter itself greyed: that would be a pipeline in a circle, which
 * ends ParaView. Without it an optional input is in the window of Change Input only, and several selected items are no
 * input of a filter that takes one at its first port.
 *
 * In the XML of a proxy: `panel_widget="optional_input"` of an InputProperty.
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
  void GreyWhatFollows(int firstRow, int lastRow);

  class QComboBox* Choices;
};

#endif
