/**
 * @class   ViewMessages
 * @brief   messages that a text in the view reports do not open the window Output Messages
 *
 * ParaView opens this window, which covers the lower part of the view, at each error and warning.
 * If a visible text of a filter, or of one downstream of it, reports a problem (TextLook.h), the
 * messages of the filter are added to the window without opening it. Applies to this plugin's
 * filters with the built-in server.
 */

#ifndef ViewMessages_h
#define ViewMessages_h

#include <QObject>
#include <QPointer>
#include <QString>

#include <vector>

class pqPipelineSource;

class ViewMessages : public QObject
{
  Q_OBJECT

public:
  explicit ViewMessages(QObject* parent = nullptr);

  /** Called by ParaView when the plugin is loaded, and when ParaView exits. */
  void startup();
  void shutdown();

  /** Drops messages during its lifetime. */
  class Suspension
  {
  public:
    Suspension();
    ~Suspension();
    Q_DISABLE_COPY(Suspension)
  };

private:
  struct Message
  {
    QPointer<pqPipelineSource> source;
    QString text;
    bool isError = false;
  };

  void Observe(pqPipelineSource* source);
  void Add(const Message& message);
  void Show();

  std::vector<Message> Pending;
};

#endif
