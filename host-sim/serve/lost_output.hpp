#pragma once

#include <string_view>
#include <system_error>

namespace sim {

/// Prints a message on standard error: the file that `option` names cannot be written any more, for
/// example because the disk is full, and the machine continues without it.
void report_lost_output(std::string_view option, const std::system_error& reason);

}  // namespace sim
