# This file is part of Anisotropic_mesh_2.
#
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Author(s)     : the Anisotropic_mesh_2 developers
"""The program, its peers and the judge, each as a function that runs it once."""

import collections
import json
import math
import os
import subprocess
import sys

import cases

NAMES = ["ours", "bamg", "gmsh", "mmg2d"]

RUN_MEASURED = os.path.join(os.path.dirname(os.path.abspath(__file__)), "run_measured.py")


class Failure(Exception):
    """What went wrong, in one line."""


class Cost(collections.namedtuple("Cost", "cpu_seconds wall_seconds peak_bytes")):
    def then(self, other):
        """The cost of two runs, one after the other."""
        return Cost(self.cpu_seconds + other.cpu_seconds, self.wall_seconds + other.wall_seconds,
                    max(self.peak_bytes, other.peak_bytes))


class Bench:
    """Where the programs are, how long they may take, and a folder for their files."""

    def __init__(self, program, judge, directory, timeout):
        self.program = program
        self.judge = judge
        self.directory = directory
        self.timeout = timeout

    def path(self, name):
        return os.path.join(self.directory, name)

    def run(self, command, output=None):
        """Runs the command, which must write the output; returns its cost."""
        if output is not None and os.path.exists(output):
            os.remove(output)
        result = subprocess.run([sys.executable, "-I", "-S", RUN_MEASURED, str(self.timeout), *command],
                                cwd=self.directory, stdin=subprocess.DEVNULL, capture_output=True,
                                encoding="utf-8", errors="replace", check=False)
        if result.returncode != 0:
            raise Failure(f"cannot be run: {last_line(result.stderr)}")
        report = json.loads(result.stdout)
        status = report.pop("exit_status")
        if status is None:
            raise Failure(f"not done after {self.timeout:g} s")
        if status != 0:
            how = f"signal {-status}" if status < 0 else f"exit status {status}"
            raise Failure(f"{how}: {last_line(result.stderr)}")
        if output is not None and not os.path.exists(output):
            raise Failure("wrote no mesh")
        return Cost(**report)


def last_line(text):
    lines = [line.strip() for line in text.splitlines() if line.strip()]
    return lines[-1] if lines else "no message"


# ------------------------------------------------------------------ the package

def domain_arguments(bench, case):
    """Domain and metric for the program."""
    if case.builtin is not None:
        return ["builtin:" + case.builtin, "--scale", str(case.scale)]
    path = bench.path(case.name + ".domain.mesh")
    cases.write_mesh(path, cases.outline(case.corners))
    return [path, *case.size_arguments(), "--scale", str(case.scale)]


def mesh_by_program(bench, case, result, *options):
    return bench.run([bench.program, *domain_arguments(bench, case), "--quiet", "-o", result, *options], result)


def judgement(bench, mesh, arguments):
    """The package's statistics of the mesh; the arguments give the metric."""
    try:
        result = subprocess.run([bench.judge, mesh, *arguments], stdin=subprocess.DEVNULL, capture_output=True,
                                encoding="utf-8", timeout=bench.timeout, check=False)
    except subprocess.TimeoutExpired as e:
        raise Failure(f"not judged after {bench.timeout:g} s") from e
    if result.returncode != 0:
        raise Failure(last_line(result.stderr))
    return json.loads(result.stdout)


def judge(bench, case, mesh):
    """The statistics of a mesh of the whole domain."""
    statistics = judgement(bench, mesh, domain_arguments(bench, case))
    share = statistics["area"] / case.area()
    if abs(share - 1) > case.area_tolerance():
        raise Failure(f"covers {100 * share:.3f} % of the domain")
    return statistics


def check_metric(bench, case):
    """Fails unless the program's metric and that of the peers are the same on scattered triangles."""
    path = bench.path(case.name + ".check.mesh")
    cases.write_mesh(path, cases.scattered_triangles(case.corners, 30, 1e-3 * case.diameter()))
    entries = zip(("--m11", "--m12", "--m22"), case.tensor_formulas())
    ours = judgement(bench, path, domain_arguments(bench, case))
    theirs = judgement(bench, path, ["builtin:disc", *(word for entry in entries for word in entry)])
    for key, value in ours.items():
        if not math.isclose(value, theirs[key], rel_tol=1e-6):
            raise Failure(f"{case.name}: {key} of the check is {value} for the program and {theirs[key]} for its peers")


# ------------------------------------------------------------------ gmsh

def write_geometry(file, case):
    """The domain in the language of gmsh."""
    corners = case.corners if case.radius is None else cases.circle(case.radius, 4)
    numbers = range(1, len(corners) + 1)
    for i, (x, y) in zip(numbers, corners):
        file.write(f"Point({i}) = {{{x!r}, {y!r}, 0}};\n")
    if case.radius is not None:
        file.write(f"Point({len(corners) + 1}) = {{0, 0, 0}};\n")
    for i in numbers:
        j = i % len(corners) + 1
        file.write(f"Line({i}) = {{{i}, {j}}};\n" if case.radius is None
                   else f"Circle({i}) = {{{i}, {len(corners) + 1}, {j}}};\n")
    file.write(f"Curve Loop(1) = {{{', '.join(map(str, numbers))}}};\nPlane Surface(1) = {{1}};\n")
    file.write("Mesh.MeshSizeFromPoints = 0;\nMesh.MeshSizeExtendFromBoundary = 0;\n")


def run_gmsh(bench, geometry, result):
    return bench.run(["gmsh", "-2", geometry, "-v", "1", "-format", "mesh", "-o", result], result)


def mesh_by_gmsh(bench, case, result):
    geometry = bench.path("gmsh.geo")
    with open(geometry, "w", encoding="utf-8") as file:
        write_geometry(file, case)
        file.write("Field[1] = MathEvalAniso;\nBackground Field = 1;\n")
        for entry, formula in zip(("m11", "m12", "m22"), case.tensor_formulas()):
            file.write(f'Field[1].{entry} = "{formula}";\n')
        file.write('Field[1].m13 = "0";\nField[1].m23 = "0";\nField[1].m33 = "1";\n')
        file.write("Mesh.Algorithm = 7;\nMesh.SmoothRatio = 1e10;\nMesh.AnisoMax = 1e10;\n")
    return run_gmsh(bench, geometry, result)


# ------------------------------------------------------------------ meshers that adapt a mesh

MAXIMUM_START = 60000


def start_mesh(bench, case, ideal_vertices):
    """A uniform mesh, finer than the result if that is small; made once."""
    path = bench.path(case.name + ".start.mesh")
    if not os.path.exists(path):
        vertices = min(max(4 * ideal_vertices, 4000), MAXIMUM_START)
        size = math.sqrt(2 / math.sqrt(3) * case.area() / vertices)
        geometry = bench.path("start.geo")
        with open(geometry, "w", encoding="utf-8") as file:
            write_geometry(file, case)
            file.write(f"Mesh.Algorithm = 5;\nMesh.MeshSizeMin = {size!r};\nMesh.MeshSizeMax = {size!r};\n")
        try:
            run_gmsh(bench, geometry, path)
        except Failure as e:
            raise Failure(f"no mesh to start from: gmsh: {e}") from e
    return read_result(path)


def read_result(path):
    try:
        return cases.read_mesh(path)
    except (ValueError, LookupError, StopIteration) as e:
        raise Failure("wrote no mesh that can be read") from e


def number_of_passes(ideal_vertices):
    """The larger the mesh, the fewer passes are worth their time."""
    return 4 if ideal_vertices < 5e4 else 3 if ideal_vertices < 5e5 else 2


def adapt(bench, case, result, ideal_vertices, metric_name, header, command):
    """Adapts the start mesh again and again; the metric is evaluated anew at the vertices of each mesh.

    Between passes everything is dropped but vertices, edges and triangles: BAMG
    does not read back the relations to a geometry that it writes.
    """
    mesh = start_mesh(bench, case, ideal_vertices)
    before, metric = bench.path("before.mesh"), bench.path(metric_name)
    cost = Cost(0, 0, 0)
    for _ in range(number_of_passes(ideal_vertices)):
        cases.write_mesh(before, mesh)
        cases.write_tensors(metric, header.format(len(mesh.points)), (case.tensor_at(x, y) for x, y in mesh.points))
        cost = cost.then(bench.run(command(before, metric, result), result))
        mesh = read_result(result)
    cases.write_mesh(result, mesh)
    return cost


def mesh_by_bamg(bench, case, result, ideal_vertices):
    limit = str(int(20 * ideal_vertices + 1e5))

    def command(before, metric, after):
        return ["bamg", "-b", before, "-M", metric, "-o", after, "-nbv", limit, "-v", "0"]
    return adapt(bench, case, result, ideal_vertices, "before.mtr", "{} 3\n", command)


def mesh_by_mmg2d(bench, case, result, ideal_vertices):
    d = case.diameter()
    options = ["-v", "0", "-hgrad", "-1", "-hausd", f"{10 * d:g}", "-hmin", f"{1e-7 * d:g}", "-hmax", f"{10 * d:g}"]

    def command(before, metric, after):
        return [os.environ["MMG2D"], "-in", before, "-sol", metric, "-out", after, *options]
    header = "MeshVersionFormatted 2\nDimension 2\nSolAtVertices\n{}\n1 3\n"
    return adapt(bench, case, result, ideal_vertices, "before.sol", header, command)
