"""Whole-render times of the default scene: the program at its levels of modelling, beside POV-Ray on the same scene.

Run by `scripts/bench --render`. Every renderer makes the same picture of 512 x 512 pixels, one sample each; the fastest of
some runs counts, and user time beside it, over all threads. POV-Ray (package povray) gets one thread, and as many as the
program.
"""

import os
import resource
import shutil
import subprocess
import sys
import tempfile
import time
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
SCENE = ROOT / "scenes" / "default.toml"
POV_SCENE = ROOT / "bench" / "default_scene.pov"
SIZE = 512
LOWEST, HIGHEST = 236, 1076  # metres, of scenes/terrain/jacksboro.tif


def write_teapot(file):
    """The patches of the scene's teapot as POV-Ray's, each of 6 x 6 quads."""
    points, patches = [], []
    for line in (ROOT / "scenes" / "teapot" / "teapot.patches").read_text().splitlines():
        words = line.split("#")[0].split()
        if words[:1] == ["v"]:
            points.append("<" + ", ".join(words[1:]) + ">")
        elif words[:1] == ["b"]:
            patches.append(", ".join(points[int(w) - 1] for w in words[1:]))
    steps = "type 1 flatness 0 u_steps 3 v_steps 3"
    file.write_text("\n".join(f"bicubic_patch {{ {steps} {p} }}" for p in patches) + "\n")


def prepare(folder):
    subprocess.run(["gdal_translate", "-q", "-of", "PNG", "-ot", "UInt16", "-scale", str(LOWEST), str(HIGHEST), "0", "65535",
                    ROOT / "scenes" / "terrain" / "jacksboro.tif", folder / "heights.png"], check=True)
    write_teapot(folder / "teapot.inc")


def timed(command, runs, folder):
    """(seconds, user seconds) of the fastest run."""
    best = None
    for _ in range(runs):
        before, begin = resource.getrusage(resource.RUSAGE_CHILDREN), time.perf_counter()
        run = subprocess.run(command, cwd=folder, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True)
        seconds = time.perf_counter() - begin
        if run.returncode != 0:
            sys.exit(f"{command[0]}: exit status {run.returncode}\n{run.stderr}")
        user = resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime - before.ru_utime
        if best is None or seconds < best[0]:
            best = seconds, user
    return best


def print_table(program):
    if not shutil.which("povray"):
        sys.exit("the package povray is needed")
    threads = os.cpu_count()
    # A program without the RTL has the golden model as its default.
    has_rtl = "=rtl" in subprocess.run([program, "render", "--help"], check=True, stdout=subprocess.PIPE, text=True).stdout
    ours = lambda vsg, pe: [program, "render", SCENE, "-o", "ours.png", "--quiet", "--size", f"{SIZE}x{SIZE}", "--vsg", vsg,
                            "--pe", pe]
    pov = lambda workers: ["povray", f"+I{POV_SCENE}", "+Opov.png", f"+W{SIZE}", f"+H{SIZE}", f"+WT{workers}", "-D", "-A",
                           "-GA", "File_Gamma=1.0", "+L."]
    work = [(f"POV-Ray, {n} thread" + "s" * (n > 1), pov(n), 3) for n in sorted({1, threads})]
    work += [("golden model, macro operations", ours("model", "macro"), 3), ("golden models", ours("model", "model"), 2)]
    if has_rtl:
        work.append(("both RTLs", ours("rtl", "rtl"), 1))
    with tempfile.TemporaryDirectory() as name:
        prepare(Path(name))
        rows = [(what, *timed(command, runs, name)) for what, command, runs in work]
    one = rows[0][1:]
    print(f"| renderer | seconds ({threads} cores) | user seconds | seconds / POV-Ray's | user / POV-Ray's |")
    print("|---|---:|---:|---:|---:|")
    for what, seconds, user in rows:
        print(f"| {what} | {seconds:.2f} | {user:.2f} | {seconds / one[0]:.2f} | {user / one[1]:.2f} |")
