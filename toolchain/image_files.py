#!/usr/bin/env python3
"""Makes what flashing tools want out of a linked image, and says what it is.

    image_files.py IMAGE.elf 0x08000000

Writes IMAGE.bin, .hex (Intel HEX) and .dfu (DfuSe, as dfu-util reads it) beside it; or, if there
is something in it that must not run on a controller, nothing, and removes it.
"""
import hashlib
import pathlib
import struct
import subprocess
import sys
import zlib

from banned_symbols import banned

NM = "arm-none-eabi-nm"
OBJCOPY = "arm-none-eabi-objcopy"
SIZE = "arm-none-eabi-size"
FLASH = 0x08000000
ST, DFU_MODE = 0x0483, 0xDF11  # USB vendor, and product of the boot loader in ROM.


def complaints(elf: pathlib.Path) -> list:
    """What is in the image though it must not be, came it from the sources or a library."""
    symbols = subprocess.run([NM, "-P", elf], capture_output=True, text=True, check=True)
    return [f"{what}: {symbol} in {elf.name}" for line in symbols.stdout.splitlines()
            for symbol in line.split()[:1] for what in banned(symbol)]


def dfuse(image: bytes, address: int) -> bytes:
    """ST's DfuSe format 1.1a (UM0391): prefix, one target with one element, suffix."""
    element = struct.pack("<II", address, len(image)) + image
    name = b"Kerfline".ljust(255, b"\0")
    target = struct.pack("<6sBI255sII", b"Target", 0, 1, name, len(element), 1) + element
    prefix = struct.pack("<5sBIB", b"DfuSe", 1, 11 + len(target), 1)
    suffix = struct.pack("<HHHH3sB", 0xFFFF, DFU_MODE, ST, 0x011A, b"UFD", 16)
    body = prefix + target + suffix
    # The checksum of DFU is zip's without its last inversion.
    return body + struct.pack("<I", zlib.crc32(body) ^ 0xFFFFFFFF)


def how_to_flash(image: pathlib.Path, address: int) -> str:
    if address == FLASH:
        return (f"dfu-util -a 0 -d {ST:04x}:{DFU_MODE:04x} -D {image.with_suffix('.dfu').name}"
                f"   or   st-flash --reset write {image.with_suffix('.bin').name} 0x{FLASH:08x}")
    return (f"copy {image.with_suffix('.bin').name} to the card as the board's boot loader wants it,"
            f" or   st-flash --reset write {image.with_suffix('.bin').name} 0x{address:08x}")


def main() -> int:
    elf, address = pathlib.Path(sys.argv[1]), int(sys.argv[2], 16)
    if found := complaints(elf):
        elf.unlink()
        print("\n".join(found))
        return 1
    binary = elf.with_suffix(".bin")
    subprocess.run([OBJCOPY, "-O", "binary", elf, binary], check=True)
    subprocess.run([OBJCOPY, "-O", "ihex", elf, elf.with_suffix(".hex")], check=True)
    image = binary.read_bytes()
    elf.with_suffix(".dfu").write_bytes(dfuse(image, address))
    sizes = subprocess.run([SIZE, elf], capture_output=True, text=True, check=True)
    text, data, bss = map(int, sizes.stdout.splitlines()[1].split()[:3])
    print(f"{elf.stem}: {text + data} bytes of flash, {data + bss} of RAM with the stack, "
          f"checksum {zlib.crc32(image):08x}\n  sha256 {hashlib.sha256(image).hexdigest()}\n"
          f"  {how_to_flash(elf, address)}")
    return 0


if __name__ == "__main__":
    sys.exit(main())
