#!/usr/bin/env python3
# This file is part of Anisotropic_mesh_2.
#
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Author(s)     : the Anisotropic_mesh_2 developers
"""Tests judge_mesh, compare_with_peers.py and cost_against_size.py; needs none of the peers.

usage: comparison_test.py PROGRAM JUDGE
"""

import json
import math
import os
import subprocess
import sys
import tempfile

import cases
import meshers

HERE = os.path.dirname(os.path.abspath(__file__))
SQUARE = [(0, 0), (1, 0), (1, 1), (0, 1)]
INTEGRALS = ["ideal_vertices", "energy", "energy_ratio"]   # known up to their tolerance

# Stand in for the peers: one has a mesh ready, one gives back what it gets, one never ends.
FAKES = {
    "gmsh": "shutil.copy(os.environ['READY_MESH'], sys.argv[sys.argv.index('-o') + 1])",
    "bamg": "shutil.copy(sys.argv[sys.argv.index('-b') + 1], sys.argv[sys.argv.index('-o') + 1])",
    "mmg2d": "time.sleep(1000)"}


class Tester:
    def __init__(self, program, judge, directory):
        self.bench = meshers.Bench(program, judge, directory, 60)
        self.done = self.failed = 0

    def check(self, ok, what):
        self.done += 1
        if not ok:
            self.failed += 1
            print("failed:", what)

    def fails(self, words, what, function, *arguments):
        try:
            function(*arguments)
        except meshers.Failure as e:
            self.check(words in str(e), f"{what}: no '{words}' in {e}")
        else:
            self.check(False, f"{what}: no failure")

    def judged(self, points, triangles):
        path = self.bench.path("judged.mesh")
        cases.write_mesh(path, cases.Triangle_mesh(points, [], triangles))
        return meshers.judgement(self.bench, path, ["builtin:disc", "--size", "1"])


def test_own_statistics(t):
    """Of a mesh that the program wrote, the judge says what the program said."""
    for name in ("disc", "square4"):
        mesh, file = t.bench.path("own.mesh"), t.bench.path("own.json")
        domain = ["builtin:" + name, "--scale", "1.5"]
        t.bench.run([t.bench.program, *domain, "--iterations", "3", "-o", mesh, "--stats", file], mesh)
        with open(file, encoding="utf-8") as f:
            own = json.load(f)
        judged = meshers.judgement(t.bench, mesh, domain)
        t.check(set(judged) - set(own) == {"area"}, f"{name}: the keys {list(judged)}")
        for key in set(judged) & set(own):
            tolerance = 1e-4 if key in INTEGRALS else 1e-12
            t.check(math.isclose(judged[key], own[key], rel_tol=tolerance), f"{name}, {key}: {judged[key]}, {own[key]}")


def test_meshes(t):
    """Meshes that others write in their own ways."""
    two = [(0, 1, 2), (0, 2, 3)]
    t.check(t.judged(SQUARE, two)["area"] == 1, "a square")
    t.check(t.judged(SQUARE, [(a, c, b) for a, b, c in two])["triangles"] == 2, "all clockwise")
    unused = t.judged([(0.5, 0.2), *SQUARE], [(1, 2, 3), (1, 3, 4)])
    t.check((unused["vertices"], unused["triangles"]) == (4, 2), f"a point that no triangle uses: {unused}")
    frame = SQUARE + [(0.25 + x / 2, 0.25 + y / 2) for x, y in SQUARE]
    sides = [(i, (i + 1) % 4) for i in range(4)]
    ring = [(i, j, j + 4) for i, j in sides] + [(i, j + 4, i + 4) for i, j in sides]
    hole = t.judged(frame, ring)
    t.check((hole["triangles"], hole["area"]) == (8, 0.75), f"a hole: {hole}")
    not_delaunay = t.judged([(0, 0), (9, -1), (10, 0), (9, 1)], [(0, 1, 2), (0, 2, 3)])
    t.check(not_delaunay["edge_length_max"] == 10, f"the longer diagonal: {not_delaunay}")


def test_no_meshes(t):
    for words, points, triangles in [
            ("no triangles", SQUARE, []),
            ("turned over", SQUARE, [(0, 1, 2), (0, 3, 2)]),
            ("no area", [(0, 0), (1, 0), (2, 0)], [(0, 1, 2)]),
            ("edges cross", SQUARE + [(2, 0.5), (0.4, 0.6)], [(0, 1, 2), (0, 2, 3), (1, 4, 5)]),
            ("more than two triangles", SQUARE + [(2, 0.1)], [(0, 1, 2), (0, 2, 3), (0, 4, 2)]),
            ("same point", SQUARE + [(0, 0)], [(0, 1, 2), (4, 2, 3)]),
            ("overlap", [(0, 0), (9, 0), (0, 9), (1, 1), (2, 1), (1, 2)], [(0, 1, 2), (3, 4, 5)]),
            ("vertices in edges", SQUARE + [(0.5, 0.5)], [(0, 1, 2), (0, 4, 3), (4, 2, 3)])]:
        t.fails(words, words, t.judged, points, triangles)


def test_metrics(t):
    for case in cases.all_cases():
        meshers.check_metric(t.bench, case)
    wrong = cases.Case("wrong", cases.rectangle(4), "0.031+x/4", "0.032+y/4", builtin="square4")
    t.fails("of the check is", "a metric that is another one", meshers.check_metric, t.bench, wrong)


def test_failures(t):
    for words, script in [("signal 11", "kill -SEGV $$"), ("exit status 3: why", "echo why; exit 3"),
                          ("wrote no mesh", "true")]:
        t.fails(words, script, t.bench.run, ["sh", "-c", script], t.bench.path("nothing.mesh"))
    garbage = t.bench.path("garbage.mesh")
    with open(garbage, "w", encoding="utf-8") as file:
        file.write("Dimension 2 Vertices 3 0 0")
    t.fails("can be read", "half a mesh", meshers.read_result, garbage)
    t.fails("cannot be run", "no such program", t.bench.run, ["/no/such/program"])


def environment_with_fakes(t):
    """A path with nothing but the fakes, whose mesh is one of square4."""
    ready = t.bench.path("ready.mesh")
    t.bench.run([t.bench.program, "builtin:square4", "--size", "0.5", "-o", ready])
    folder = t.bench.path("fakes")
    os.mkdir(folder)
    for name, body in FAKES.items():
        path = os.path.join(folder, name)
        with open(path, "w", encoding="utf-8") as file:
            file.write(f"#!{sys.executable}\nimport os, shutil, sys, time\n{body}\n")
        os.chmod(path, 0o755)
    return dict(os.environ, PATH=folder, MMG2D=os.path.join(folder, "mmg2d"), READY_MESH=ready)


def test_comparison(t):
    output = t.bench.path("table.md")
    subprocess.run([sys.executable, os.path.join(HERE, "compare_with_peers.py"), "--program", t.bench.program,
                    "--judge", t.bench.judge, "--cases", "square4,disc", "--repeat", "1", "--threads", "1,2",
                    "--timeout", "2", "--output", output],
                   env=environment_with_fakes(t), stderr=subprocess.DEVNULL, timeout=120, check=True)
    with open(t.bench.path("table.json"), encoding="utf-8") as file:
        rows = {(row["case"], row["mesher"]): row for row in json.load(file)}
    t.check(len(rows) == 10, f"the rows {list(rows)}")
    for case in ("disc", "square4"):
        for mesher in ("ours", "ours, 2 threads"):
            row = rows[case, mesher]
            t.check(row["quality_mean"] > 0.97 and row["peak_bytes"] > 1e6, f"{case}, {mesher}: {row}")
        t.check("not done after 2 s" in rows[case, "mmg2d"]["failure"], f"mmg2d: {rows[case, 'mmg2d']}")
    for mesher in ("bamg", "gmsh"):
        t.check("failure" not in rows["square4", mesher], f"{mesher}: {rows['square4', mesher]}")
        t.check("covers 5.093 %" in rows["disc", mesher]["failure"], f"{mesher}: {rows['disc', mesher]}")
    with open(output, encoding="utf-8") as file:
        t.check(sum(line.startswith("| ") for line in file) == 12, "lines of the table")


def test_cost_against_size(t):
    result = subprocess.run([sys.executable, os.path.join(HERE, "cost_against_size.py"), "--program",
                             t.bench.program, "--sizes", "200,400", "--iterations", "2"],
                            capture_output=True, text=True, timeout=120, check=True)
    vertices = [int(line.split("|")[2]) for line in result.stdout.splitlines()[2:]]
    t.check(len(vertices) == 2 and 200 < vertices[0] < 300 and 400 < vertices[1] < 500, f"sizes {vertices}")


def main():
    with tempfile.TemporaryDirectory() as directory:
        t = Tester(os.path.abspath(sys.argv[1]), os.path.abspath(sys.argv[2]), directory)
        for test in (test_own_statistics, test_meshes, test_no_meshes, test_metrics, test_failures,
                     test_comparison, test_cost_against_size):
            test(t)
    print(f"{t.done} checks, {t.failed} failed")
    return 1 if t.failed or not t.done else 0


if __name__ == "__main__":
    sys.exit(main())
