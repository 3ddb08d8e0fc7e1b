/// LeakSanitizer calls this function; a build without it does not use it. librsvg and Pango keep
/// fonts of fontconfig until the process ends, and never free them.
extern "C" const char* __lsan_default_suppressions();
extern "C" const char* __lsan_default_suppressions() { return "leak:libfontconfig\n"; }
