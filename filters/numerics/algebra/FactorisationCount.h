#pragma once

namespace crossfield
{
/// Returns the number of sparse factorisations started by this process; tests use it to check that
/// factors are reused.
long FactorisationCount();

/// Adds one.
void CountFactorisation();
}
