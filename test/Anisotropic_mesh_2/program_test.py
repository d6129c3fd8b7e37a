#!/usr/bin/env python3
# This file is part of Anisotropic_mesh_2.
#
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Author(s)     : the Anisotropic_mesh_2 developers
"""Tests the command-line program: exit status, messages, files.

usage: program_test.py PROGRAM [DATA_DIRECTORY]
"""

import json
import math
import os
import signal
import subprocess
import sys
import tempfile
import xml.etree.ElementTree as ElementTree

STATISTICS = [
    "vertices", "triangles", "ideal_vertices", "edge_length_mean", "edge_length_min", "edge_length_max",
    "edge_length_unit_share", "quality_mean", "quality_min", "quality_min3_mean", "quality_min3_min",
    "energy", "energy_ratio", "iterations", "stop_reason", "gradient_norm", "seconds_mesh", "seconds_optimize"]

SURFACE_STATISTICS = STATISTICS + [
    "distance_mean", "distance_max", "normal_deviation_mean", "normal_deviation_max"]

SQUARE_POLY = """4 2 0 1
1 0 0 1
2 1 0 1
3 1 1 1
4 0 1 1
4 1
1 1 2 1
2 2 3 2
3 3 4 3
4 4 1 4
0
"""

SQUARE_MESH = """MeshVersionFormatted 2
Dimension 2
Vertices
4
0 0 1
1 0 1
1 1 1
0 1 1
Edges
4
1 2 1
2 3 2
3 4 3
4 1 4
End
"""

TRIANGLES_MESH = """MeshVersionFormatted 2
Dimension 2
Vertices
4
0 0 1
1 0 1
1 1 1
0 1 1
Triangles
2
1 2 3 7
1 3 4 7
End
"""

TENSOR_SOL = """MeshVersionFormatted 2
Dimension 2
SolAtVertices
4
1 3
64 0 16
64 0 16
64 0 16
64 0 16
End
"""

SIZE_SOL = """MeshVersionFormatted 2
Dimension 2
SolAtVertices
4
1 1
0.1
0.1
0.2
0.2
End
"""


def mesh_of(points, edges):
    """A Medit file with these points and edges; the edges count from 1."""
    lines = ["MeshVersionFormatted 2", "Dimension 2", "Vertices", str(len(points))]
    lines += [f"{x} {y} 1" for x, y in points]
    lines += ["Edges", str(len(edges))] + [f"{i} {j} 1" for i, j in edges] + ["End", ""]
    return "\n".join(lines)


class Tester:
    def __init__(self, program):
        self.program = os.path.abspath(program)
        self.directory = None
        self.done = self.failed = 0

    def check(self, ok, what):
        self.done += 1
        if not ok:
            self.failed += 1
            print("failed:", what)
        return ok

    def write(self, name, text):
        with open(os.path.join(self.directory, name), "w", encoding="utf-8") as f:
            f.write(text)

    def read(self, name):
        with open(os.path.join(self.directory, name), encoding="utf-8") as f:
            return f.read()

    def files(self):
        return sorted(os.listdir(self.directory))

    def run(self, *arguments):
        return subprocess.run([self.program, *arguments], cwd=self.directory, timeout=120,
                              stdin=subprocess.DEVNULL, capture_output=True, text=True, check=False)

    def succeed(self, *arguments, keys=tuple(STATISTICS)):
        """Runs the program quietly; returns its statistics."""
        result = self.run(*arguments, "--quiet", "--stats", "-")
        what = " ".join(arguments)
        if not self.check(result.returncode == 0 and result.stderr == "",
                          f"{what}: status {result.returncode}, {result.stderr}"):
            return None
        statistics = json.loads(result.stdout)
        self.check(sorted(statistics) == sorted(keys), f"{what}: the keys {list(statistics)}")
        self.check(all(isinstance(v, str) or math.isfinite(v) for v in statistics.values()),
                   f"{what}: {statistics}")
        return statistics

    def refuse(self, words, *arguments):
        """The program stops with status 2, one line that has the words, and no file."""
        self.write("old.mesh", "old")
        before = self.files()
        result = self.run(*arguments, "-o", "old.mesh", "-o", "new.vtu", "--stats", "new.json")
        what = " ".join(arguments)
        self.check(result.returncode == 2, f"{what}: status {result.returncode}")
        line = result.stderr
        self.check(line.endswith("\n") and line.count("\n") == 1 and len(line) > 1, f"{what}: not one line: {line}")
        for word in words:
            self.check(word in line, f"{what}: no '{word}' in {line}")
        self.check(result.stdout == "", f"{what}: printed {result.stdout}")
        self.check(self.files() == before, f"{what}: left {self.files()}")
        self.check(self.read("old.mesh") == "old", f"{what}: touched the old file")


def section(text, keyword):
    """The lines after a keyword and its count in a Medit file."""
    lines = text.split("\n")
    start = lines.index(keyword)
    count = int(lines[start + 1])
    return lines[start + 2:start + 2 + count]


def test_help(t):
    result = t.run("--help")
    t.check(result.returncode == 0 and "--voronoi" in result.stdout, "--help")
    result = t.run("--version")
    t.check(result.returncode == 0 and result.stdout.startswith("anisotropic_mesh_2 "), "--version")


def test_builtin_domains(t):
    for name in ("disc", "square4", "layer10", "parallelogram"):
        s = t.succeed("builtin:" + name)
        if s is None:
            continue
        t.check(0.8 < s["vertices"] / s["ideal_vertices"] < 1.25, f"{name}: {s['vertices']} vertices")
        t.check(s["edge_length_unit_share"] >= 0.99, f"{name}: unit share {s['edge_length_unit_share']}")
        t.check(s["quality_mean"] >= 0.97, f"{name}: quality {s['quality_mean']}")
        t.check(s["energy_ratio"] <= 1.03, f"{name}: energy ratio {s['energy_ratio']}")
    # the sizes of square10 jump within an element, so no mesh of it is good
    s = t.succeed("builtin:square10")
    if s is not None:
        t.check(0.5 < s["vertices"] / s["ideal_vertices"] < 2, f"square10: {s['vertices']} vertices")


def test_surfaces(t):
    for name, characteristic in (("ellipsoid", 2), ("torus", 0), ("paraboloid", 1), ("saddle-sizes", 1)):
        s = t.succeed("builtin:" + name, "--scale", "2", "-o", "a.off", "-o", "a.ply", "-o", "a.svg",
                      "--voronoi", "v.svg", keys=SURFACE_STATISTICS)
        if s is None:
            continue
        least = 0.3 if name == "saddle-sizes" else 0.4 # there sizes vary by a factor within an element
        t.check(s["quality_mean"] >= 0.96 and s["quality_min"] > least, f"{name}: {s['quality_mean']}, {s['quality_min']}")
        lines = t.read("a.off").split("\n\n")[1].splitlines()
        faces = [tuple(map(int, line.split()[1:])) for line in lines[s["vertices"]:]]
        edges = {frozenset(pair) for f in faces for pair in ((f[0], f[1]), (f[1], f[2]), (f[2], f[0]))}
        t.check(len(faces) == s["triangles"], f"{name}: {len(faces)} faces")
        t.check(s["vertices"] - len(edges) + len(faces) == characteristic, f"{name}: Euler characteristic")
        t.check(t.read("a.ply").splitlines()[-1] == lines[-1], f"{name}: .ply")
        for picture, polygons in (("a.svg", s["triangles"]), ("v.svg", s["vertices"])):
            drawn = t.read(picture).count("<path")
            t.check(polygons / 3 < drawn <= 1.5 * polygons, f"{name}: {drawn} polygons in {picture}")
    t.refuse(["builtin:torus", "--scale"], "builtin:torus", "--size", "1")
    t.refuse(["lloyd"], "builtin:torus", "--optimizer", "lloyd")
    t.refuse(["--keep-boundary"], "builtin:torus", "--keep-boundary")
    t.refuse(["--window"], "builtin:torus", "--window", "0,0,1,1")
    for scale, words in (("40", "too large"), ("1e-9", "vertices")):
        result = t.run("builtin:torus", "--scale", scale, "--stats", "-")
        t.check(result.returncode == 2 and words in result.stderr and result.stdout == "",
                f"--scale {scale}: {result.returncode}, {result.stderr}")
    t.refuse([".off, .ply or .svg"], "builtin:torus")
    t.refuse([".ply"], "builtin:disc", "-o", "disc.ply")


def test_outputs(t):
    before = t.files()
    names = ["a.mesh", "a.vtu", "a.off", "a.svg"]
    arguments = [word for name in names for word in ("-o", name)]
    s = t.succeed("builtin:parallelogram", *arguments, "--voronoi", "cells.svg", "--iterations", "5")
    t.check(t.files() == sorted(before + names + ["cells.svg"]), f"the files {t.files()}")
    if s is None:
        return
    medit = t.read("a.mesh")
    t.check(len(section(medit, "Vertices")) == s["vertices"], ".mesh: vertices")
    t.check(len(section(medit, "Triangles")) == s["triangles"], ".mesh: triangles")
    off = t.read("a.off").split()
    t.check(off[0] == "OFF" and int(off[1]) == s["vertices"] and int(off[2]) == s["triangles"], f".off: {off[:4]}")
    with open(os.path.join(t.directory, "a.vtu"), "rb") as f: # its appended data are binary
        vtu = f.read().decode("latin-1")
    t.check(f'NumberOfPoints="{s["vertices"]}"' in vtu and vtu.rstrip().endswith("</VTKFile>"), ".vtu")
    for name in ("a.svg", "cells.svg"):
        root = ElementTree.parse(os.path.join(t.directory, name)).getroot()
        t.check(root.tag.endswith("svg") and len(list(root.iter())) > 2, f"{name}: {root.tag}")

    t.run("builtin:parallelogram", "--optimizer", "none", "-o", "w.svg", "--voronoi", "v.svg",
          "--window=-0.1,0,0.2,0.1")
    for whole, part in (("a.svg", "w.svg"), ("cells.svg", "v.svg")):
        t.check("<svg x=" in t.read(part) and len(t.read(part)) < len(t.read(whole)), f"a window in {part}")
    t.refuse(["--window", "XMIN < XMAX"], "builtin:disc", "-o", "a.svg", "--window", "1,1,0,0")
    for window in ("1,1,0", "1,1,0,x", "0,0,1,1,1", "0;0;1;1", "0,0,inf,1"):
        t.refuse(["--window " + window], "builtin:disc", "-o", "a.svg", "--window", window)

    result = t.run("builtin:parallelogram", "--iterations", "5", "--stats", "s.json")
    t.check(result.returncode == 0 and result.stdout == "" and result.stderr == "", "--stats FILE prints nothing")
    t.check(json.loads(t.read("s.json"))["vertices"] == s["vertices"], "--stats FILE")
    t.run("builtin:parallelogram", "--iterations", "5", "-o", "b.mesh", "--verbose")
    t.check(t.read("b.mesh") == medit, "the same arguments give the same file")
    t.check(t.run("a.mesh", "--h1", "2", "--h2", "0.5", "--quiet").returncode == 0, "what was written can be read")


def test_progress(t):
    few = ("builtin:parallelogram", "--iterations", "2")
    t.check(t.run(*few).stderr == "", "no progress without a terminal")
    verbose = t.run(*few, "--verbose", "-o", "few.mesh")
    t.check(verbose.returncode == 0 and verbose.stderr.count("\n") >= 3, f"progress if asked: {verbose.stderr}")
    t.check(verbose.stdout == "", "progress on standard error only")
    t.check(json.loads(t.run(*few).stdout)["triangles"] > 0, "statistics if no output is asked for")
    t.check(" s left at most" in verbose.stderr, f"the time that remains: {verbose.stderr}")


def test_threads(t):
    meshes = []
    for n in ("1", "2", "8"):
        t.succeed("builtin:square4", "--scale", "0.3", "--iterations", "10", "--threads", n, "-o", f"threads{n}.mesh")
        meshes.append(t.read(f"threads{n}.mesh"))
    t.check(meshes[0] == meshes[1] == meshes[2], "the same mesh with any number of threads")


def test_interrupt(t):
    arguments = ["builtin:square4", "--scale", "0.05", "--optimizer", "lloyd", "--iterations", "1000000",
                 "--tolerance", "0", "--stats", "interrupted.json", "-o", "interrupted.mesh", "--verbose"]
    child = subprocess.Popen([t.program] + arguments, cwd=t.directory, stderr=subprocess.PIPE, text=True)
    while not child.stderr.readline().startswith("iteration 1,"):
        if child.poll() is not None:
            break
    child.send_signal(signal.SIGINT)
    child.communicate(timeout=300)
    t.check(child.returncode == 0, f"an interrupt ends the program in good order: {child.returncode}")
    stats = json.loads(t.read("interrupted.json"))
    t.check(stats["stop_reason"] == "interrupted", f"stopped by {stats['stop_reason']}")
    t.check(len(section(t.read("interrupted.mesh"), "Triangles")) == stats["triangles"], "the mesh is written")


def test_metrics(t):
    t.write("square.poly", SQUARE_POLY)
    t.write("square.mesh", SQUARE_MESH)
    t.write("triangles.mesh", TRIANGLES_MESH)
    t.write("tensor.sol", TENSOR_SOL)
    t.write("size.sol", SIZE_SOL)
    some = ("--iterations", "10")
    sizes = t.succeed("square.poly", "--h1", "0.125", "--h2", "0.25", "-o", "sizes.mesh", *some)
    if sizes is None:
        return
    # powers of two, so that all ways give the same tensor to the last bit
    same_metric = {
        "entries.mesh": ("square.poly", "--m11", "64", "--m22", "16"),
        "formula.mesh": ("square.poly", "--h1", "0.125+0*x", "--h2", "0.25*cos(0*y)", "--theta", "pi-pi"),
        "scaled.mesh": ("square.poly", "--h1", "0.0625", "--h2", "0.125", "--scale", "2")}
    for name, arguments in same_metric.items():
        t.succeed(*arguments, "-o", name, *some)
        t.check(t.read(name) == t.read("sizes.mesh"), f"{name} differs from sizes.mesh")
    other_ways = [("square.mesh", "--h1", "0.125", "--h2", "0.25"), ("triangles.mesh", "--metric", "tensor.sol"),
                  ("square.poly", "--metric", "tensor.sol", "--background", "triangles.mesh"),
                  ("square.poly", "--h1", "0.25", "--h2", "0.125", "--theta", "-pi/2")]
    for arguments in other_ways:
        s = t.succeed(*arguments, *some)
        t.check(s is not None and abs(s["vertices"] - sizes["vertices"]) <= 3, f"{arguments}: {s}")
    graded = t.succeed("triangles.mesh", "--metric", "size.sol", *some)
    fine = t.succeed("square.poly", "--size", "0.1", *some)
    coarse = t.succeed("square.poly", "--size", "min(0.2, 1)", *some)
    if graded is not None and fine is not None and coarse is not None:
        t.check(coarse["vertices"] < graded["vertices"] < fine["vertices"], "a size for each vertex")
    replaced = t.succeed("builtin:disc", "--size", "4", *some)
    t.check(replaced is not None and replaced["vertices"] < 60, "the metric of a built-in domain is replaced")


def test_methods(t):
    t.write("square.poly", SQUARE_POLY)
    domain = ("square.poly", "--size", "0.1")
    none = t.succeed(*domain, "--optimizer", "none")
    lloyd = t.succeed(*domain, "--optimizer", "lloyd", "--iterations", "20", "--tolerance", "0")
    lbfgs = t.succeed(*domain, "--iterations", "20", "--tolerance", "0", "--threads", "2", "--seed", "7")
    lebesgue = t.succeed(*domain, "--measure", "lebesgue", "--iterations", "20")
    if None not in (none, lloyd, lbfgs, lebesgue):
        t.check(none["iterations"] == 0, f"none: {none['iterations']} iterations")
        t.check(0 < lloyd["iterations"] <= 20, f"lloyd: {lloyd['iterations']} iterations")
        t.check(lbfgs["energy"] < none["energy"] and lloyd["energy"] < none["energy"], "the energy falls")
        t.check(lbfgs["energy"] <= 1.001 * lloyd["energy"], "lbfgs is not worse than lloyd")
        t.check(lebesgue["energy"] != lbfgs["energy"], "the measure decides the energy")
    s = t.succeed(*domain, "--optimizer", "lloyd", "--scale", "0.1", "--tolerance", "0",
                  "--iterations", "100000", "--time-limit", "0.2")
    t.check(s is not None and s["seconds_optimize"] < 5, f"--time-limit: {s}")
    s = t.succeed(*domain, "--keep-boundary", "-o", "kept.mesh")
    t.check(s is not None and len(section(t.read("kept.mesh"), "Edges")) == 4, "--keep-boundary")


def test_bad_arguments(t):
    t.write("square.poly", SQUARE_POLY)
    t.write("square.mesh", SQUARE_MESH)
    t.write("tensor.sol", TENSOR_SOL)
    domain = "square.poly"
    t.refuse(["DOMAIN"])
    t.refuse(["square.poly", "--size", "--metric"], domain)
    t.refuse(["--h1", "--h2"], domain, "--h1", "1")
    t.refuse(["--theta", "--h1"], domain, "--theta", "1")
    t.refuse(["--m22", "--m11"], domain, "--m22", "1")
    t.refuse(["--size", "--h1"], domain, "--h1", "1", "--h2", "1", "--size", "1")
    t.refuse(["--metric", "--background"], domain, "--metric", "tensor.sol")
    t.refuse(["--background", "--metric"], domain, "--background", "square.mesh")
    t.refuse(["\"--nonsense\": unknown option"], domain, "--size", "1", "--nonsense", "2000")
    t.refuse(["\"second.poly\": one argument too many"], domain, "second.poly", "--size", "1")
    t.refuse(["--scale", "0"], domain, "--size", "1", "--scale", "0")
    t.refuse(["--scale", "nan"], domain, "--size", "1", "--scale", "nan")
    t.refuse(["--iterations", "-1"], domain, "--size", "1", "--iterations", "-1")
    t.refuse(["--tolerance", "x"], domain, "--size", "1", "--tolerance", "x")
    t.refuse(["--optimizer", "newton"], domain, "--size", "1", "--optimizer", "newton")
    t.refuse(["--measure", "mass"], domain, "--size", "1", "--measure", "mass")
    t.refuse(["--verbose", "--quiet"], domain, "--size", "1", "--verbose", "--quiet")
    t.refuse(["builtin:cube", "disc"], "builtin:cube")
    t.refuse(["square.txt"], "square.txt", "--size", "1")
    t.refuse(["a.xyz", ".vtu"], domain, "--size", "1", "-o", "a.xyz")
    t.refuse(["a.png", ".svg"], domain, "--size", "1", "--voronoi", "a.png")
    t.refuse(["--size", "x+*2", "position 3"], domain, "--size", "x+*2")
    t.refuse(["--h2", "sin(x", "position"], domain, "--h1", "1", "--h2", "sin(x")
    t.refuse(["--theta", "z", "position 3"], domain, "--h1", "1", "--h2", "1", "--theta", "x+z")
    t.refuse(["--size", "x=1", "position 2"], domain, "--size", "x=1")
    t.refuse(["--size"], domain, "--size", "")


def test_bad_metrics(t):
    t.write("square.poly", SQUARE_POLY)
    t.write("square.mesh", SQUARE_MESH)
    t.write("triangles.mesh", TRIANGLES_MESH)
    domain = "square.poly"
    t.refuse(["--size", "0"], domain, "--size", "0")
    t.refuse(["--h2", "0.5"], domain, "--h1", "0.2", "--h2", "x-0.5")
    t.refuse(["--size", "inf"], domain, "--size", "1/0")
    t.refuse(["--size", "nan"], domain, "--size", "sqrt(-1)")
    t.refuse(["--m11", "-1"], domain, "--m11", "-1", "--m22", "1")
    t.refuse(["--m12", "2"], domain, "--m11", "1", "--m12", "2", "--m22", "1")
    t.refuse(["--size", "vertices", "limit"], domain, "--size", "1e-6")
    t.refuse(["--size", "vertices", "limit"], domain, "--size", "1", "--scale", "1e-9")
    t.refuse(["missing.sol"], "square.mesh", "--metric", "missing.sol")
    for name, old, new in (("negative", "64 0 16", "64 0 -16"), ("nan", "64 0 16", "64 nan 16"),
                           ("infinite", "64 0 16", "inf 0 16"), ("short", "64 0 16\nEnd\n", ""),
                           ("three", "\n4\n", "\n3\n")):
        t.write(name + ".sol", TENSOR_SOL.replace(old, new, 1))
        t.refuse([name + ".sol"], "triangles.mesh", "--metric", name + ".sol")
    t.write("tensor.sol", TENSOR_SOL)
    t.refuse(["square.mesh"], domain, "--metric", "tensor.sol", "--background", "square.mesh")
    t.refuse(["missing.mesh"], domain, "--metric", "tensor.sol", "--background", "missing.mesh")


def test_bad_domains(t):
    corners = [(0, 0), (1, 0), (1, 1), (0, 1)]
    loop = [(1, 2), (2, 3), (3, 4), (4, 1)]
    bad = {
        "truncated.mesh": SQUARE_MESH[:SQUARE_MESH.index("3 4 3")],
        "short.mesh": SQUARE_MESH[:SQUARE_MESH.index("1 1 1")],
        "nothing.mesh": "",
        "text.mesh": "this is no mesh\n",
        "index.mesh": SQUARE_MESH.replace("3 4 3", "3 9 3"),
        "count.poly": SQUARE_POLY.replace("4 2 0 1", "5 2 0 1"),
        "edges.poly": SQUARE_POLY.replace("\n4 1\n", "\n7 1\n"),
        "text.poly": SQUARE_POLY.replace("3 1 1 1", "3 one 1 1"),
        "nan.mesh": SQUARE_MESH.replace("1 1 1", "nan 1 1", 1),
        "nan.poly": SQUARE_POLY.replace("3 1 1 1", "3 nan 1 1"),
        "infinite.poly": SQUARE_POLY.replace("3 1 1 1", "3 1 inf 1"),
        "huge.poly": SQUARE_POLY.replace("3 1 1 1", "3 1 1e999 1"),
        "crossing.mesh": mesh_of([(0, 0), (1, 1), (1, 0), (0, 1)], loop),
        "crossing.poly": SQUARE_POLY.replace("2 1 0 1", "2 1 1 1").replace("3 1 1 1", "3 1 0 1"),
        "touching.mesh": mesh_of([(0, 0), (2, 0), (2, 2), (1, 0), (0, 2)], [(1, 2), (2, 3), (3, 4), (4, 5), (5, 1)]),
        "open.mesh": mesh_of(corners, loop[:3]),
        "open.poly": SQUARE_POLY.replace("\n4 1\n", "\n3 1\n").replace("4 4 1 4\n", ""),
        "duplicate.mesh": mesh_of(corners + [(1, 1)], loop[:2] + [(5, 4), (4, 1)]),
        "duplicate.poly": SQUARE_POLY.replace("4 0 1 1", "4 1 1 1")}
    for name, text in bad.items():
        t.write(name, text)
        t.refuse([name], name, "--size", "0.5")
    t.refuse(["missing.mesh"], "missing.mesh", "--size", "0.5")
    t.refuse(["missing.poly"], "missing.poly", "--size", "0.5")


def test_unwritable_outputs(t):
    os.mkdir(os.path.join(t.directory, "directory.mesh"))
    t.refuse(["nowhere/a.mesh"], "builtin:disc", "-o", "nowhere/a.mesh")
    t.refuse(["directory.mesh"], "builtin:disc", "-o", "directory.mesh")
    t.refuse(["nowhere/a.svg"], "builtin:disc", "--voronoi", "nowhere/a.svg")
    before = t.files()
    result = t.run("builtin:disc", "-o", "a.mesh", "--stats", "nowhere/s.json")
    t.check(result.returncode == 2 and "nowhere/s.json" in result.stderr, f"--stats: {result.stderr}")
    t.check(t.files() == before, f"--stats: left {t.files()}")
    if os.path.exists("/dev/full"):
        result = t.run("builtin:parallelogram", "--iterations", "1", "--stats", "/dev/full")
        t.check(result.returncode == 1 and result.stderr.count("\n") == 1, f"a full device: {result}")


def main():
    t = Tester(sys.argv[1])
    tests = [f for name, f in globals().items() if name.startswith("test_")]
    for test in tests:
        with tempfile.TemporaryDirectory() as directory:
            t.directory = directory
            test(t)
    print(f"{t.done} checks, {t.failed} failed")
    return 0 if t.done > 0 and t.failed == 0 else 1


if __name__ == "__main__":
    sys.exit(main())
