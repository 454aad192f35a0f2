#ifndef JsonText_h
#define JsonText_h

#include "Json.h"

#include <string>

/**
 * Returns JSON as text, with two blanks for each level if `indent` is 2, and in one line if it is
 * -1. File names may contain any bytes: those that are not UTF-8 become the replacement character.
 */
inline std::string JsonText(const nlohmann::ordered_json& json, int indent = 2)
{
  return json.dump(indent, ' ', false, nlohmann::ordered_json::error_handler_t::replace);
}

#endif
