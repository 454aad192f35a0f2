// What a person does in ParaView's client, for gui_driver.py, which loads this library into the client by ctypes:
// mouse events of Qt in the active 3D view, entries of menus, clicks on buttons, cells of the table, messages, and pictures.

#include "pqActiveObjects.h"
#include "pqApplicationCore.h"
#include "pqCoreUtilities.h"
#include "pqLoadStateReaction.h"
#include "pqObjectBuilder.h"
#include "pqOutputPort.h"
#include "pqOutputWidget.h"
#include "pqPipelineBrowserWidget.h"
#include "pqPipelineSource.h"
#include "pqServerManagerModel.h"
#include "pqUndoStack.h"
#include "pqView.h"

#include <QAbstractButton>
#include <QAction>
#include <QApplication>
#include <QComboBox>
#include <QDockWidget>
#include <QElapsedTimer>
#include <QEventLoop>
#include <QImage>
#include <QKeyEvent>
#include <QLineEdit>
#include <QListWidget>
#include <QMainWindow>
#include <QMouseEvent>
#include <QTableWidget>
#include <QTimer>
#include <QTreeView>

#include <functional>
#include <vector>

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

/** Warnings and errors that the window of messages has got. */
QString Messages;

int Updates = 0;

/** A key as the window system sends it, pressed and let go. */
void Key(QWidget* widget, int key, const QString& text = {})
{
  for (const QEvent::Type type : { QEvent::KeyPress, QEvent::KeyRelease })
  {
    QCoreApplication::postEvent(widget, new QKeyEvent(type, key, Qt::NoModifier, text));
  }
}

void Click(QWidget* widget, const QPoint& place)
{
  for (const QEvent::Type type : { QEvent::MouseButtonPress, QEvent::MouseButtonRelease })
  {
    const bool isPress = type == QEvent::MouseButtonPress;
    QCoreApplication::postEvent(widget,
      new QMouseEvent(type, place, widget->mapToGlobal(place), Qt::LeftButton,
        isPress ? Qt::LeftButton : Qt::NoButton, Qt::NoModifier));
  }
}

/** What to do in a modal dialog of this class; not done (false) as long as what it needs is not there. */
struct Answer
{
  const char* dialog;
  std::function<bool(QWidget*)> give;
};

/** Types a name where the dialog for files wants it, and Return. */
Answer TypeFile(const QString& file)
{
  return { "pqFileDialog",
    [file](QWidget* dialog)
    {
      auto* line = dialog->findChild<QLineEdit*>("EntityName");
      if (!line || !line->isVisible())
      {
        return false;
      }
      line->selectAll();
      for (const QChar& character : file)
      {
        Key(line, 0, QString(character));
      }
      // After what the completion of names shows meanwhile.
      QTimer::singleShot(300, line, [line] { Key(line, Qt::Key_Return); });
      return true;
    } };
}

Answer ClickOk(const char* dialogClass)
{
  return { dialogClass,
    [](QWidget* dialog)
    {
      for (QAbstractButton* button : dialog->findChildren<QAbstractButton*>())
      {
        if (button->isVisible() && button->isEnabled() && button->text().remove("&") == "OK")
        {
          Click(button, button->rect().center());
          return true;
        }
      }
      return false;
    } };
}

/**
 * Chooses an entry of a menu, and answers the dialogs that it opens one after the other. False, with all dialogs closed, where one does
 * not come or not have what is looked for within seconds.
 */
bool Converse(const char* action, std::vector<Answer> answers)
{
  auto* chosen = pqCoreUtilities::mainWidget()->findChild<QAction*>(action);
  if (!chosen || !chosen->isEnabled())
  {
    return false;
  }
  std::size_t next = 0;
  int patience = 100;
  QTimer timer;
  QObject::connect(&timer, &QTimer::timeout,
    [&]
    {
      QWidget* dialog = QApplication::activeModalWidget();
      if (dialog && next < answers.size() && dialog->inherits(answers[next].dialog) &&
        dialog->isVisible() && answers[next].give(dialog))
      {
        ++next;
        patience = 100;
      }
      else if (--patience < 0 && dialog)
      {
        dialog->close();
      }
    });
  timer.start(100);
  chosen->trigger(); // returns after the last dialog
  return next == answers.size();
}
}

extern "C"
{
  /** Lets the client handle what waits, for at least so long. */
  void gui_wait(int milliseconds)
  {
    QEventLoop loop;
    QTimer::singleShot(milliseconds, &loop, &QEventLoop::quit);
    loop.exec();
  }

  void gui_press(int x, int y)
  {
    Mouse(QEvent::MouseButtonPress, x, y, Qt::LeftButton, Qt::LeftButton);
  }

  void gui_move(int x, int y, bool isPressed)
  {
    Mouse(QEvent::MouseMove, x, y, Qt::NoButton, isPressed ? Qt::LeftButton : Qt::NoButton);
  }

  void gui_release(int x, int y)
  {
    Mouse(QEvent::MouseButtonRelease, x, y, Qt::LeftButton, Qt::NoButton);
  }

  /** The seconds from a move of the mouse until the client has handled all that follows from it. */
  double gui_time_of_move(int x, int y)
  {
    QElapsedTimer timer;
    timer.start();
    gui_move(x, y, true);
    QCoreApplication::sendPostedEvents();
    // The widget follows when nothing else waits, and what it has drawn comes to the screen after that.
    for (int i = 0; i < 3; ++i)
    {
      QCoreApplication::processEvents(QEventLoop::AllEvents);
    }
    return 1e-9 * static_cast<double>(timer.nsecsElapsed());
  }

  /** Whether there was a button of this text that can be clicked. */
  bool gui_click(const char* text)
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

  /** File > Open: the name typed, and the reader chosen in the list that comes then. */
  bool gui_open(const char* file, const char* reader)
  {
    const Answer choose = { "pqSelectReaderDialog",
      [reader](QWidget* dialog)
      {
        auto* readers = dialog->findChild<QListWidget*>();
        const QList<QListWidgetItem*> found =
          readers ? readers->findItems(reader, Qt::MatchExactly) : QList<QListWidgetItem*>();
        if (found.empty())
        {
          return false;
        }
        readers->scrollToItem(found.front());
        Click(readers->viewport(), readers->visualItemRect(found.front()).center());
        return true;
      } };
    return Converse("actionFileOpen",
      { TypeFile(QString::fromUtf8(file)), choose, ClickOk("pqSelectReaderDialog") });
  }

  /** File > Save Data: the name typed, and this choice of the property in the options. */
  bool gui_save(const char* file, const char* property, const char* choice)
  {
    const Answer choose = { "pqProxyWidgetDialog",
      [property, choice](QWidget* dialog)
      {
        for (QWidget* widget : dialog->findChildren<QWidget*>(property))
        {
          auto* choices = widget->findChild<QComboBox*>();
          if (choices && choices->isVisible() && choices->findText(choice) >= 0)
          {
            choices->setCurrentIndex(choices->findText(choice));
            return true;
          }
        }
        return false;
      } };
    return Converse("actionFileSaveData",
      { TypeFile(QString::fromUtf8(file)), choose, ClickOk("pqProxyWidgetDialog") });
  }

  /** File > Load State, without the window that asks where its data are. */
  void gui_load_state(const char* file)
  {
    pqLoadStateReaction::loadState(file, true);
  }

  /** Whether there was an entry of this text in a menu that can be chosen. */
  bool gui_trigger(const char* text)
  {
    for (QAction* action : pqCoreUtilities::mainWidget()->findChildren<QAction*>())
    {
      if (action->text().remove("&") == text && action->isEnabled())
      {
        action->trigger();
        return true;
      }
    }
    return false;
  }

  /** The filter of the active source and another one that the menu makes after a dialog that asks for the second input. */
  void gui_filter(const char* name, const char* input, const char* source)
  {
    pqApplicationCore* core = pqApplicationCore::instance();
    pqActiveObjects& active = pqActiveObjects::instance();
    auto* other = core->getServerManagerModel()->findItem<pqPipelineSource*>(source);
    active.setActiveSource(core->getObjectBuilder()->createFilter("filters", name,
      { { "Input", { active.activeSource()->getOutputPort(0) } },
        { input, { other->getOutputPort(0) } } },
      active.activeServer()));
  }

  /** Whether there was a list of choices with this one, for the property of this name in the panel. */
  bool gui_take(const char* property, const char* choice)
  {
    for (QWidget* widget : pqCoreUtilities::mainWidget()->findChildren<QWidget*>(property))
    {
      auto* choices = widget->findChild<QComboBox*>();
      const int place = choices && choices->isVisible() ? choices->findText(choice) : -1;
      if (place >= 0)
      {
        // As the mouse can: not what is grey.
        const QModelIndex chosen = choices->model()->index(place, 0);
        const bool isEnabled = choices->model()->flags(chosen).testFlag(Qt::ItemIsEnabled);
        if (isEnabled)
        {
          choices->setCurrentIndex(place);
        }
        return isEnabled;
      }
    }
    return false;
  }

  /** From now on warnings and errors are kept for gui_messages. */
  void gui_listen()
  {
    for (pqOutputWidget* shown : pqCoreUtilities::mainWidget()->findChildren<pqOutputWidget*>())
    {
      QObject::connect(shown, &pqOutputWidget::messageDisplayed,
        [](const QString& message, int type)
        {
          if (type != QtDebugMsg && type != QtInfoMsg)
          {
            Messages += message + "\n";
          }
        });
    }
  }

  const char* gui_messages()
  {
    static QByteArray said;
    said = Messages.toUtf8();
    Messages.clear();
    return said.constData();
  }

  /** Clicks on an item of this name in the Pipeline Browser, the last one, as a person who selects an output. */
  bool gui_select(const char* name)
  {
    for (auto* tree : pqCoreUtilities::mainWidget()->findChildren<pqPipelineBrowserWidget*>())
    {
      const QModelIndexList found = tree->getModel()->match(tree->getModel()->index(0, 0),
        Qt::DisplayRole, QString(name), -1, Qt::MatchFlags(Qt::MatchExactly | Qt::MatchRecursive));
      if (!found.empty())
      {
        tree->scrollTo(found.back());
        QRect place;
        tree->getVisibleRect(found.back(), place);
        Click(tree->viewport(), place.center());
        return true;
      }
    }
    return false;
  }

  /** From now on it is counted how often the client is told that this source has run, which keeps panels and menus busy. */
  void gui_count_updates(const char* source)
  {
    pqServerManagerModel* model = pqApplicationCore::instance()->getServerManagerModel();
    QObject::connect(model->findItem<pqPipelineSource*>(source),
      QOverload<pqPipelineSource*>::of(&pqPipelineSource::dataUpdated), [] { ++Updates; });
  }

  int gui_updates()
  {
    return Updates;
  }

  /** A window of this size, with so much of its width for the panel. */
  void gui_window(int width, int height, int panelWidth)
  {
    auto* window = qobject_cast<QMainWindow*>(pqCoreUtilities::mainWidget());
    window->resize(width, height);
    window->resizeDocks(
      { window->findChild<QDockWidget*>("propertiesDock") }, { panelWidth }, Qt::Horizontal);
  }

  int gui_rows()
  {
    auto* table = Visible<QTableWidget>("SingularityTable");
    return table ? table->rowCount() : -1;
  }

  int gui_chosen()
  {
    return Visible<QTableWidget>("SingularityTable")->currentRow();
  }

  void gui_choose(int row)
  {
    Visible<QTableWidget>("SingularityTable")->selectRow(row);
  }

  double gui_number(int row, int column)
  {
    return Visible<QTableWidget>("SingularityTable")
      ->item(row, column)
      ->data(Qt::EditRole)
      .toDouble();
  }

  void gui_type(int row, int column, double number)
  {
    Visible<QTableWidget>("SingularityTable")->item(row, column)->setData(Qt::EditRole, number);
  }

  /** A picture for people: of the whole window, or of the panel and the view alone. */
  bool gui_picture(const char* file, bool isIntegral)
  {
    auto* window = qobject_cast<QMainWindow*>(pqCoreUtilities::mainWidget());
    QRect part = window->rect();
    if (!isIntegral)
    {
      const QRect view = window->centralWidget()->geometry();
      part.setTop(view.top());
      part.setBottom(view.bottom());
    }
    // 0: the smallest file
    return window->grab(part).toImage().convertToFormat(QImage::Format_RGB888).save(file, "PNG", 0);
  }

  void gui_undo()
  {
    pqApplicationCore::instance()->getUndoStack()->undo();
  }

  void gui_redo()
  {
    pqApplicationCore::instance()->getUndoStack()->redo();
  }

  /** What Edit > Undo would say that it undoes; empty when there is nothing. */
  const char* gui_undo_label()
  {
    static QByteArray label;
    label = pqApplicationCore::instance()->getUndoStack()->undoLabel().toUtf8();
    return label.constData();
  }

  void gui_quit()
  {
    QTimer::singleShot(0, qApp, &QApplication::quit);
  }
}
