#ifndef InterruptGuard_h
#define InterruptGuard_h

#include <string>
#include <vector>

/**
 * While one of these exists, SIGINT, SIGTERM, SIGHUP and SIGPIPE wait; at other times they remove
 * what RemoveOnSignal was told last and end the program as they always do.
 */
class InterruptGuard
{
public:
  InterruptGuard();
  ~InterruptGuard();
  InterruptGuard(const InterruptGuard&) = delete;
  InterruptGuard& operator=(const InterruptGuard&) = delete;

  /** Handles the signals that are not ignored; makes a limit on the size of files an error. */
  static void Install();

  /** Files and folders, the outer ones first, to remove when a signal comes. Needs a guard. */
  static void RemoveOnSignal(std::vector<std::string> files, std::vector<std::string> folders);
};

#endif
