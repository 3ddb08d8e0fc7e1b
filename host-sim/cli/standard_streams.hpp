#pragma once

namespace sim {

/// Prepares the process for streams that fail: an input or output that the caller closed stays
/// closed, so that no file takes its number, and a pipe without a reader or a file beyond a limit
/// is an error of the call that writes instead of a signal. To be called first.
void prepare_standard_streams();

/// Writes what standard output still holds. False where any of it did not arrive; the reason goes
/// to standard error. @param reason of an earlier failure, as errno has it; 0 for none
[[nodiscard]] bool finish_standard_output(int reason);

/// Whether standard output failed to take something.
[[nodiscard]] bool standard_output_failed();

/// Prints `kerfline: REASON` to standard error, if that takes it.
void print_error(const char* reason);

}  // namespace sim
