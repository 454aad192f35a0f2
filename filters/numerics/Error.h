#pragma once

#include <stdexcept>

namespace crossfield
{
/// What every function of this library throws: one sentence that names the cause and the mend.
class Error : public std::runtime_error
{
public:
  using std::runtime_error::runtime_error;
};
}
