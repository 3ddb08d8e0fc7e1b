"""Runs an image in the emulated STM32F405, with its serial line and, on request, the access of a
debugger.

The emulator has core, memory and serial lines of the chip. Clocks, pins and most timers are
placeholders that read as 0 and log what is written to them.
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
    """Returns whether images or the plug-in or the emulator are missing, and prints which."""
    if all(pathlib.Path(file).exists() for file in files) and shutil.which(EMULATOR):
        return False
    print(f"skipped: needs {EMULATOR} and {' '.join(files)} (presets cortex-m4f and release)")
    return True


def pin_writes(log: str) -> list:
    """Returns (port, offset of the register, value) of each write to a pin's registers, in order."""
    return [(found[1], int(found[2], 16), int(found[3], 16)) for found in GPIO_WRITE.finditer(log)]


def command(plugin: str, image: pathlib.Path, folder: pathlib.Path) -> list:
    """Returns the command that runs the emulator on this image, with the plug-in of machine/ for
    the chip's own memories and for nothing else. For an image behind a boot loader, a file in the
    folder holds the two words by which the core finds the image.

    Virtual time follows the instructions. With the clock of the host the tick would come even if
    the core had got no processor time: on a busy machine it would spend seconds in its interrupt.
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
    """A running image, to be used in a with statement."""

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
        """Returns the output up to the end of a match of the pattern; later output is left for the
        next call."""
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
    """Part of the remote serial protocol: access to registers and words. The core is stopped, in no
    interrupt, for the whole with statement."""

    MOST_LOOKS = 500

    def __init__(self, path: pathlib.Path):
        self.socket = socket.socket(socket.AF_UNIX)
        self.socket.settimeout(10)
        self.socket.connect(str(path))
        self.received = b""

    def __enter__(self):
        self._ask("?")
        # The emulator permits writes to registers only after the list of registers has been
        # requested.
        self._ask("qXfer:features:read:target.xml:0,ffb")
        self._leave_interrupts()
        return self

    def __exit__(self, *_):
        self._send("D")
        self.socket.recv(64)
        self.socket.close()

    def _leave_interrupts(self):
        """Runs until the core is in no interrupt: a fault that is planted within an
        interrupt would wait for its end, or affect another interrupt."""
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
        """Continues at an address. Clears the state of an IT block, whose conditions would
        otherwise skip the first instructions there."""
        self.set_register(XPSR, THUMB)
        self.set_register(PC, address)

    def store(self, address: int, value: int, scratch: int):
        """Makes the core itself store a word, because devices ignore words from a debugger. The
        core then stops at scratch + 4. `scratch` is an address in RAM for three instructions.
        Interrupts are enabled first, as the core may have stopped where they are disabled."""
        self.set_word(scratch, 0x6001B662)  # cpsie i; str r1, [r0]
        self.set_word(scratch + 4, 0xE7FEE7FE)  # b .
        self.set_register(0, address)
        self.set_register(1, value)
        self.go_to(scratch)

    def _send(self, packet: str):
        self.socket.sendall(f"${packet}#{sum(packet.encode()) % 256:02x}".encode())

    def _ask(self, packet: str) -> str:
        """Sends a packet and returns the answer. The emulator may report a stop by itself at any
        time after the beginning; it counts as an answer only to `?`."""
        self._send(packet)
        return self._hear("T" if packet == "?" else "")

    def _hear(self, kind: str) -> str:
        """Returns the next packet that begins with `kind`; without `kind`, the next one that
        reports no stop."""
        while True:
            while not (found := re.search(rb"\$([^#]*)#..", self.received)):
                self.received += self.socket.recv(4096)
            self.received = self.received[found.end():]
            self.socket.sendall(b"+")
            text = found[1].decode("ascii", errors="replace")
            if text.startswith(kind) if kind else not text.startswith("T"):
                return text
