#!/usr/bin/env python3
"""Writes docs/boards.md, the pins of each board by connector and function, from the boards'
headers.

    toolchain/boards.py [--check]      --check: fails if the page is out of date
"""
import pathlib
import re
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[1]
PAGE = ROOT / "docs/boards.md"


def page(root: pathlib.Path = ROOT) -> str:
    """Returns the page, printed by a program that is compiled with the headers of `root`."""
    with tempfile.TemporaryDirectory() as folder:
        program = pathlib.Path(folder) / "boards_page"
        subprocess.run(["c++", "-std=c++20", "-O0", f"-I{root}", "-o", program,
                        ROOT / "toolchain/boards_page.cpp"], check=True)
        return subprocess.run([program], capture_output=True, text=True, check=True).stdout


def missing_images(text: str) -> list:
    """Returns the images that the build makes and the page does not name."""
    rules = (ROOT / "toolchain/images.cmake").read_text(encoding="utf-8")
    images = re.findall(r"^kerfline_board_image\((\w+) ", rules, re.MULTILINE)
    return [image for image in images if f"`{image}`" not in text]


def main() -> int:
    text = page()
    complaints = [f"toolchain/boards_page.cpp: the image {image} is missing"
                  for image in missing_images(text)]
    if "--check" not in sys.argv[1:]:
        PAGE.write_text(text, encoding="utf-8")
    elif text != PAGE.read_text(encoding="utf-8"):
        complaints.append("docs/boards.md is not what the boards' headers say: toolchain/boards.py writes it")
    print("\n".join(complaints) or "boards: the page is what the headers say")
    return bool(complaints)


if __name__ == "__main__":
    sys.exit(main())
