// UTF-8 (RFC 3629), which all names in streams are.
#pragma once

#include <string>
#include <string_view>

namespace strad {

// The bytes of the character that `text` begins with, 1 to 4; 0 if that is no UTF-8, or `text` is empty.
size_t utf8_length(std::string_view text);
bool is_utf8(std::string_view text);
// Every byte as the character of that number (ISO 8859-1).
std::string utf8_from_latin1(std::string_view text);
// With U+FFFD in place of each byte that is no part of UTF-8.
std::string repaired_utf8(std::string_view text);

}  // namespace strad
