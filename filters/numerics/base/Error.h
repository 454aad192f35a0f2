#pragma once

#include <stdexcept>
#include <string>

namespace crossfield
{
/// Exception thrown by all functions of this library. Its message is one sentence that names the
/// cause and the remedy.
class Error : public std::runtime_error
{
public:
  enum class Kind
  {
    BadInput,    ///< The input is invalid, or a computation on it broke down.
    Inconsistent ///< The input is valid, but no cross field with these singularities exists.
  };

  explicit Error(const std::string& message, Kind kind = Kind::BadInput)
    : std::runtime_error(message)
    , ErrorKind(kind)
  {
  }

  Kind GetKind() const { return this->ErrorKind; }

private:
  Kind ErrorKind;
};
}
