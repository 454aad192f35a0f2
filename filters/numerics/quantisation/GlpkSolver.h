#pragma once

#include "LinearSolver.h"

#include <memory>

namespace crossfield
{
/// Makes an empty linear program that GLPK solves.
std::unique_ptr<LinearSolver> MakeGlpkSolver();
}
