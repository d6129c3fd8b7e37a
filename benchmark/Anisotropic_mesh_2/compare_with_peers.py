#!/usr/bin/env python3
# This file is part of Anisotropic_mesh_2.
#
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Author(s)     : the Anisotropic_mesh_2 developers
"""Runs the program and its peers on the same cases and writes one table.

Peers are BAMG (bamg, in Debian's package rheolef), the BAMG in gmsh, and Mmg2d
if the environment variable MMG2D names its binary. All meshes are judged by the
statistics of the package. bamg and Mmg2d adapt a uniform mesh in several
passes; their costs are those of the passes alone, without the first mesh and
the evaluation of the metric.
"""

import argparse
import json
import os
import statistics
import sys
import tempfile

import cases
import meshers

ROW_COLUMNS = [  # head, key, format
    ("vertices", "vertices", "{}"),
    ("quality mean", "quality_mean", "{:.3f}"),
    ("quality min", "quality_min", "{:.3f}"),
    ("unit share", "edge_length_unit_share", "{:.4f}"),
    ("energy ratio", "energy_ratio", "{:.3f}"),
    ("CPU s", "cpu_seconds", "{:.3g}"),
    ("wall s", "wall_seconds", "{:.3g}"),
    ("peak MB", "peak_megabytes", "{:.0f}"),
    ("bytes/vertex", "bytes_per_vertex", "{:.0f}")]

NOTE = """
Medians of {repeat} runs; CPU is user time. Quality, unit share and energy ratio are those of
`anisotropic_mesh_statistics_2()`. bamg and mmg2d adapt a uniform mesh of up to {start} vertices in 4
passes (3 from 50 000 vertices on, 2 from 500 000); neither that mesh nor the evaluation of the metric
between the passes is counted. The other meshers start from the domain and evaluate the metric themselves.
The peak is at least 10 MB, those of the process that measures. gmsh 4.8 mistakes the axes of tensors
unless they are at multiples of 45 degrees, so there its rows of polar-2 mean nothing.
"""


def chosen_meshers(bench, peers, threads):
    """Pairs of a name and a function of a case, the path for the mesh and the ideal number of vertices."""
    chosen = []
    for name in peers:
        if name == "ours":
            chosen += [(f"ours, {n} threads" if n > 1 else "ours",
                        lambda case, path, ideal, n=n:
                        meshers.mesh_by_program(bench, case, path, "--threads", str(n))) for n in threads]
        elif name == "gmsh":
            chosen.append((name, lambda case, path, ideal: meshers.mesh_by_gmsh(bench, case, path)))
        elif name == "bamg":
            chosen.append((name, lambda case, path, ideal: meshers.mesh_by_bamg(bench, case, path, ideal)))
        elif name == "mmg2d" and "MMG2D" in os.environ:
            chosen.append((name, lambda case, path, ideal: meshers.mesh_by_mmg2d(bench, case, path, ideal)))
    return chosen


def row_of(bench, case, name, mesh, ideal_vertices, repeat):
    """What the table says about one mesher on one case, or why it says nothing."""
    row = {"case": case.name, "mesher": name}
    path = bench.path("result.mesh")
    try:
        costs = [mesh(case, path, ideal_vertices) for _ in range(repeat)]
        row.update(meshers.judge(bench, case, path))
    except meshers.Failure as e:
        row["failure"] = str(e)
        return row
    cost = meshers.Cost(*map(statistics.median, zip(*costs)))
    row.update(cost._asdict(), peak_megabytes=cost.peak_bytes / 1e6,
               bytes_per_vertex=cost.peak_bytes / row["vertices"])
    return row


def rows_of(bench, case, chosen, repeat):
    meshers.check_metric(bench, case)
    ideal_vertices = case.ideal_vertices()
    for name, mesh in chosen:
        row = row_of(bench, case, name, mesh, ideal_vertices, repeat)
        print(f"{case.name}, {name}:", row.get("failure", "done"), file=sys.stderr, flush=True)
        yield row


def line_of(row):
    if "failure" in row:
        cells = ["failed: " + row["failure"].replace("|", "\\|")] + [""] * (len(ROW_COLUMNS) - 1)
    else:
        cells = [form.format(row[key]) for _, key, form in ROW_COLUMNS]
    return "| " + " | ".join([row["case"], row["mesher"], *cells]) + " |\n"


def write_tables(output, rows, repeat):
    """Markdown, and JSON beside it."""
    heads = ["case", "mesher"] + [head for head, _, _ in ROW_COLUMNS]
    with open(output, "w", encoding="utf-8") as file:
        file.write("| " + " | ".join(heads) + " |\n")
        file.write("| --- | --- |" + " ---: |" * len(ROW_COLUMNS) + "\n")
        file.writelines(map(line_of, rows))
        file.write(NOTE.format(repeat=repeat, start=meshers.MAXIMUM_START))
    with open(os.path.splitext(output)[0] + ".json", "w", encoding="utf-8") as file:
        json.dump(rows, file, indent=2)
        file.write("\n")


def parsed_arguments():
    def names(text):
        return text.split(",")

    def numbers(text):
        return [int(n) for n in text.split(",")]
    known = [case.name for case in cases.all_cases()]
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--program", required=True, type=os.path.abspath, help="anisotropic_mesh_2")
    parser.add_argument("--judge", required=True, type=os.path.abspath, help="judge_mesh")
    parser.add_argument("--cases", type=names, default=known, help="default: " + ",".join(known))
    parser.add_argument("--peers", type=names, default=meshers.NAMES, help="default: " + ",".join(meshers.NAMES))
    parser.add_argument("--threads", type=numbers, default=[1], help="of the program: 1, or 1,2; default 1")
    parser.add_argument("--repeat", type=int, default=3, help="runs of each mesher; default 3")
    parser.add_argument("--timeout", type=float, default=600, help="seconds for each run; default 600")
    parser.add_argument("--output", default="peers.md", help="the table; default peers.md, and peers.json")
    arguments = parser.parse_args()
    for name in set(arguments.cases) - set(known):
        parser.error(f"unknown case {name}; known are {', '.join(known)}")
    for name in set(arguments.peers) - set(meshers.NAMES):
        parser.error(f"unknown mesher {name}; known are {', '.join(meshers.NAMES)}")
    return arguments


def main():
    arguments = parsed_arguments()
    rows = []
    with tempfile.TemporaryDirectory() as directory:
        bench = meshers.Bench(arguments.program, arguments.judge, directory, arguments.timeout)
        chosen = chosen_meshers(bench, arguments.peers, arguments.threads)
        for case in cases.all_cases():
            if case.name in arguments.cases:
                rows += rows_of(bench, case, chosen, arguments.repeat)
                write_tables(arguments.output, rows, arguments.repeat)


if __name__ == "__main__":
    try:
        main()
    except meshers.Failure as e:
        sys.exit(f"compare_with_peers.py: {e}")
