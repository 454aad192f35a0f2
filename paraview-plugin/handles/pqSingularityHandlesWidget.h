/**
 * @class   pqSingularityHandlesWidget
 * @brief   places singularities with handles in the 3D view and a table in the panel
 *
 * Use it for a property group with panel_widget="SingularityHandles" whose property with the
 * function `Singularities` holds rows of four numbers: x, y, quarter index, radius. Changes by the
 * user are written to the property at once, without *Apply*: while a handle is dragged, each mouse
 * move is written and the active view rendered, so the pipeline downstream of the proxy follows.
 * Moves that arrive while the pipeline updates are merged into one. A drag is one step of undo and
 * of the trace.
 *
 * A filter that computes or moves rows itself has an information property with the function `Rows`,
 * the rows of its last update. They are shown if the property of rows is empty, and become its
 * value after a command of the filter, a property with panel_widget="command_button", has changed
 * them, so that undo, trace and states include them. This is one undo step with the command's name.
 *
 * A proxy that fits its default rows to a domain has the hint <RowsFitDomain property="Domain"/> of
 * the group, with the name of the input. The rows of its last update are shown while the domain is
 * connected and the property has its default, and a note in the panel reports whether there is a
 * domain.
 *
 * A proxy whose rows are not in the plane z = 0 reports their plane in an information property with
 * the function `Plane`: nine numbers, the origin and the two axes of its coordinates.
 *
 * A filter whose rows are on a surface in space, x, y, quarter index and z, reports triangles near it in an information
 * property with the function `Triangles`, nine numbers each; without triangles rows are in the plane. Handles slide on
 * them.
 *
 * A filter that can compute a draft while a handle is dragged has a property with the function
 * `Dragging`, which is 1 during a drag.
 *
 * The hint <WithoutRadius/> of the group hides the column of radii.
 *
 * A filter that knows the sum that the quarter indices of its rows must have reports it in an information property with
 * the function `RequiredSum`, one number or none; the panel shows it, and *Add* adds a row that brings the sum nearer to
 * it. One that can explain its rows has one with the function `Reasons`, a text for each row; the panel shows that of the
 * selected row.
 *
 * Where the handles are admits no result if a filter in the view fails or keeps the result of
 * earlier positions. The view then shows its last picture in grey (StalePicture.h), as long as it
 * is not moved, and texts report the reason. Messages of a failure appear at the end of a drag.
 *
 * The handles are visible while the panel shows the proxy, in a view that shows it or a filter
 * downstream of it. Handles and table follow changes of the
 * property by Python, undo or a state.
 */

#ifndef pqSingularityHandlesWidget_h
#define pqSingularityHandlesWidget_h

#include "LiveFrames.h"
#include "SingularityHandles.h"
#include "SingularityRows.h"
#include "StalePicture.h"

#include "pqPropertyWidget.h"
#include "vtkNew.h"
#include "vtkWeakPointer.h"

#include <QString>
#include <QStringList>
#include <QTimer>

#include <optional>
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
  void ScheduleReadOutput();
  void NoteCommand();

private:
  Q_DISABLE_COPY(pqSingularityHandlesWidget)

  void MakePanel(bool hasRadius);
  void FollowPipeline();
  void FollowCommands();

  // Rows.
  std::vector<SingularityRow> PropertyRows() const;
  bool AreRowsComputed() const;
  void ReadPlane();
  void ReadExplanations();
  int Sum() const;
  std::optional<int> SumNeeded() const;
  bool AreSame(
    const std::vector<SingularityRow>& rows, const std::vector<SingularityRow>& others) const;
  void ReadOutput();
  void AdoptRows(const std::vector<SingularityRow>& rows);
  void WriteProperty(const std::vector<SingularityRow>& rows);
  void Commit(const std::vector<SingularityRow>& before, const std::vector<SingularityRow>& after,
    const QString& what);
  void ShowRows();
  void ShowNote();
  void Choose(int row);
  void Add(const std::vector<int>& quarterIndices);
  void RemoveChosen();
  void SetNumber(int row, int column, double number);

  // View.
  void UpdateHandles();
  void Detach();
  static void OnMouse(vtkObject* caller, unsigned long event, void* self, void* data);
  void Press(int x, int y);
  void FollowMouse();
  void Release();
  void EndDrag();
  void SmoothEdges(bool isWanted);
  void SetDragging(bool isDragging);
  void Hover(int x, int y);
  void UpdatePipeline();
  void CheckPicture();

  vtkSMProperty* Singularities = nullptr;
  vtkSMProperty* OutputRows = nullptr; ///< Optional.
  vtkSMProperty* Plane = nullptr;      ///< Optional.
  vtkSMProperty* Triangles = nullptr;  ///< Optional.
  vtkSMProperty* Dragging = nullptr;   ///< Optional.
  vtkSMProperty* RequiredSum = nullptr; ///< Optional.
  vtkSMProperty* Reasons = nullptr;     ///< Optional.
  vtkSMProperty* Domain = nullptr;     ///< To which default rows are fitted; optional.
  std::vector<SingularityRow> Rows;
  int Chosen = -1;
  bool IsWriting = false;
  int Changes = 0; ///< Number of changes of the property.
  QString Command; ///< Name of the command that was run since the output was read last.

  SingularityHandles Handles;
  StalePicture Picture;
  LiveFrames Frames;
  bool IsUpdating = false;
  vtkNew<vtkCallbackCommand> Mouse;
  vtkNew<vtkEventQtSlotConnect> Connections;
  vtkWeakPointer<vtkRenderWindowInteractor> Interactor;
  bool IsHovering = false;

  // State of a drag: rows and value of the property before it, offset of the mouse from the
  // handle's centre, and mouse position, in pixels.
  bool IsDragging = false;
  std::vector<SingularityRow> RowsBeforeDrag;
  std::vector<SingularityRow> PropertyBeforeDrag;
  std::array<double, 2> Grip = { 0, 0 };
  std::array<double, 2> Pixel = { 0, 0 };
  bool HasPendingMove = false;
  bool IsHandlingMove = false;
  QTimer FollowTimer;

  SingularityTable* Table = nullptr;
  QPushButton* RemoveButton = nullptr;
  QCheckBox* LiveBox = nullptr;
  QLabel* SumLabel = nullptr;
  QStringList RowReasons; ///< A sentence for each row of the last update.
  QLabel* NoteLabel = nullptr;
};

#endif
