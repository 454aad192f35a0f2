#ifndef NumberCheck_h
#define NumberCheck_h

#include <string>
#include <utility>
#include <vector>

namespace CLI
{
class Validator;
}

/**
 * Checks on the values of options. A message requests what is right and quotes the value; CLI11
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

/** Checks for one of some words, for CLI::Option::transform: it is replaced by its number. */
CLI::Validator Word(const std::vector<std::pair<std::string, int>>& words);
}

#endif
