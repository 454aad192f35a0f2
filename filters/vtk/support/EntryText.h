#ifndef EntryText_h
#define EntryText_h

#include <string>
#include <utility>
#include <vector>

/** Entries in text form, NAME:VALUE separated by semicolons. */
namespace EntryText
{
/** Returns the parts of a text between separators, without blanks around them. */
std::vector<std::string> Split(const std::string& text, char separator);

/**
 * Divides an entry at its last colon. Throws crossfield::Error if there is none; `what` is its kind and
 * `form` its form, for the message.
 */
std::pair<std::string, std::string> Divide(
  const std::string& entry, const std::string& what, const std::string& form);
}

#endif
