#!/usr/bin/env python3
# This file is part of Anisotropic_mesh_2.
#
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Author(s)     : the Anisotropic_mesh_2 developers
"""Runs the program, and bamg if asked, on square4 at several sizes and prints what a vertex costs.

Seconds of the program are wall time, from its statistics; those of bamg
are CPU time of all passes, with reading and writing.
"""

import argparse
import json
import os
import sys
import tempfile

import cases
import meshers


def program_line(bench, case, iterations, threads):
    statistics = bench.path("statistics.json")
    cost = meshers.mesh_by_program(bench, case, bench.path("result.mesh"), "--stats", statistics,
                                   "--iterations", str(iterations), "--tolerance", "0", "--threads", str(threads))
    with open(statistics, encoding="utf-8") as file:
        s = json.load(file)
    n, mesh, optimize = s["vertices"], s["seconds_mesh"], s["seconds_optimize"]
    return (f"| ours | {n} | {mesh:.3g} | {optimize:.3g} | {1e6 * mesh / n:.2f} "
            f"| {1e6 * optimize / n / max(s['iterations'], 1):.2f} | {1e6 * (mesh + optimize) / n:.1f} "
            f"| {cost.peak_bytes / n:.0f} |")


def bamg_line(bench, case):
    result = bench.path("result.mesh")
    cost = meshers.mesh_by_bamg(bench, case, result, case.ideal_vertices())
    n = len(cases.read_mesh(result).points)
    return (f"| bamg | {n} | {cost.cpu_seconds:.3g} | | {1e6 * cost.cpu_seconds / n:.2f} "
            f"| | {1e6 * cost.cpu_seconds / n:.1f} | {cost.peak_bytes / n:.0f} |")


def parsed_arguments():
    def sizes(text):
        return [int(float(n)) for n in text.split(",")]
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--program", required=True, type=os.path.abspath, help="anisotropic_mesh_2")
    parser.add_argument("--sizes", type=sizes, default=[10**3, 10**4, 10**5, 10**6],
                        help="numbers of vertices; default 1e3,1e4,1e5,1e6")
    parser.add_argument("--iterations", type=int, default=30, help="of the optimizer; default 30")
    parser.add_argument("--threads", type=int, default=1, help="of the program; default 1")
    parser.add_argument("--bamg", action="store_true", help="bamg too")
    parser.add_argument("--timeout", type=float, default=1800, help="seconds for each run; default 1800")
    return parser.parse_args()


def main():
    arguments = parsed_arguments()
    print("| mesher | vertices | mesh s | optimize s | mesh us/vertex | us/vertex/iteration | all us/vertex "
          "| peak bytes/vertex |")
    print("| --- |" + " ---: |" * 7)
    with tempfile.TemporaryDirectory() as directory:
        bench = meshers.Bench(arguments.program, None, directory, arguments.timeout)
        for size in arguments.sizes:
            case = cases.square4(f"square4-{size}", cases.scale_of_square4(size))
            print(program_line(bench, case, arguments.iterations, arguments.threads), flush=True)
            if arguments.bamg:
                print(bamg_line(bench, case), flush=True)


if __name__ == "__main__":
    try:
        main()
    except meshers.Failure as e:
        sys.exit(f"cost_against_size.py: {e}")
