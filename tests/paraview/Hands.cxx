// What a person does in ParaView's client, for test_handles.py, which loads this library into the client by
// ctypes: mouse events of Qt in the active 3D view, clicks on buttons, cells of the table, and pictures.

#include "pqActiveObjects.h"
#include "pqApplicationCore.h"
#include "pqCoreUtilities.h"
#include "pqUndoStack.h"
#include "pqView.h"

#include <QAbstractButton>
#include <QApplication>
#include <QElapsedTimer>
#include <QEventLoop>
#include <QMouseEvent>
#include <QTableWidget>
#include <QTimer>

namespace
{
/** The widget of the active view that gets mouse events: the innermost one, which draws. */
QWidget* Canvas()
{
  QWidget* canvas = pqActiveObjects::instance().activeView()->widget();
  while (QWidget* inner = canvas->childAt(canvas->rect().center()))
  {
    canvas = inner;
  }
  return canvas;
}

/** A mouse event as the window system makes them, in pixels from the lower left corner as in VTK. */
void Mouse(QEvent::Type type, int x, int y, Qt::MouseButton button, Qt::MouseButtons buttons)
{
  QWidget* canvas = Canvas();
  const QPointF place(x, canvas->height() - 1 - y);
  QCoreApplication::postEvent(canvas,
    new QMouseEvent(
      type, place, canvas->mapToGlobal(place.toPoint()), button, buttons, Qt::NoModifier));
}

/** What is visible of this name in the panel; a panel is kept for every proxy. */
template <class Widget>
Widget* Visible(const char* name)
{
  for (Widget* widget : pqCoreUtilities::mainWidget()->findChildren<Widget*>(name))
  {
    if (widget->isVisible())
    {
      return widget;
    }
  }
  return nullptr;
}
}

extern "C"
{
  /** Lets the client handle what waits, for at least so long. */
  void hands_wait(int milliseconds)
  {
    QEventLoop loop;
    QTimer::singleShot(milliseconds, &loop, &QEventLoop::quit);
    loop.exec();
  }

  void hands_press(int x, int y)
  {
    Mouse(QEvent::MouseButtonPress, x, y, Qt::LeftButton, Qt::LeftButton);
  }

  void hands_move(int x, int y, bool isPressed)
  {
    Mouse(QEvent::MouseMove, x, y, Qt::NoButton, isPressed ? Qt::LeftButton : Qt::NoButton);
  }

  void hands_release(int x, int y)
  {
    Mouse(QEvent::MouseButtonRelease, x, y, Qt::LeftButton, Qt::NoButton);
  }

  /** The seconds from a move of the mouse until the client has handled all that follows from it. */
  double hands_time_of_move(int x, int y)
  {
    QElapsedTimer timer;
    timer.start();
    hands_move(x, y, true);
    QCoreApplication::sendPostedEvents();
    // The widget follows when nothing else waits, and what it has drawn comes to the screen after that.
    for (int i = 0; i < 3; ++i)
    {
      QCoreApplication::processEvents(QEventLoop::AllEvents);
    }
    return 1e-9 * static_cast<double>(timer.nsecsElapsed());
  }

  /** Whether there was a button of this text that can be clicked. */
  bool hands_click(const char* text)
  {
    for (QAbstractButton* button : pqCoreUtilities::mainWidget()->findChildren<QAbstractButton*>())
    {
      // Desktops add keys to press, marked by &.
      if (button->text().remove("&") == text && button->isVisible())
      {
        const bool isEnabled = button->isEnabled();
        button->click();
        return isEnabled;
      }
    }
    return false;
  }

  int hands_rows()
  {
    auto* table = Visible<QTableWidget>("SingularityTable");
    return table ? table->rowCount() : -1;
  }

  int hands_chosen()
  {
    return Visible<QTableWidget>("SingularityTable")->currentRow();
  }

  void hands_choose(int row)
  {
    Visible<QTableWidget>("SingularityTable")->selectRow(row);
  }

  double hands_number(int row, int column)
  {
    return Visible<QTableWidget>("SingularityTable")
      ->item(row, column)
      ->data(Qt::EditRole)
      .toDouble();
  }

  void hands_type(int row, int column, double number)
  {
    Visible<QTableWidget>("SingularityTable")->item(row, column)->setData(Qt::EditRole, number);
  }

  /** A picture of the whole window, for people. */
  bool hands_picture(const char* file)
  {
    return pqCoreUtilities::mainWidget()->grab().save(file);
  }

  void hands_undo()
  {
    pqApplicationCore::instance()->getUndoStack()->undo();
  }

  void hands_redo()
  {
    pqApplicationCore::instance()->getUndoStack()->redo();
  }

  /** What Edit > Undo would say that it undoes; empty when there is nothing. */
  const char* hands_undo_label()
  {
    static QByteArray label;
    label = pqApplicationCore::instance()->getUndoStack()->undoLabel().toUtf8();
    return label.constData();
  }

  void hands_quit()
  {
    QTimer::singleShot(0, qApp, &QApplication::quit);
  }
}
