#pragma once

#include <memory>
#include <mutex>

namespace crossfield
{
/// A value that is made when it is first used, by one thread; the others wait for it. It does not
/// change afterwards, so const functions that return it may be called from several threads at once.
template <typename Value>
class Lazy
{
public:
  /// Returns the value; the first call makes it by `make()`, which returns a std::unique_ptr to it.
  /// When `make` throws, the exception is passed on and the next call tries again.
  template <typename Make>
  const Value& Get(const Make& make) const
  {
    std::call_once(this->Made, [&] { this->Kept = make(); });
    return *this->Kept;
  }

private:
  mutable std::once_flag Made;
  mutable std::unique_ptr<const Value> Kept;
};
}
