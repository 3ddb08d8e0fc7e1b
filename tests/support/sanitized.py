"""Whether a program is that of the sanitizers' build, which keeps what is freed."""
import pathlib


def is_sanitized(program) -> bool:
    return b"__asan_init" in pathlib.Path(program).read_bytes()
