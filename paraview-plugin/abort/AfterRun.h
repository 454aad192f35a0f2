#ifndef AfterRun_h
#define AfterRun_h

#include <QTimer>

#include <utility>

/**
 * Calls a function from the event loop, as long as `context` exists, and not while a filter runs.
 * QTimer::singleShot with an interval of 0 posts an event instead, which RunAbort processes during a
 * run; if the function updates the pipeline, VTK then ends ParaView. Timers wait.
 */
template <class Function>
void AfterRun(QObject* context, Function&& function)
{
  constexpr int Interval = 1; // in milliseconds
  QTimer::singleShot(Interval, context, std::forward<Function>(function));
}

#endif
