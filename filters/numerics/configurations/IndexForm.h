#pragma once

#include "StrengthChanges.h"

namespace crossfield
{
/// The form of StrengthChanges in the indices themselves: up to a constant, linear · k + ½ k · matrix k
/// for all k with the sum `total`.
struct IndexForm
{
  StrengthChanges::Form form;
  int total = 0;
};
}
