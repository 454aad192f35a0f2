/**
 * Menu entries that open modal dialogs, and the responses to these.
 */

#ifndef GuiDialogs_h
#define GuiDialogs_h

#include <QString>

#include <functional>
#include <vector>

class QPoint;
class QWidget;

namespace GuiDialogs
{
/**
 * Response to a modal dialog of a class; `respond` returns false until the dialog is ready for it.
 */
struct Response
{
  const char* dialogClass;
  std::function<bool(QWidget*)> respond;
};

/** Types a file name into a file dialog, and Return. */
Response TypeFile(const QString& file);

/** Clicks the button OK of a dialog. */
Response ClickOk(const char* dialogClass);

/**
 * Triggers a menu entry and responds to the dialogs that it opens, one after the other. Returns
 * false, with all dialogs closed, if a dialog does not open or is not ready within seconds.
 */
bool Run(const char* action, const std::vector<Response>& responses);

/** Posts the press and release of a key. */
void Key(QWidget* widget, int key, const QString& text = {});

/** Posts a click at a point of a widget. */
void Click(QWidget* widget, const QPoint& place);
}

#endif
