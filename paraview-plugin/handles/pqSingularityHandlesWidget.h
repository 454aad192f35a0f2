/**
 * @class   pqSingularityHandlesWidget
 * @brief   places singularities with handles in the 3D view and a table in the panel
 *
 * For a property group with panel_widget="SingularityHandles" whose property of the function
 * `Singularities` holds rows of four numbers: x, y, quarter index, radius. What a person does is written to
 * the property at once, without *Apply*: while a handle is dragged, each move of the mouse is written and
 * the active view rendered, so that the pipeline behind the proxy is seen to follow. Moves that arrive
 * while the pipeline works are one move afterwards. A drag is one step of undo and of the trace.
 *
 * A filter that finds or moves rows itself has an information property of the function `Rows`, with the rows
 * of its last update. They are shown where the property of rows is empty, and become its value where a command
 * of the filter has changed them, so that undo, trace and states have them.
 *
 * A proxy whose rows are in another plane than z = 0 tells it by an information property of the function `Plane`: nine numbers,
 * the origin and the axes of its coordinates.
 *
 * A filter that can do with less while a handle is dragged has a property of the function `Dragging`, which is 1 then.
 *
 * The hint <WithoutRadius/> of the group hides the column of radii where they mean nothing.
 *
 * The handles are seen while the panel shows the proxy. Changes of the property by Python, undo or a state
 * are shown by handles and table.
 */

#ifndef pqSingularityHandlesWidget_h
#define pqSingularityHandlesWidget_h

#include "SingularityHandles.h"
#include "SingularityRows.h"

#include "pqPropertyWidget.h"
#include "vtkNew.h"
#include "vtkWeakPointer.h"

#include <QTimer>

#include <vector>

class QCheckBox;
class QLabel;
class QPushButton;
class SingularityTable;
class vtkCallbackCommand;
class vtkEventQtSlotConnect;
class vtkObject;
class vtkRenderWindowInteractor;
class vtkSMPropertyGroup;

class pqSingularityHandlesWidget : public pqPropertyWidget
{
  Q_OBJECT

public:
  pqSingularityHandlesWidget(
    vtkSMProxy* proxy, vtkSMPropertyGroup* group, QWidget* parent = nullptr);
  ~pqSingularityHandlesWidget() override;

  void select() override;
  void selectPort(int port) override;
  void deselect() override;

public Q_SLOTS:
  void setView(pqView* view) override;

protected:
  void showEvent(QShowEvent* event) override;
  void hideEvent(QHideEvent* event) override;
  void changeEvent(QEvent* event) override;

private Q_SLOTS:
  void ReadProperty();
  void ReadOutputLater();

private:
  Q_DISABLE_COPY(pqSingularityHandlesWidget)

  void MakePanel(bool hasRadius);

  // The rows.
  std::vector<SingularityRow> PropertyRows() const;
  void ReadPlane();
  void ReadOutput();
  void TakeRows(const std::vector<SingularityRow>& rows);
  void WriteProperty(const std::vector<SingularityRow>& rows);
  void Commit(const std::vector<SingularityRow>& before, const std::vector<SingularityRow>& after,
    const QString& what);
  void ShowRows();
  void Choose(int row);
  void Add(const std::vector<int>& quarterIndices);
  void RemoveChosen();
  void SetNumber(int row, int column, double number);

  // The view.
  void UpdateHandles();
  void Detach();
  static void OnMouse(vtkObject* caller, unsigned long event, void* self, void* data);
  void Press(int x, int y);
  void Follow();
  void Release();
  void EndDrag();
  void SmoothEdges(bool isWanted);
  void TellDragging(bool isDragging);
  void Hover(int x, int y);

  vtkSMProperty* Singularities = nullptr;
  vtkSMProperty* OutputRows = nullptr; ///< Maybe none.
  vtkSMProperty* Plane = nullptr;      ///< Maybe none.
  vtkSMProperty* Dragging = nullptr;   ///< Maybe none.
  std::vector<SingularityRow> Rows;
  int Chosen = -1;
  bool IsWriting = false;
  int Changes = 0; ///< How often the property has changed.

  SingularityHandles Handles;
  vtkNew<vtkCallbackCommand> Mouse;
  vtkNew<vtkEventQtSlotConnect> Connections;
  vtkWeakPointer<vtkRenderWindowInteractor> Interactor;
  bool IsHovering = false;

  // A drag: the rows before it, where the handle is taken, and where the mouse is now, in pixels.
  bool IsDragging = false;
  std::vector<SingularityRow> RowsBeforeDrag;
  std::array<double, 2> Grip = { 0, 0 };
  std::array<double, 2> Pixel = { 0, 0 };
  bool IsBehind = false;
  bool IsFollowing = false;
  QTimer FollowTimer;

  SingularityTable* Table = nullptr;
  QPushButton* RemoveButton = nullptr;
  QCheckBox* LiveBox = nullptr;
  QLabel* SumLabel = nullptr;
};

#endif
