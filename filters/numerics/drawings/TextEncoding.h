#pragma once

#include <string>
#include <string_view>

namespace crossfield
{
/// Returns a text of a file as UTF-8 in one line: valid UTF-8 as it is, any other text as Latin-1, in
/// which old drawings are written. Control characters become blanks.
std::string ToUtf8(std::string_view text);
}
