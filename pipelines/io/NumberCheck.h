#ifndef NumberCheck_h
#define NumberCheck_h

namespace CLI
{
class Validator;
}

/**
 * Checks on the numbers of options. A message requests what is right and quotes the value; CLI11
 * puts the name of the option before it.
 */
namespace NumberCheck
{
/** Checks for a finite number above 0. */
CLI::Validator Positive();

/** Checks for a finite number that is 0 or above. */
CLI::Validator NotNegative();

/**
 * Checks for a whole number in a range, for CLI::Option::transform: an exponent as in 1e3 is
 * written out.
 */
CLI::Validator Whole(int minimum, int maximum);
}

#endif
