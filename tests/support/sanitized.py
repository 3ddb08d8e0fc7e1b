"""Tells whether a program is from the build with sanitizers, which keeps freed memory allocated."""
import pathlib


def is_sanitized(program) -> bool:
    return b"__asan_init" in pathlib.Path(program).read_bytes()
