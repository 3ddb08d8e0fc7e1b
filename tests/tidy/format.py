"""Fails if clang-format would change a C++ source.

usage: format.py CLANG_FORMAT [--fix]
"""
import pathlib
import subprocess
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "static"))
from source_files import ROOT, source_files  # noqa: E402


def main() -> int:
    mode = ["-i"] if "--fix" in sys.argv else ["--dry-run", "-Werror"]
    sources = source_files(ROOT, ".cpp", ".hpp")
    status = subprocess.run([sys.argv[1], *mode, *sources], check=False).returncode
    print(f"clang-format: {len(sources)} files, " + ("not as it would have them" if status else "clean"))
    return bool(status)


if __name__ == "__main__":
    sys.exit(main())
