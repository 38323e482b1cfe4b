"""Bounds on stack from machine code: what each function of a Thumb-2 image moves the stack pointer by, along the longest chain of calls.

Nothing is run. A function's frame is the sum of all that lowers its stack pointer; calls are direct, and where one is not, or where
functions call one another in a circle, there is no bound and that is said.
"""

import re
import subprocess
import sys


def registers(text):
    """How many registers a list names."""
    total = 0
    for part in re.search(r"{(.*)}", text)[1].split(","):
        bounds = re.match(r"\s*[a-z]+(\d+)-[a-z]+(\d+)\s*$", part)
        total += int(bounds[2]) - int(bounds[1]) + 1 if bounds else 1
    return total


class Function:
    def __init__(self, name):
        self.name, self.frame, self.calls, self.indirect = name, 0, set(), False


def lowered(operation, arguments, constants):
    """By how many bytes an instruction lowers the stack pointer."""
    if operation.startswith("push") or operation.startswith("stmdb") and arguments.startswith("sp!"):
        return 4 * registers(arguments)
    if operation.startswith("vpush") or operation.startswith("vstmdb") and arguments.startswith("sp!"):
        return (8 if re.search(r"{\s*d", arguments) else 4) * registers(arguments)
    if operation.startswith("sub") and re.match(r"sp, (sp, )?#", arguments):
        return int(arguments.split("#")[1])
    if operation.startswith("sub") and re.match(r"sp,", arguments):
        register = arguments.split(",")[-1].strip()
        if register not in constants:
            sys.exit(f"a frame of unknown size: {operation} {arguments}")
        return constants[register]
    if operation.startswith("str") and "sp, #-" in arguments and arguments.endswith("!"):
        return int(re.search(r"#-(\d+)", arguments)[1])
    return 0


def without_padding(lines):
    """Lines but for those that the linker fills between functions: 0xd4d4, which reads as a jump to some other function. A function cannot
    end with that jump, because it goes on where its condition does not hold."""
    kept = []
    for line in lines:
        if not line:
            while kept and re.match(r"^\s*[0-9a-f]+:\td4d4\s", kept[-1]):
                kept.pop()
        kept.append(line)
    return kept


def functions(image):
    """All functions by their addresses."""
    text = subprocess.run(["arm-none-eabi-objdump", "-d", str(image)], capture_output=True, text=True, check=True).stdout
    found, own, constants = {}, None, {}
    for line in without_padding(text.splitlines()):
        head = re.match(r"^([0-9a-f]+) <(.*)>:$", line)
        if head:
            own = found[int(head[1], 16)] = Function(head[2])
            constants = {}
            continue
        parts = re.match(r"^\s*[0-9a-f]+:\t[0-9a-f ]+\t(\S+)\s*(.*)$", line)
        if not parts or own is None:
            continue
        operation, arguments = parts[1], parts[2].split(";")[0].split("@")[0].strip()
        own.frame += lowered(operation, arguments, constants)
        value = re.match(r"(\w+), #(\d+)$", arguments)
        if value and operation.startswith("mov"):
            constants[value[1]] = int(value[2])
        target = re.match(r"([0-9a-f]+) <[^+>]*>$", arguments)
        if target and re.match(r"(bl|b|blx)(\.[wn])?$|b[a-z]{2}(\.[wn])?$", operation):
            own.calls.add(int(target[1], 16))
        own.indirect |= bool(operation.startswith("bl") and re.match(r"(r\d+|ip)$", arguments))
        own.indirect |= operation == "bx" and bool(re.match(r"(r\d+|ip)$", arguments))
    return found


def bounds(image, pattern):
    """(what `pattern` finds in its name, bytes) of each function that it finds; an error where there is no bound."""
    found = functions(image)
    known = {}

    def bound(address, chain):
        function = found.get(address)
        if function is None:
            return 0
        if address not in known:
            if function.indirect or address in chain:
                sys.exit(f"no bound on the stack of {function.name}")
            inner = (bound(call, chain | {address}) for call in function.calls if call != address)
            known[address] = function.frame + max(inner, default=0)
        return known[address]

    sys.setrecursionlimit(10_000)
    for address, function in found.items():
        match = re.search(pattern, function.name)
        if match:
            yield match, bound(address, frozenset())
