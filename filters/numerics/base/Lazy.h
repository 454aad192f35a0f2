#pragma once

#include <memory>
#include <mutex>

namespace crossfield
{
/// Value that is computed on first use, by one thread, while other threads wait. It does not change
/// afterwards, so const functions that return it may be called from several threads concurrently.
template <typename Value>
class Lazy
{
public:
  /// Returns the value. The first call computes it by `make()`, which returns a std::unique_ptr to
  /// it. When `make` throws, the exception is passed on and the next call tries again.
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
