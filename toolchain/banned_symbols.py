"""Classifies symbols of code that must not run on the controller, by their names."""
import re

_LIBM = """a?sinh? a?cosh? a?tanh? atan2 exp exp2 exp10 expm1 log log2 log10 log1p pow hypot cbrt
    sincos erfc? [lt]gamma""".split()

BANNED = {
    "heap": r"_?(malloc|calloc|realloc|free|memalign|aligned_alloc|strn?dup)(_r)?|_?sbrk(_r)?"
            r"|_Z(nw|na|dl|da).*",
    # An abstract class refers to __cxa_pure_virtual, which is never called and is no exception.
    "exceptions": r"__cxa_(?!pure_virtual).*|_Unwind_.*|__gxx_personality.*|__aeabi_unwind.*"
                  r"|_ZSt\d+__throw_.*|_ZSt9terminatev",
    "run-time type information": r"_ZT[IS].*|__dynamic_cast",
    # The list includes libgcc's conversions between float and 64-bit integers, which compute in
    # double.
    "double arithmetic": r"__aeabi_(d|cd).*|__aeabi_[a-z]+2d|__aeabi_f2u?lz|__powidf2|__(mul|div)dc3",
    "printf": r"_?(v?(as|s|sn|f|d)?i?(printf|scanf))(_r)?|puts|putchar|putc|fwrite|fputs|fflush"
              r"|strto(f|d|ld)|atof|_ZN?K?S[oi].*|_ZNSt8ios_base.*"
              r"|_ZSt(8to_chars|10from_chars)PK?cS\d?_R?[fde].*",
    "library mathematics that differs between machines":
        "(" + "|".join(_LIBM) + ")[fl]?",
    "square root as a call (use std::sqrt on floats)": r"sqrt[fl]?",
    "atomics that are not lock-free": r"__(atomic|sync)_.*",
    "the end of the program (use CNC_ASSERT)": r"abort|_?exit|atexit|__assert_func|raise",
}
_PATTERNS = [(what, re.compile(pattern)) for what, pattern in BANNED.items()]


def banned(symbol: str) -> list:
    """Returns the reasons for which a symbol is banned; nothing if it is permitted. Parts of a
    function that the optimizer split off count as the function."""
    return [what for what, pattern in _PATTERNS if pattern.fullmatch(symbol.partition(".")[0])]
