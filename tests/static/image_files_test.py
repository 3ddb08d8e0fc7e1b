"""Reads the files that toolchain/image_files.py writes."""
import pathlib
import struct
import sys
import unittest
import zlib

from source_files import ROOT

sys.path.insert(0, str(ROOT / "toolchain"))
import image_files  # noqa: E402  pylint: disable=wrong-import-position


class DfuSe(unittest.TestCase):
    """Reads the format by UM0391, independently of the writer."""

    IMAGE = bytes(range(256)) * 5

    def setUp(self):
        self.file = image_files.dfuse(self.IMAGE, 0x08008000)

    def test_the_prefix_tells_the_size_without_the_suffix(self):
        signature, version, size, targets = struct.unpack_from("<5sBIB", self.file)
        self.assertEqual((b"DfuSe", 1, len(self.file) - 16, 1), (signature, version, size, targets))

    def test_the_target_has_one_element_with_the_image(self):
        signature, setting, named = struct.unpack_from("<6sBI", self.file, 11)
        size, elements = struct.unpack_from("<II", self.file, 11 + 266)
        address, length = struct.unpack_from("<II", self.file, 11 + 274)
        self.assertEqual((b"Target", 0, 1, 1), (signature, setting, named, elements))
        self.assertEqual((0x08008000, len(self.IMAGE)), (address, length))
        self.assertEqual(size, 8 + length)
        begin = 11 + 274 + 8
        self.assertEqual(self.IMAGE, self.file[begin:begin + length])
        self.assertEqual(len(self.file), begin + length + 16)

    def test_the_suffix_names_the_boot_loader_and_holds(self):
        device, product, vendor, version, mark, length, checksum = struct.unpack(
            "<HHHH3sBI", self.file[-16:])
        self.assertEqual((0xFFFF, 0xDF11, 0x0483, 0x011A), (device, product, vendor, version))
        self.assertEqual((b"UFD", 16), (mark, length))
        self.assertEqual(checksum, ~zlib.crc32(self.file[:-4]) & 0xFFFFFFFF)

    def test_the_command_fits_the_place(self):
        image = pathlib.Path("kerfline.elf")
        self.assertIn("dfu-util", image_files.how_to_flash(image, 0x08000000))
        self.assertIn("0x0800c000", image_files.how_to_flash(image, 0x0800C000))
        behind_a_loader = image_files.how_to_flash(image, 0x0800C000)
        self.assertIn("to the card", behind_a_loader)
        self.assertIn("kerfline.dfu, which leaves the board's loader", behind_a_loader)


if __name__ == "__main__":
    unittest.main()
