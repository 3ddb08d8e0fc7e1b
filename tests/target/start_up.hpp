#pragma once

/// Start-up of a program on the emulated chip, which talks through the debugger's
/// semihosting calls (Arm, "Semihosting for AArch32").

/// Zero-terminated, to the emulator's terminal.
void write_text(const char* text);

/// What the image is for; the emulator ends when it returns.
void run_on_target();
