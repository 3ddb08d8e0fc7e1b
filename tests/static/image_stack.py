"""Computes the greatest stack that a linked image can need, from its machine code. It includes
frames and calls of every function, calls through tables of virtual functions, and nested
interrupts.

usage: image_stack.py IMAGE.elf [--main BYTES] [--interrupt BYTES]

A call through a pointer counts as a call of any virtual function. (Code also takes their addresses
where the optimizer guesses the target of a call and compares.) From the class of POINTED_AT, it
counts as a call of any function of the class whose address is taken. So the check fails if the
address of another function is taken. It also fails if a level needs more than its BYTES, on
recursion, on frames whose size is known only at run time, and if the image's stack is smaller than
the need of all levels together.
"""
import argparse
import functools
import pathlib
import re
import struct
import subprocess
import sys

MAIN_BYTES, INTERRUPT_BYTES = 4096, 512
# Eight words that the core pushes, eighteen of the FPU, and one to align them (Arm DDI 0403, B1.5.7).
ENTRY_BYTES = 4 * 27
# Functions that may run at each priority, from the most urgent; `stop` does not return.
LEVELS = (("clock_interrupt", "supply_interrupt"), ("step_interrupt",),
          ("line_interrupt", "usb_interrupt", "can_interrupt"))
MAIN = "start_up"
# Calls through a pointer to a non-virtual function: start-up runs the constructors of objects.
CONSTRUCTORS = r"_GLOBAL__sub_I_.*"
# The steps of a block's execution: member functions in a table, which one of these functions calls
# in turn.
POINTED_AT = r"_ZN3cnc5gcode9Execution\w+"

FUNCTION = re.compile(r"^([0-9a-f]{8}) <(.+)>:$")
INSTRUCTION = re.compile(r"^\s+([0-9a-f]+):\s+(\S+)\s*(.*)$")
BRANCH = re.compile(r"bl?(eq|ne|lt|gt|le|ge|mi|pl|hi|ls|cc|cs|vs|vc)?(\.[nw])?|cbn?z")


def tool(name: str, *arguments) -> list:
    run = subprocess.run(["arm-none-eabi-" + name, *map(str, arguments)], capture_output=True,
                         text=True, check=True)
    return run.stdout.splitlines()


def registers_in(text: str) -> int:
    count = 0
    for part in re.search(r"\{(.*)\}", text)[1].split(","):
        first, _, last = part.strip().partition("-")
        count += int(last[1:]) - int(first[1:]) + 1 if last else 1
    return count


class Function:
    def __init__(self):
        self.frame, self.calls, self.pointer_calls, self.dynamic = 0, set(), False, False

    def read(self, operation: str, operands: str, own_name: str):
        if operation in ("push", "push.w", "stmdb") and (operation != "stmdb" or operands[:2] == "sp"):
            self.frame += 4 * registers_in(operands)
        elif operation == "vpush":
            self.frame += (8 if "{d" in operands else 4) * registers_in(operands)
        elif found := re.match(r"sp,(?: sp,)? #(\d+)", operands):
            if operation.startswith("sub"):
                self.frame += int(found[1])
        elif found := re.search(r"\[sp, #-(\d+)\]!", operands):
            self.frame += int(found[1])
        elif operation.startswith("sub") and re.match(r"sp, ", operands):
            self.dynamic = True
        if BRANCH.fullmatch(operation):
            target = re.search(r"<([^+>]+)>", operands)
            # A branch to the function's own first instruction is a loop; a branch with link is a
            # call.
            if target and (target[1] != own_name or operation == "bl"):
                self.calls.add(target[1])
        elif operation == "blx" or (operation == "bx" and operands.strip() != "lr"):
            self.pointer_calls = True


class Image:
    def __init__(self, elf: pathlib.Path):
        self.functions, self.addresses, self.instructions = {}, {}, set()
        halves, taken = {}, set()
        current = None
        code = {line.split()[-1] for line in tool("objdump", "-t", elf) if line[15:16] == "F"}
        for line in tool("objdump", "-d", "--no-show-raw-insn", elf):
            if found := FUNCTION.match(line):
                current = found[2] if found[2] in code else None
                if not current:
                    continue
                self.functions[current] = Function()
                self.addresses[int(found[1], 16)] = current
            elif current and (found := INSTRUCTION.match(line)):
                operation, operands = found[2], found[3]
                if not operation.startswith("."):
                    self.instructions.add(int(found[1], 16))
                self.functions[current].read(operation, operands.split(";")[0], current)
                if half := re.match(r"(\w+), #(\d+)", operands):
                    if operation == "movw":
                        halves[half[1]] = int(half[2])
                    elif operation == "movt":
                        taken.add(int(half[2]) << 16 | halves.get(half[1], 0))
        self.words = {at: word for at, word in self._words_of(elf).items()
                      if at not in self.instructions and at + 2 not in self.instructions}
        self.classes = self._virtual_functions(elf)
        self.pointed_at = self._pointed_at(elf, taken)
        self.steps = {name for name in self.pointed_at if re.fullmatch(POINTED_AT, name)}
        self.class_of = {method: owner for owner, methods in self.classes.items()
                         for method in methods}

    @staticmethod
    def _words_of(elf: pathlib.Path) -> dict:
        """Returns {address: word} of constants and code."""
        words = {}
        for line in tool("objdump", "-s", "-j", ".text", "-j", ".data", elf):
            if found := re.match(r" ([0-9a-f]+) ((?:[0-9a-f]{2,8} ){1,4})", line):
                data = bytes.fromhex(found[2].replace(" ", ""))
                for place in range(0, len(data) - 3, 4):
                    words[int(found[1], 16) + place] = struct.unpack_from("<I", data, place)[0]
        return words

    @staticmethod
    def _pointers_in(elf: pathlib.Path) -> set:
        """Returns the positions of all words that the linker resolved as addresses. Other words may
        look like an address, for example the pins of a board."""
        return {int(row.split()[0], 16) for row in tool("readelf", "-rW", elf) if " R_ARM_ABS32 " in row}

    def _function_at(self, word: int) -> str:
        """Returns the function to which a pointer refers; empty if it is none."""
        return self.addresses.get(word - 1, "") if word & 1 else ""

    def _tables(self, elf: pathlib.Path) -> list:
        """Returns (name, address, bytes) of each table of virtual functions."""
        rows = [line.split() for line in tool("nm", "-S", elf)]
        return [(row[3], int(row[0], 16), int(row[1], 16)) for row in rows
                if len(row) == 4 and row[3].startswith("_ZTV")]

    def _virtual_functions(self, elf: pathlib.Path) -> dict:
        """Returns {table of virtual functions: {functions in it}}."""
        return {name: {self._function_at(self.words.get(at, 0))
                      for at in range(begin, begin + size, 4)}
                      - {""}
                for name, begin, size in self._tables(elf)}

    def _pointed_at(self, elf: pathlib.Path, built: set) -> set:
        """Returns the functions whose address is taken outside of the tables of virtual functions,
        by a constant in memory or by an address that code builds (`built`)."""
        tables = {at for _, begin, size in self._tables(elf) for at in range(begin, begin + size, 4)}
        self.pointers = self._pointers_in(elf)
        stored = {word for at, word in self.words.items() if at in self.pointers - tables}
        return {self._function_at(word) for word in stored | built} - {""}

    def pointer_targets(self, name: str, owners: frozenset) -> set:
        """Returns the possible targets of a call through a pointer: constructors in start-up;
        otherwise all functions of the classes that are not on the present path."""
        if name == MAIN:
            return {other for other in self.functions if re.fullmatch(CONSTRUCTORS, other)}
        if re.fullmatch(POINTED_AT, name):
            return self.steps - {name}
        return {method for owner, methods in self.classes.items() if owner not in owners
                for method in methods if not method.startswith("__cxa")}

    @functools.lru_cache(maxsize=None)
    def depth(self, name: str, owners: frozenset = frozenset()) -> tuple:
        """Returns (bytes, path) of the deepest calls from a function."""
        function = self.functions[name]
        if name in self.class_of:
            owners = owners | {self.class_of[name]}
        callees = set(function.calls)
        if function.pointer_calls:
            callees |= self.pointer_targets(name, owners)
        below = [self.depth(callee, owners) for callee in sorted(callees)
                 if callee in self.functions]
        size, way = max(below, default=(0, ()))
        return function.frame + size, (name, *way)

    def cycles(self) -> list:
        """Returns the paths of direct calls that lead from a function back to itself."""
        found, done, path = [], set(), []

        def visit(name: str):
            if name in path:
                found.append([*path[path.index(name):], name])
            elif name in self.functions and name not in done:
                path.append(name)
                for callee in sorted(self.functions[name].calls):
                    visit(callee)
                path.pop()
                done.add(name)

        for name in sorted(self.functions):
            visit(name)
        return found


def readable(way) -> str:
    names = tool("c++filt", *way) if way else []
    return " > ".join(name.split("(")[0] for name in names)


def report(image: Image, limits: argparse.Namespace, stack: int) -> list:
    """Prints the need of each level; returns complaints."""
    if not image.pointers:
        return ["the image was linked without --emit-relocs, which tells addresses from numbers"]
    complaints = [f"recursion: {readable(cycle)}" for cycle in image.cycles()]
    complaints += [f"size known only at run time: {name}"
                   for name, function in image.functions.items() if function.dynamic]
    complaints += [f"its address is taken: {readable([name])}"
                   for name in sorted(image.pointed_at - image.steps - set(image.class_of))]
    if image.steps and sum(function.pointer_calls and bool(re.fullmatch(POINTED_AT, name))
                           for name, function in image.functions.items()) != 1:
        complaints.append("not one function of POINTED_AT alone calls the others by address")
    if complaints:
        return complaints
    total, way = image.depth(MAIN)
    print(f"{total:6}  main loop: {readable(way)}")
    if total > limits.main:
        complaints.append(f"the main loop may need {total} bytes, limit {limits.main}")
    for level in LEVELS:
        size, way = max(image.depth(name) for name in level if name in image.functions)
        print(f"{size + ENTRY_BYTES:6}  {level[0]}: {readable(way)}")
        total += size + ENTRY_BYTES
        if size + ENTRY_BYTES > limits.interrupt:
            complaints.append(f"{level[0]} may need {size + ENTRY_BYTES} bytes, "
                              f"limit {limits.interrupt}")
    print(f"{total:6}  all at once, of {stack}")
    if total > stack:
        complaints.append(f"{total} bytes may be needed, and the stack has {stack}")
    return complaints


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("image", type=pathlib.Path)
    parser.add_argument("--main", type=int, default=MAIN_BYTES)
    parser.add_argument("--interrupt", type=int, default=INTERRUPT_BYTES)
    options = parser.parse_args()
    if not options.image.is_file():
        print("skipped: not built; cmake --preset cortex-m4f && cmake --build --preset cortex-m4f")
        return 77
    symbols = {fields[2]: int(fields[0], 16) for line in tool("nm", options.image)
               if len(fields := line.split()) == 3}
    sys.setrecursionlimit(10_000)
    stack = symbols["stack_top"] - symbols["stack_bottom"]
    complaints = report(Image(options.image), options, stack)
    print("\n".join(complaints) or "stack: clean")
    return bool(complaints)


if __name__ == "__main__":
    sys.exit(main())
