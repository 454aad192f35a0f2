#include "GuiDialogs.h"

#include "pqCoreUtilities.h"

#include <QAbstractButton>
#include <QAction>
#include <QApplication>
#include <QKeyEvent>
#include <QLineEdit>
#include <QMainWindow>
#include <QMouseEvent>
#include <QTimer>

//------------------------------------------------------------------------------
void GuiDialogs::Click(QWidget* widget, const QPoint& place)
{
  for (const QEvent::Type type : { QEvent::MouseButtonPress, QEvent::MouseButtonRelease })
  {
    const bool isPress = type == QEvent::MouseButtonPress;
    QCoreApplication::postEvent(widget,
      new QMouseEvent(type, place, widget->mapToGlobal(place), Qt::LeftButton,
        isPress ? Qt::LeftButton : Qt::NoButton, Qt::NoModifier));
  }
}

//------------------------------------------------------------------------------
void GuiDialogs::Key(QWidget* widget, int key, const QString& text)
{
  for (const QEvent::Type type : { QEvent::KeyPress, QEvent::KeyRelease })
  {
    QCoreApplication::postEvent(widget, new QKeyEvent(type, key, Qt::NoModifier, text));
  }
}

//------------------------------------------------------------------------------
GuiDialogs::Response GuiDialogs::TypeFile(const QString& file)
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
      // After the list of name completions has opened.
      QTimer::singleShot(300, line, [line] { Key(line, Qt::Key_Return); });
      return true;
    } };
}

//------------------------------------------------------------------------------
GuiDialogs::Response GuiDialogs::ClickOk(const char* dialogClass)
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

//------------------------------------------------------------------------------
bool GuiDialogs::Run(const char* action, const std::vector<Response>& responses)
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
      if (dialog && next < responses.size() && dialog->inherits(responses[next].dialogClass) &&
        dialog->isVisible() && responses[next].respond(dialog))
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
  return next == responses.size();
}
