#pragma once

#include <functional>
#include <utility>

namespace crossfield
{
/// Thrown out of a computation whose caller asked it to stop; not an error.
class Aborted
{
};

/// Reports the finished fraction of a computation, and carries the wish to stop back into it.
class Progress
{
public:
  /// Called with the finished fraction in [0, 1]; returns false to stop.
  using Callback = std::function<bool(double)>;

  Progress() = default;
  explicit Progress(Callback callback)
    : Function(std::move(callback))
  {
  }

  /// Throws Aborted when the callback returns false.
  void Report(double fraction) const
  {
    if (this->Function && !this->Function(this->From + fraction * (this->To - this->From)))
    {
      throw Aborted();
    }
  }

  /// The progress of one stage that runs from one fraction of this to another.
  Progress Part(double from, double to) const
  {
    Progress part(this->Function);
    part.From = this->From + from * (this->To - this->From);
    part.To = this->From + to * (this->To - this->From);
    return part;
  }

private:
  Callback Function;
  double From = 0.0;
  double To = 1.0;
};
}
