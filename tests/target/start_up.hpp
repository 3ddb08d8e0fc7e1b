#pragma once

/// Start-up of a program on the emulated chip, which prints through the debugger's semihosting
/// calls (Arm, "Semihosting for AArch32").

/// Writes a zero-terminated text to the emulator's terminal.
void write_text(const char* text);

/// Main function of the image; the emulator ends when it returns.
void run_on_target();
