#pragma once

namespace sim {

/// Prepares the process for streams that fail. An input or output that the caller closed stays
/// closed, so that no file gets its number. A pipe without a reader, or a file beyond a limit, is
/// an error of the call that writes instead of a signal.
/// @pre it is the first call of the process
void prepare_standard_streams();

/// Writes the rest of standard output. Returns false if any output was lost, and prints the reason
/// to standard error.
/// @param reason of an earlier failure, as errno has it; 0 for none
[[nodiscard]] bool finish_standard_output(int reason);

/// Returns whether standard output failed to take a text.
[[nodiscard]] bool standard_output_failed();

/// Prints `kerfline: REASON` to standard error, unless standard error fails as well.
void print_error(const char* reason);

}  // namespace sim
