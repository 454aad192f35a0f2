#pragma once

#include <stdexcept>
#include <string>

namespace crossfield
{
/// Returns "CAUSE; REMEDY." of two clauses, or "CAUSE." if the remedy is empty.
inline std::string Sentence(const std::string& cause, const std::string& remedy)
{
  return cause + (remedy.empty() ? "" : "; " + remedy) + ".";
}

/// Exception thrown by all functions of this library. Its message is one sentence that names the
/// cause, the place and the remedy.
class Error : public std::runtime_error
{
public:
  enum class Kind
  {
    BadInput,     ///< The input is invalid, or a computation on it broke down.
    Inconsistent, ///< The input is valid, but no cross field with these singularities exists.
    CoarseMesh,   ///< A computation broke down that may succeed on a finer triangle mesh.
    LackOfRows    ///< Irregular nodes leave too few rows of quads for a boundary layer.
  };

  explicit Error(const std::string& message, Kind kind = Kind::BadInput)
    : std::runtime_error(message)
    , ErrorKind(kind)
  {
  }

  /// Constructs an error with the message Sentence(cause, remedy), whose remedy may be replaced.
  Error(const std::string& cause, const std::string& remedy, Kind kind)
    : std::runtime_error(Sentence(cause, remedy))
    , ErrorKind(kind)
    , Cause(cause)
    , Remedy(remedy)
  {
  }

  Kind GetKind() const { return this->ErrorKind; }
  /// Returns the clauses of the message; both are empty if it was given as a whole.
  const std::string& GetCause() const { return this->Cause; }
  const std::string& GetRemedy() const { return this->Remedy; }

private:
  Kind ErrorKind;
  std::string Cause;
  std::string Remedy;
};
}
