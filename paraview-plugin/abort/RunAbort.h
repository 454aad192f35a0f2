/**
 * @class   RunAbort
 * @brief   lets the user abort a run with the client's abort button or Esc
 *
 * ParaView before 6.1 does not process events while a filter runs, and its abort button is connected
 * to nothing. While a filter of this plugin runs, this object enables the button, processes events at
 * each progress report, and sets the abort flag of the filter when the button or Esc is pressed. All
 * other input is discarded and timers wait, so that nothing else changes or draws the pipeline
 * during the run.
 *
 * ParaView 6.1 has an abort button of its own, and this object does nothing there.
 *
 * An aborted filter has empty outputs; *Apply* is enabled and runs it again. Works with the built-in
 * server only: a remote server does not listen during a run.
 */

#ifndef RunAbort_h
#define RunAbort_h

#include "vtkWeakPointer.h"

#include <QObject>
#include <QPointer>

class pqPipelineSource;
class vtkAlgorithm;

class RunAbort : public QObject
{
  Q_OBJECT

public:
  explicit RunAbort(QObject* parent = nullptr);

  /** Called by ParaView when the plugin is loaded, and when ParaView exits. */
  void startup();
  void shutdown();

  /** Suspends the processing of events during its lifetime, for runs while a handle is dragged. */
  class Suspension
  {
  public:
    Suspension();
    ~Suspension();
    Q_DISABLE_COPY(Suspension)
  };

protected:
  bool eventFilter(QObject* object, QEvent* event) override;

private:
  void Observe(pqPipelineSource* source);
  void Begin(pqPipelineSource* source, vtkAlgorithm* algorithm);
  void End(vtkAlgorithm* algorithm);
  void ProcessEvents(int progress);
  void Abort();

  QPointer<pqPipelineSource> Source; ///< Source whose filter runs.
  vtkWeakPointer<vtkAlgorithm> Running;
  bool IsProcessing = false;
};

#endif
