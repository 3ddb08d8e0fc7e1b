#!/usr/bin/env python3
"""Completes a linked image, and makes the files that flashing tools require.

    image_files.py IMAGE.elf 0x08000000

Writes the checksum into the image's header (hal/stm32f405/image.hpp), by which start-up detects a
truncated or damaged image. Writes IMAGE.bin, .hex (Intel HEX) and .dfu (DfuSe, for dfu-util) into
the same folder. If the image contains code that must not run on a controller, it writes no file and
removes the image.
"""
import hashlib
import pathlib
import re
import struct
import subprocess
import sys
import zlib

from banned_symbols import banned

NM = "arm-none-eabi-nm"
OBJCOPY = "arm-none-eabi-objcopy"
READELF = "arm-none-eabi-readelf"
SIZE = "arm-none-eabi-size"
FLASH = 0x08000000
HEADER_MAGIC, CHECKSUM = 0x4E46524B, 8  # First word of ImageHeader, offset of its last.
ST, DFU_MODE = 0x0483, 0xDF11  # USB vendor, and product of the boot loader in ROM.


def complaints(elf: pathlib.Path) -> list:
    """Returns complaints about code that must not be in the image, from the sources or from a
    library."""
    symbols = subprocess.run([NM, "-P", elf], capture_output=True, text=True, check=True)
    return [f"{what}: {symbol} in {elf.name}" for line in symbols.stdout.splitlines()
            for symbol in line.split()[:1] for what in banned(symbol)]


def symbols_of(elf: pathlib.Path) -> dict:
    """Returns {symbol: address}."""
    listing = subprocess.run([NM, elf], capture_output=True, text=True, check=True).stdout
    return {name: int(address, 16)
            for address, _, name in (line.split(maxsplit=2) for line in listing.splitlines()
                                     if line[0] != " ")}


def place_in_file(elf: bytes, address: int) -> int:
    """Returns the offset in an ELF file of the bytes that are loaded to an address."""
    headers, = struct.unpack_from("<I", elf, 28)
    size, count = struct.unpack_from("<HH", elf, 42)
    for number in range(count):
        kind, offset, _, begin, length = struct.unpack_from("<5I", elf, headers + number * size)
        if kind == 1 and begin <= address < begin + length:
            return offset + address - begin
    raise ValueError(f"nothing is loaded to {address:#x}")


def checksum_of(image: bytes, at: int) -> int:
    """Returns the CRC-32 of an image whose header is at offset `at`: of all bytes except the
    checksum's own."""
    field = at + CHECKSUM
    return zlib.crc32(image[field + 4:], zlib.crc32(image[:field]))


def fill_header(elf: pathlib.Path, address: int) -> int:
    """Completes the ELF file, so that debuggers and emulators load the same bytes as flashing
    tools.

    @return the checksum, as `$I+` shows it on the chip."""
    at = symbols_of(elf)["image_header"] - address
    image = binary_of(elf)
    magic, length = struct.unpack_from("<II", image, at)
    if (magic, length) != (HEADER_MAGIC, len(image)):
        raise ValueError(f"the header says {magic:#x} and {length} bytes of {len(image)}")
    checksum = checksum_of(image, at)
    content = bytearray(elf.read_bytes())
    struct.pack_into("<I", content, place_in_file(content, address + at + CHECKSUM), checksum)
    elf.write_bytes(content)
    return checksum


def binary_of(elf: pathlib.Path) -> bytes:
    """Returns the image. It must not have gaps, whose bytes would differ between the files."""
    binary = elf.with_suffix(".bin")
    contents = []
    for fill in ("0xff", "0"):
        subprocess.run([OBJCOPY, "--gap-fill", fill, "-O", "binary", elf, binary], check=True)
        contents.append(binary.read_bytes())
    if contents[0] != contents[1]:
        raise ValueError(f"{elf.name} has a gap between its sections")
    return contents[0]


def dfuse(image: bytes, address: int) -> bytes:
    """Returns a file in ST's DfuSe format 1.1a (UM0391): prefix, one target with one element,
    suffix."""
    element = struct.pack("<II", address, len(image)) + image
    name = b"Kerfline".ljust(255, b"\0")
    target = struct.pack("<6sBI255sII", b"Target", 0, 1, name, len(element), 1) + element
    prefix = struct.pack("<5sBIB", b"DfuSe", 1, 11 + len(target), 1)
    suffix = struct.pack("<HHHH3sB", 0xFFFF, DFU_MODE, ST, 0x011A, b"UFD", 16)
    body = prefix + target + suffix
    # The checksum of DFU is that of zip without the last inversion.
    return body + struct.pack("<I", zlib.crc32(body) ^ 0xFFFFFFFF)


def dfu_command(image: pathlib.Path) -> str:
    return f"dfu-util -a 0 -d {ST:04x}:{DFU_MODE:04x} -D {image.with_suffix('.dfu').name}"


def how_to_flash(image: pathlib.Path, address: int) -> str:
    if address == FLASH:
        return (f"{dfu_command(image)}"
                f"   or   st-flash --reset write {image.with_suffix('.bin').name} 0x{FLASH:08x}")
    return (f"copy {image.with_suffix('.bin').name} to the card as the board's boot loader wants it,"
            f" or   st-flash --reset write {image.with_suffix('.bin').name} 0x{address:08x},"
            f" or, with BOOT0 high,   {dfu_command(image)}, which leaves the board's loader")


def caution_of(elf: pathlib.Path) -> str:
    """Returns the question to answer before this image is flashed, from the board's header; empty
    if there is none."""
    text = subprocess.run([READELF, "-p", ".caution", elf], capture_output=True, text=True,
                          check=True).stdout
    found = re.search(r"\[ *0\]  (.+)", text)
    return found[1] if found else ""


def main() -> int:
    elf, address = pathlib.Path(sys.argv[1]), int(sys.argv[2], 16)
    found = complaints(elf)
    try:
        checksum = fill_header(elf, address)
        image = binary_of(elf)
    except ValueError as error:
        found.append(str(error))
    if found:
        elf.unlink()
        print("\n".join(found))
        return 1
    subprocess.run([OBJCOPY, "-O", "ihex", elf, elf.with_suffix(".hex")], check=True)
    elf.with_suffix(".dfu").write_bytes(dfuse(image, address))
    sizes = subprocess.run([SIZE, elf], capture_output=True, text=True, check=True)
    text, data, bss = map(int, sizes.stdout.splitlines()[1].split()[:3])
    print(f"{elf.stem}: {text + data} bytes of flash, {data + bss} of RAM with the stack, "
          f"checksum {checksum:08x}\n  sha256 {hashlib.sha256(image).hexdigest()}\n"
          f"  {how_to_flash(elf, address)}")
    if caution := caution_of(elf):
        print(f"  CAUTION: {caution}.")
    return 0


if __name__ == "__main__":
    sys.exit(main())
