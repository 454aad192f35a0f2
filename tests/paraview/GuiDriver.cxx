// User actions in ParaView's client, for gui_driver.py, which loads this library into the client
// with ctypes: mouse events in the active 3D view, menu entries, clicks on buttons, cells of the
// table, messages, and pictures.

#include "GuiDialogs.h"

#include "pqActiveObjects.h"
#include "pqApplicationCore.h"
#include "pqCoreUtilities.h"
#include "pqLoadStateReaction.h"
#include "pqObjectBuilder.h"
#include "pqOutputPort.h"
#include "pqOutputWidget.h"
#include "pqPipelineBrowserWidget.h"
#include "pqPipelineSource.h"
#include "pqProgressWidget.h"
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
#include <QHelpEngine>
#include <QImage>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QMainWindow>
#include <QMouseEvent>
#include <QPushButton>
#include <QTableWidget>
#include <QTimer>
#include <QToolButton>
#include <QTreeView>

#include <chrono>
#include <thread>

namespace
{
/** Returns the innermost widget of the active view, which receives mouse events. */
QWidget* Canvas()
{
  QWidget* canvas = pqActiveObjects::instance().activeView()->widget();
  while (QWidget* inner = canvas->childAt(canvas->rect().center()))
  {
    canvas = inner;
  }
  return canvas;
}

/**
 * Posts a mouse event as the window system does, in pixels from the lower left corner as in VTK.
 */
void Mouse(QEvent::Type type, int x, int y, Qt::MouseButton button, Qt::MouseButtons buttons)
{
  QWidget* canvas = Canvas();
  const QPointF place(x, canvas->height() - 1 - y);
  QCoreApplication::postEvent(canvas,
    new QMouseEvent(
      type, place, canvas->mapToGlobal(place.toPoint()), button, buttons, Qt::NoModifier));
}

/** Returns the visible widget of a name; the panels of other proxies are hidden, not deleted. */
template <class Widget>
Widget* FindVisible(const char* name)
{
  // Without a name: any widget of the class.
  const QString chosen(name);
  for (Widget* widget :
    pqCoreUtilities::mainWidget()->findChildren<Widget*>(chosen.isEmpty() ? QString() : chosen))
  {
    if (widget->isVisible())
    {
      return widget;
    }
  }
  return nullptr;
}

/** Warnings and errors shown in the message window since the last call of gui_messages. */
QString Messages;

/** Number of update signals counted by gui_count_updates. */
int Updates = 0;
}

extern "C"
{
  /** Lets the client process events for a time. */
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

  /** Returns the seconds from a mouse move until the client has processed all its consequences. */
  double gui_time_of_move(int x, int y)
  {
    QElapsedTimer timer;
    timer.start();
    gui_move(x, y, true);
    QCoreApplication::sendPostedEvents();
    // The widget handles the move after all other events, and the drawn frame is shown after that.
    for (int i = 0; i < 3; ++i)
    {
      QCoreApplication::processEvents(QEventLoop::AllEvents);
    }
    return 1e-9 * static_cast<double>(timer.nsecsElapsed());
  }

  /** Returns the page of the client's help with a name; empty if there is none. */
  const char* gui_help(const char* name)
  {
    static QByteArray page;
    page.clear();
    QHelpEngine* engine = pqApplicationCore::instance()->helpEngine();
    for (const QString& book : engine->registeredDocumentations())
    {
      for (const QUrl& address : engine->files(book, QString()))
      {
        if (address.path().endsWith(QString("/") + name))
        {
          page = engine->fileData(address);
        }
      }
    }
    return page.constData();
  }

  /** Clicks a button by its text; reports whether there is such a button and it is enabled. */
  bool gui_click(const char* text)
  {
    for (QAbstractButton* button : pqCoreUtilities::mainWidget()->findChildren<QAbstractButton*>())
    {
      // Desktops add keyboard accelerators, marked by &.
      if (button->text().remove("&") == text && button->isVisible())
      {
        const bool isEnabled = button->isEnabled();
        button->click();
        return isEnabled;
      }
    }
    return false;
  }

  /**
   * Opens a file with File > Open: types its name and, unless `reader` is null, selects the reader in the list that
   * follows.
   */
  bool gui_open(const char* file, const char* reader)
  {
    if (!reader)
    {
      return GuiDialogs::Run("actionFileOpen", { GuiDialogs::TypeFile(QString::fromUtf8(file)) });
    }
    const GuiDialogs::Response choose = { "pqSelectReaderDialog",
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
        GuiDialogs::Click(readers->viewport(), readers->visualItemRect(found.front()).center());
        return true;
      } };
    return GuiDialogs::Run("actionFileOpen",
      { GuiDialogs::TypeFile(QString::fromUtf8(file)), choose,
        GuiDialogs::ClickOk("pqSelectReaderDialog") });
  }

  /**
   * Saves data with File > Save Data: types the file name and, unless `property` is null, selects a
   * choice of a property in the options.
   */
  bool gui_save(const char* file, const char* property, const char* choice)
  {
    if (!property)
    {
      return GuiDialogs::Run(
        "actionFileSaveData", { GuiDialogs::TypeFile(QString::fromUtf8(file)) });
    }
    const GuiDialogs::Response choose = { "pqProxyWidgetDialog",
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
    return GuiDialogs::Run("actionFileSaveData",
      { GuiDialogs::TypeFile(QString::fromUtf8(file)), choose,
        GuiDialogs::ClickOk("pqProxyWidgetDialog") });
  }

  /** Loads a state as File > Load State does, without the dialog that asks where the data are. */
  void gui_load_state(const char* file)
  {
    pqLoadStateReaction::loadState(file, true);
  }

  /**
   * Triggers a menu entry by its text; reports whether there is such an entry and it is enabled.
   */
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

  /**
   * Creates a filter of the active source with a second input, as the menu does after its input
   * dialog.
   */
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

  /**
   * Selects a choice of a property in the panel; reports whether there is such a choice and it is
   * enabled.
   */
  bool gui_select_choice(const char* property, const char* choice)
  {
    for (QWidget* widget : pqCoreUtilities::mainWidget()->findChildren<QWidget*>(property))
    {
      auto* choices = widget->findChild<QComboBox*>();
      const int place = choices && choices->isVisible() ? choices->findText(choice) : -1;
      if (place >= 0)
      {
        // Disabled choices cannot be selected with the mouse.
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

  /** Starts to store warnings and errors for gui_messages. */
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

  /** Returns the warnings and errors since the last call. */
  const char* gui_messages()
  {
    static QByteArray text;
    text = Messages.toUtf8();
    Messages.clear();
    return text.constData();
  }

  /** Returns all texts of the window Output Messages, which may be closed. */
  const char* gui_log()
  {
    static QByteArray text;
    QString found;
    for (pqOutputWidget* window : pqCoreUtilities::mainWidget()->findChildren<pqOutputWidget*>())
    {
      for (QTreeView* tree : window->findChildren<QTreeView*>())
      {
        for (int row = 0; row < tree->model()->rowCount(); ++row)
        {
          for (int column = 0; column < tree->model()->columnCount(); ++column)
          {
            found += tree->model()->index(row, column).data().toString() + "\n";
          }
        }
      }
    }
    text = found.toUtf8();
    return text.constData();
  }

  /** Reports whether the window Output Messages is visible. */
  bool gui_log_is_open()
  {
    auto* window = FindVisible<pqOutputWidget>("");
    return window != nullptr;
  }

  /** Clicks the last item of a name in the Pipeline Browser, for example an output. */
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
        GuiDialogs::Click(tree->viewport(), place.center());
        return true;
      }
    }
    return false;
  }

  /** Starts to count the update signals of a source, each of which refreshes panels and menus. */
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

  /** Sets the size of the window and the width of the panel. */
  void gui_window(int width, int height, int panelWidth)
  {
    auto* window = qobject_cast<QMainWindow*>(pqCoreUtilities::mainWidget());
    window->resize(width, height);
    window->resizeDocks(
      { window->findChild<QDockWidget*>("propertiesDock") }, { panelWidth }, Qt::Horizontal);
  }

  /** Returns the number of rows of the table, or -1 if no table is visible. */
  int gui_rows()
  {
    auto* table = FindVisible<QTableWidget>("SingularityTable");
    return table ? table->rowCount() : -1;
  }

  int gui_chosen()
  {
    return FindVisible<QTableWidget>("SingularityTable")->currentRow();
  }

  void gui_choose(int row)
  {
    FindVisible<QTableWidget>("SingularityTable")->selectRow(row);
  }

  double gui_number(int row, int column)
  {
    return FindVisible<QTableWidget>("SingularityTable")
      ->item(row, column)
      ->data(Qt::EditRole)
      .toDouble();
  }

  void gui_type(int row, int column, double number)
  {
    FindVisible<QTableWidget>("SingularityTable")->item(row, column)->setData(Qt::EditRole, number);
  }

  /** Types a text into a cell of the table of sides; of column 0, chooses it if it is in the list. */
  bool gui_type_side(int row, int column, const char* text)
  {
    auto* table = FindVisible<QTableWidget>("SideTable");
    if (!table || row >= table->rowCount())
    {
      return false;
    }
    if (auto* names = qobject_cast<QComboBox*>(table->cellWidget(row, column)))
    {
      const bool isListed = names->findText(text) >= 0;
      names->setCurrentText(text);
      return isListed;
    }
    table->item(row, column)->setText(text);
    return true;
  }

  /** Returns the number of rows of the table of sides. */
  int gui_side_rows()
  {
    auto* table = FindVisible<QTableWidget>("SideTable");
    return table ? table->rowCount() : -1;
  }

  /** Types a text into the line of a property, as a user who then presses Tab. */
  bool gui_type_text(const char* property, const char* text)
  {
    auto* line = FindVisible<QLineEdit>(property);
    if (line)
    {
      line->setFocus();
      line->setText(text);
      line->clearFocus();
    }
    return line != nullptr;
  }

  /** Returns the height of the panel in which a button is, minus the place of the button's lower end. */
  int gui_room_below(const char* text)
  {
    for (QAbstractButton* button : pqCoreUtilities::mainWidget()->findChildren<QAbstractButton*>())
    {
      if (button->text().remove("&") == text && button->isVisible())
      {
        QWidget* dock = pqCoreUtilities::mainWidget()->findChild<QDockWidget*>("propertiesDock");
        return dock->height() - button->mapTo(dock, QPoint(0, button->height())).y();
      }
    }
    return -10000;
  }

  /** Checks or clears a check box by its text. */
  bool gui_set_box(const char* text, bool isChecked)
  {
    for (QAbstractButton* box : pqCoreUtilities::mainWidget()->findChildren<QAbstractButton*>())
    {
      if (box->text().remove("&") == text && box->isVisible() && box->isCheckable())
      {
        box->setChecked(isChecked);
        return true;
      }
    }
    return false;
  }

  /** Saves a picture of the window, or of the panel and the view alone. */
  bool gui_picture(const char* file, bool isWholeWindow)
  {
    auto* window = qobject_cast<QMainWindow*>(pqCoreUtilities::mainWidget());
    QRect part = window->rect();
    if (!isWholeWindow)
    {
      const QRect view = window->centralWidget()->geometry();
      part.setTop(view.top());
      part.setBottom(view.bottom());
    }
    // Quality 0 gives the smallest file.
    return window->grab(part).toImage().convertToFormat(QImage::Format_RGB888).save(file, "PNG", 0);
  }

  /** Returns the text of a visible label, empty if there is none. */
  const char* gui_label(const char* name)
  {
    static QByteArray text;
    auto* label = FindVisible<QLabel>(name);
    text = label ? label->text().toUtf8() : QByteArray();
    return text.constData();
  }

  /** Reports whether the client's abort button is enabled. */
  bool gui_abort_enabled()
  {
    return FindVisible<pqProgressWidget>("")->abortButton()->isEnabled();
  }

  /**
   * Posts input after a time, from another thread, since timers do not fire during a run: "button"
   * is a click on the abort button, "escape" the key, and "delete" a click on the button Delete.
   */
  void gui_during_run(const char* action, int milliseconds)
  {
    const QString chosen(action);
    QWidget* target = pqCoreUtilities::mainWidget();
    if (chosen == "button")
    {
      target = FindVisible<pqProgressWidget>("")->abortButton();
    }
    else if (chosen == "delete")
    {
      target = FindVisible<QPushButton>("Delete");
    }
    std::thread(
      [chosen, target, milliseconds]
      {
        std::this_thread::sleep_for(std::chrono::milliseconds(milliseconds));
        if (chosen == "escape")
        {
          GuiDialogs::Key(target, Qt::Key_Escape);
        }
        else
        {
          GuiDialogs::Click(target, target->rect().center());
        }
      })
      .detach();
  }

  void gui_undo()
  {
    pqApplicationCore::instance()->getUndoStack()->undo();
  }

  void gui_redo()
  {
    pqApplicationCore::instance()->getUndoStack()->redo();
  }

  /** Returns the label of Edit > Undo, empty if there is nothing to undo. */
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
