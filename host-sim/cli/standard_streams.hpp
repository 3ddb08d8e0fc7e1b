#pragma once

namespace sim {

/// Prepares the process for standard streams that fail. A stream that the parent process closed is
/// replaced by one whose use fails, so that no other file gets its number. A write to a pipe
/// without a reader, or beyond a limit of file sizes, returns an error instead of raising a signal.
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
