"""An image in the emulated STM32F405, with its serial line and, on request, a debugger's access.

The emulator has core, memory and serial lines of the chip; clocks, pins and most timers are holes
that read as 0 and log what is written to them.
"""
import pathlib
import re
import select
import shutil
import socket
import struct
import subprocess
import time

EMULATOR = "qemu-system-arm"
SKIPPED = 77
INSTRUCTION_NS_LOG2 = 3  # 8 ns, about what the chip needs at 168 MHz.
FLASH = 0x08000000
GPIO_WRITE = re.compile(r"GPIO([A-I]): unimplemented device write .*offset 0x(\w+), value 0x(\w+)\)")
SET_RESET = 0x18
PC, SP, XPSR = 15, 13, 25  # Registers as the debugger numbers them.
THUMB = 1 << 24


def missing(*files: str) -> bool:
    """Tells, and returns true, when there is nothing to run or nothing to run it in: images, plug-in."""
    if all(pathlib.Path(file).exists() for file in files) and shutil.which(EMULATOR):
        return False
    print(f"skipped: needs {EMULATOR} and {' '.join(files)} (presets cortex-m4f and release)")
    return True


def pin_writes(log: str) -> list:
    """(port, offset of the register, value) of each write to a pin's registers, in order."""
    return [(found[1], int(found[2], 16), int(found[3], 16)) for found in GPIO_WRITE.finditer(log)]


def command(plugin: str, image: pathlib.Path, folder: pathlib.Path) -> list:
    """The emulator on this image, with the chip's own memories by the plug-in of machine/, and nothing
    else of it. Where the image is behind a boot loader, in place of that the two
    words by which the core finds it, from a file in the folder.

    Its time goes by instructions. By the clock on the wall the tick came whether or not the core had
    been given time meanwhile: on a busy machine it was in its interrupt for seconds and nowhere else.
    """
    words = [EMULATOR, "-M", "netduinoplus2", "-display", "none", "-monitor", "none",
             "-icount", f"shift={INSTRUCTION_NS_LOG2}", "-kernel", str(image),
             "-plugin", f"{plugin},memories_only=on"]
    where = subprocess.run(["arm-none-eabi-nm", image], capture_output=True, text=True, check=True)
    begin = int(re.search(r"(\w+) \w image_begin", where.stdout)[1], 16)
    if begin != FLASH:
        loader = folder / "loader.bin"
        loader.write_bytes(image.with_suffix(".bin").read_bytes()[:8])
        words += ["-device", f"loader,file={loader},addr=0x{FLASH:x},force-raw=on"]
    return words


class Emulator:
    """A running image; use it in a with statement."""

    def __init__(self, plugin: str, image: pathlib.Path, folder: pathlib.Path):
        self.log_path = folder / "emulator.log"
        self.socket_path = folder / "debugger"
        words = [*command(plugin, image, folder), "-serial", "stdio", "-d", "unimp", "-D", str(self.log_path),
                 "-gdb", f"unix:{self.socket_path},server=on,wait=off"]
        self.process = subprocess.Popen(words, stdin=subprocess.PIPE, stdout=subprocess.PIPE)
        self.heard = b""

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.process.kill()
        self.process.wait()
        self.process.stdin.close()
        self.process.stdout.close()

    def say(self, text: str):
        self.process.stdin.write(text.encode("latin-1"))
        self.process.stdin.flush()

    def hear(self, pattern: str, seconds: float = 20.0) -> str:
        """What is said up to and with a match of the pattern; what comes after it stays unheard."""
        end = time.monotonic() + seconds
        while True:
            if found := re.search(pattern.encode(), self.heard):
                text, self.heard = self.heard[:found.end()], self.heard[found.end():]
                return text.decode("latin-1")
            readable, _, _ = select.select([self.process.stdout], [], [], end - time.monotonic())
            if not readable:
                raise AssertionError(f"no {pattern!r} in {seconds} s, but {self.heard!r}")
            self.heard += self.process.stdout.read1(65536)

    def log(self) -> str:
        return self.log_path.read_text(encoding="ascii", errors="replace")

    def debugger(self) -> "Debugger":
        return Debugger(self.socket_path)


class Debugger:
    """As much of the remote serial protocol as changes a register or a word. The core stands still,
    in no interrupt, from the beginning of the with statement to its end."""

    MOST_LOOKS = 500

    def __init__(self, path: pathlib.Path):
        self.socket = socket.socket(socket.AF_UNIX)
        self.socket.settimeout(10)
        self.socket.connect(str(path))
        self.received = b""

    def __enter__(self):
        self._ask("?")
        # The emulator lets registers be written by those only who have asked what there are.
        self._ask("qXfer:features:read:target.xml:0,ffb")
        self._leave_interrupts()
        return self

    def __exit__(self, *_):
        self._send("D")
        self.socket.recv(64)
        self.socket.close()

    def _leave_interrupts(self):
        """What is planted in one would wait for its end, or make it another's."""
        for _ in range(self.MOST_LOOKS):
            status = struct.unpack("<I", bytes.fromhex(self._ask(f"p{XPSR:x}")[:8]))[0]
            if status & 0x1FF == 0:
                return
            self._send("c")
            time.sleep(0.002)
            self.socket.sendall(b"\x03")
            self._hear("T")
        raise AssertionError("the core does not come out of its interrupts")

    def set_register(self, number: int, value: int):
        assert "OK" in self._ask(f"P{number:x}={struct.pack('<I', value).hex()}")

    def set_word(self, address: int, value: int):
        assert "OK" in self._ask(f"M{address:x},4:{struct.pack('<I', value).hex()}")

    def go_to(self, address: int):
        """Where the core goes on. It forgets the conditions of instructions to come, which it has in
        the middle of an IT block: the first ones there would be skipped."""
        self.set_register(XPSR, THUMB)
        self.set_register(PC, address)

    def store(self, address: int, value: int, scratch: int):
        """Lets the core itself store a word, and then stand, at scratch + 4: devices take no word
        from a debugger. `scratch` is a place in RAM for these three instructions. Interrupts are
        allowed first, as the core may have stood where they are not."""
        self.set_word(scratch, 0x6001B662)  # cpsie i; str r1, [r0]
        self.set_word(scratch + 4, 0xE7FEE7FE)  # b .
        self.set_register(0, address)
        self.set_register(1, value)
        self.go_to(scratch)

    def _send(self, packet: str):
        self.socket.sendall(f"${packet}#{sum(packet.encode()) % 256:02x}".encode())

    def _ask(self, packet: str) -> str:
        """The answer. That the core has stopped may be told by itself, at any time after the
        beginning: it answers `?` alone."""
        self._send(packet)
        return self._hear("T" if packet == "?" else "")

    def _hear(self, kind: str) -> str:
        """The next packet that begins with `kind`; with none, that does not tell of a stop."""
        while True:
            while not (found := re.search(rb"\$([^#]*)#..", self.received)):
                self.received += self.socket.recv(4096)
            self.received = self.received[found.end():]
            self.socket.sendall(b"+")
            text = found[1].decode("ascii", errors="replace")
            if text.startswith(kind) if kind else not text.startswith("T"):
                return text
