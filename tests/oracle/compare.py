#!/usr/bin/env python3
"""Random frames held against the restored program of 1970, when its sources are there: the same segments in the same order
and the same counters. Left out are frames with a slope that does not fit 36 bits: the restored program does not keep to its
word there, the machine clamps.
usage: compare.py ORACLE_SOURCES BUILD_FOLDER VSG RANDOM_FRAMES FIRST_SEED COUNT      exit status 77: nothing to compare with"""
import json
import pathlib
import shutil
import subprocess
import sys

ROWS = {"polygon_blocks": "polygon_blocks", "edge_blocks": "edge_blocks", "edge_crossings": "edge_crossings",
        "implied_edges": "implied_lines", "output_segments": "output_segments",
        "segment_blocks_total": "segment_blocks_total", "segment_blocks_max": "segment_blocks_max",
        "segment_references": "segment_references", "reference_ratio": "ratio", "add_cycles": "add_cycles_exact",
        "add_cycles_listed": "add_cycles_total", "add_cycles_per_test": "add_cycles_per_test_exact",
        "percent_not_at_end": "percent_not_at_end", "output_buffer": "min_output_buffer"}


def build(sources, folder):
    if not sources.is_dir() or shutil.which("gfortran") is None:
        print("skipped: no sources of the program of 1970, or no gfortran")
        sys.exit(77)
    if not (folder / "oracle").exists():
        folder.mkdir(parents=True, exist_ok=True)
        for source in sources.iterdir():
            if source.is_file():
                (folder / source.name).write_bytes(source.read_bytes())
        subprocess.run(["sh", "build.sh"], cwd=folder, check=True, timeout=120)
    return folder / "oracle"


def main():
    sources, folder, vsg, random_frames = (pathlib.Path(a) for a in sys.argv[1:5])
    seed, count = sys.argv[5:7]
    oracle = build(sources, folder)
    listed = subprocess.run([random_frames, folder / "frames", seed, count], check=True, capture_output=True, text=True).stdout
    equal, refused, clamped = 0, 0, 0
    for line in listed.splitlines():
        frame, keep = line.rsplit(" ", 1)
        old = subprocess.run([oracle, "--div=floor"] + (["--noback"] if keep == "1" else []) + [frame], capture_output=True,
                             text=True, timeout=60)
        new = subprocess.run([vsg, "segments", frame] + (["--keep-back-faces"] if keep == "1" else []), capture_output=True,
                             text=True, timeout=60)
        answer = json.loads(old.stdout)
        if answer["overflow36"]:
            clamped += 1
            continue
        if answer["error"]:
            if new.returncode != 1:
                sys.exit(f"{frame}: the program of 1970 refuses it (error {answer['error']}), vsg does not")
            refused += 1
            continue
        if new.returncode != 0:
            sys.exit(f"{frame}: vsg refuses it, the program of 1970 does not: {new.stderr}")
        mine = json.loads(new.stdout)
        if mine["segments"] != answer["segments"]:
            at = next((i for i, (a, b) in enumerate(zip(answer["segments"], mine["segments"])) if a != b), None)
            sys.exit(f"{frame}: segments differ, first at {at}: {answer['segments'][at]} in 1970, {mine['segments'][at]} here")
        for name, old_name in ROWS.items():
            if mine["counters"][name] != answer[old_name]:
                sys.exit(f"{frame}: {name} is {answer[old_name]} in 1970, {mine['counters'][name]} here")
        equal += 1
    print(f"{equal} frames equal from seed {seed} on, {refused} refused by both, {clamped} with clamped slopes left out")
    sys.exit(0 if equal else 1)


if __name__ == "__main__":
    main()
