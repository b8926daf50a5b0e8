#!/usr/bin/env python3
"""Plants faults in a copy of the RTL: every fault of faults.json replaces one expression by a wrong one when its number is
chosen at run time. One verilated machine so holds all of them, and fault 0 is the true machine.
usage: plant.py FAULTS.json RTL_FOLDER OUTPUT_FOLDER [PACKAGE]
The package, vsg_pkg unless named, takes the function that tells which fault was chosen."""
import json
import pathlib
import sys


def main():
    faults, rtl, out = json.loads(pathlib.Path(sys.argv[1]).read_text()), pathlib.Path(sys.argv[2]), pathlib.Path(sys.argv[3])
    package = sys.argv[4] if len(sys.argv) > 4 else "vsg_pkg"
    out.mkdir(parents=True, exist_ok=True)
    texts = {path.name: path.read_text() for path in sorted(rtl.glob("*.sv")) + sorted(rtl.glob("*.svh"))}
    for number, fault in enumerate(faults, 1):
        text, true = texts[fault["file"]], fault["true"]
        if text.count(true) != 1:
            sys.exit(f"{sys.argv[1]}: fault {number} ({fault['name']}): its text stands {text.count(true)} times in {fault['file']}")
        expression, wrong = fault["expression"], fault["wrong"]
        if true.count(expression) != 1:
            sys.exit(f"{sys.argv[1]}: fault {number} ({fault['name']}): the expression must stand once in the text")
        planted = f"(({package}::chosen_fault() == {number}) ? ({wrong}) : ({expression}))"
        texts[fault["file"]] = text.replace(true, true.replace(expression, planted))
    head = f"package {package};"
    text = texts[f"{package}.sv"]
    texts[f"{package}.sv"] = text.replace(head, head + '\n\n  import "DPI-C" function int chosen_fault();\n', 1)
    for name, text in texts.items():
        target = out / name
        if not target.exists() or target.read_text() != text:
            target.write_text(text)


if __name__ == "__main__":
    main()
