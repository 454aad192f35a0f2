#pragma once

#include "Error.h"

#include <optional>

namespace crossfield
{
/// The value of a call or the error that it threw, for code that goes on after an error.
template <typename Value>
struct Outcome
{
  std::optional<Value> value;
  std::optional<Error> error; ///< Set if and only if there is no value.
};

/// Returns the value of call(), or its error.
template <typename Call>
auto Try(const Call& call) -> Outcome<decltype(call())>
{
  try
  {
    return { call(), std::nullopt };
  }
  catch (const Error& error)
  {
    return { std::nullopt, error };
  }
}
}
