// What is at a path, asked without failing, and files opened so that nothing waits for ever.
#pragma once

#include <functional>
#include <string>
#include <string_view>

namespace strad {

// Whether there is anything at `path`. A name that no file can have (too long, through a file) is just not
// there.
bool file_exists(const std::string& path);
bool is_plain_file(const std::string& path);

// A descriptor for reading, which the caller closes. Throws IoError when `path` cannot be opened, BadInput
// when it is a directory, or a named pipe that no program opens for writing within ten seconds. `expected`
// says what is wanted, for errors: "a text file".
int open_for_reading(const std::string& path, const std::string& expected);

// Gives all of a file to `see`, block by block; "-" is standard input. `see` may throw, to end what has no
// end. Throws like open_for_reading, and IoError when it cannot be read.
void read_blocks(const std::string& path, const std::string& expected,
                 const std::function<void(std::string_view block)>& see);

}  // namespace strad
