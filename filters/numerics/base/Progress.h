#pragma once

#include <functional>
#include <utility>

namespace crossfield
{
/// Exception that ends a computation at its caller's request; it is not an error.
class Aborted
{
};

/// Progress reporter of a computation. Its callback can also request an abort.
class Progress
{
public:
  /// Receives the finished fraction in [0, 1]; returns false to abort.
  using Callback = std::function<bool(double)>;

  Progress() = default;
  explicit Progress(Callback callback)
    : Function(std::move(callback))
  {
  }

  /// Reports a fraction; throws Aborted if the callback returns false.
  void Report(double fraction) const
  {
    if (this->Function && !this->Function(this->From + fraction * (this->To - this->From)))
    {
      throw Aborted();
    }
  }

  /// Returns the reporter of a stage that covers the range from one fraction to another.
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
