"""Plants faults at given times: options for the emulated chip which make the image misbehave."""

import pathlib
import subprocess
import tempfile

from chip import FLOOD_PIN, Chip

FREE = 0x2001F000  # RAM behind all that the image uses.
TABLE, CODE = FREE, FREE + 0x40
TABLE_ENTRIES = 8
FLASH = 0x08000000

# First the pin of the flood coolant rises, so that the trace shows the time.
MARK = """
    ldr r0, =0x40020418
    movs r1, #16
    str r1, [r0]
"""
assert FLOOD_PIN == "PB4"

ACTIONS = {
    "exception": "ldr r2, =0x60000000\n ldr r2, [r2]\n b .",
    "contract": "ldr r2, ={contract}\n bx r2",
    "stack": "ldr r2, ={stack_bottom}\n mov sp, r2\n push {{r0, r1}}\n b .",
    "supply": "ldr r2, =0xE000E200\n movs r3, #2\n str r3, [r2]\n b .",
    "crystal": "ldr r2, =0xE000ED04\n movs r3, #1\n lsls r3, #31\n str r3, [r2]\n b .",
    "hang": "b .",
}


def assemble(text: str) -> bytes:
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        source, linked, code = folder / "a.s", folder / "a.o", folder / "a.bin"
        source.write_text(".syntax unified\n.cpu cortex-m4\n.thumb\n" + text + "\n.pool\n")
        subprocess.run(["arm-none-eabi-as", "-o", linked, source], check=True)
        subprocess.run(["arm-none-eabi-objcopy", "-O", "binary", linked, code], check=True)
        return code.read_bytes()


def in_main_loop(chip: Chip, action: str, at_ns: int) -> list:
    """Returns options for code that the main loop runs when it next reads its serial line: the
    line's object gets a table of virtual functions that all lead to the code."""
    text = ACTIONS[action].format(
        contract=hex(chip.symbols["_ZN3cnc15contract_failedEPKcS1_i"] | 1),
        stack_bottom=hex(chip.symbols["stack_bottom"]))
    code = assemble(MARK + text)
    code += bytes(-len(code) % 4)
    words = [(CODE + place, int.from_bytes(code[place:place + 4], "little"))
             for place in range(0, len(code), 4)]
    words += [(TABLE + 4 * entry, CODE | 1) for entry in range(TABLE_ENTRIES)]
    # The pointer to the table comes last: events of the same time occur in their order.
    words.append((chip.symbols["_ZN6target4lineE"], TABLE))
    return [f"store={address:x}:{word:x}:{at_ns}" for address, word in words]


def in_function(chip: Chip, name: str, at_ns: int) -> list:
    """Returns options that make a function hang at its beginning: bits of its first instruction in
    the flash flip."""
    address = chip.symbols[name] & ~1
    binary = chip.image.with_suffix(".bin").read_bytes()
    here = binary[address - FLASH:address - FLASH + 2]
    hang = (0xE7FE).to_bytes(2, "little")  # b .
    return [f"flip={address + byte:x}:{bit}:{at_ns}"
            for byte in range(2) for bit in range(8) if (here[byte] ^ hang[byte]) >> bit & 1]
