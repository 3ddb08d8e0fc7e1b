#pragma once

#include <string_view>
#include <system_error>

namespace sim {

/// Prints on standard error that the output of this option cannot be written any more, as on a full
/// disk, and that the machine continues without it.
void report_lost_output(std::string_view option, const std::system_error& reason);

}  // namespace sim
