#ifndef InterruptGuard_h
#define InterruptGuard_h

#include <string>
#include <vector>

/**
 * Delays SIGINT, SIGTERM, SIGHUP and SIGPIPE while an object of this class exists. At other times
 * these signals remove the files and folders of the last RemoveOnSignal, and end the program as
 * usual.
 */
class InterruptGuard
{
public:
  InterruptGuard();
  ~InterruptGuard();
  InterruptGuard(const InterruptGuard&) = delete;
  InterruptGuard& operator=(const InterruptGuard&) = delete;

  /** Installs handlers for the signals that are not ignored; turns a limit on file size into an
   * error. */
  static void Install();

  /** Sets the files and folders (outer ones first) to remove on a signal. Needs a guard. */
  static void RemoveOnSignal(std::vector<std::string> files, std::vector<std::string> folders);
};

#endif
