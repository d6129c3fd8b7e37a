#!/usr/bin/env python3
# This file is part of Anisotropic_mesh_2.
#
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Author(s)     : the Anisotropic_mesh_2 developers
"""Makes the figures and tables of the manual anew, by running the examples.

SOURCES, at the end, tells where each file comes from. All but exactness.md, which
holds times, are the same in every run. The times of cost_against_size.svg are not
measured here. Plots need matplotlib.
"""

import argparse
import collections
import pathlib
import shutil
import subprocess
import sys
import tempfile

import matplotlib
matplotlib.use("svg")
import matplotlib.pyplot as plt

MANUAL = pathlib.Path(__file__).resolve().parent
PROJECT = MANUAL.parents[1]
sys.path.insert(0, str(PROJECT / "scripts"))
import layers

Run = collections.namedtuple("Run", "output folder")  # what a command has printed, and where it has written

# ------------------------------------------------------------------ style

# A kind of mesh or a method looks the same in all plots; the tones differ in print without colours too.
BAD, MIDDLING, GOOD = "#999999", "#d55e00", "#00429d"
STYLES = {
    "uniform": dict(color=BAD, marker="o", linestyle="--", label="uniform"),
    "graded": dict(color=MIDDLING, marker="s", linestyle="-.", label="graded isotropic"),
    "anisotropic": dict(color=GOOD, marker="^", linestyle="-", label="anisotropic"),
    "Lloyd": dict(color=MIDDLING, linestyle="--", label="Lloyd"),
    "quasi-Newton": dict(color=GOOD, linestyle="-", label="quasi-Newton"),
    "unit mesh": dict(color=BAD, marker="o", linestyle="--", label="unit mesh"),
    "optimizer": dict(color=GOOD, marker="^", linestyle="-", label="an iteration of the optimizer")}

plt.rcParams.update({
    "svg.hashsalt": "Anisotropic_mesh_2", "svg.fonttype": "path", "font.size": 9, "axes.titlesize": 9,
    "axes.spines.top": False, "axes.spines.right": False, "axes.linewidth": 0.6,
    "axes.grid": True, "grid.color": "#dddddd", "grid.linewidth": 0.5, "axes.axisbelow": True,
    "lines.linewidth": 1.4, "lines.markersize": 4.5, "legend.frameon": False, "legend.handlelength": 2.6,
    "xtick.major.width": 0.6, "ytick.major.width": 0.6})


def panels(rows, columns, height, **options):
    return plt.subplots(rows, columns, figsize=(7, height), layout="constrained", squeeze=False, **options)


def save(figure, target):
    for axes in figure.axes:
        axes.minorticks_off()
    figure.savefig(target, metadata={"Date": None, "Creator": None})
    plt.close(figure)


# ------------------------------------------------------------------ tables that are plotted

def number_or_text(cell):
    try:
        return float(cell)
    except ValueError:
        return cell


def rows_of(text):
    """The rows of a table with tabs, up to an empty line, as dictionaries by the heads of the columns."""
    heads, *lines = text.split("\n\n")[0].splitlines()
    return [dict(zip(heads.split("\t"), map(number_or_text, line.split("\t")))) for line in lines]


def rows_of_markdown(text):
    heads, _, *rows = [[cell.strip() for cell in line.strip("|").split("|")] for line in text.splitlines()]
    return [dict(zip(heads, map(number_or_text, row))) for row in rows]


def column(rows, head, **conditions):
    return [row[head] for row in rows if all(row[key] == value for key, value in conditions.items())]


def values_of(rows, head):
    """The different ones, in the order of the table."""
    return list(dict.fromkeys(column(rows, head)))


# ------------------------------------------------------------------ plots

def plot_poisson_errors(run, target):
    rows = rows_of(run.output)
    figure, ((left, right),) = panels(1, 2, 3.1)
    for axes, head, title, order in ((left, "L2 error", "$L^2$ norm of the error", 2),
                                     (right, "H1 error", "$H^1$ seminorm of the error", 1)):
        for kind in values_of(rows, "mesh"):
            vertices, errors = (column(rows, h, mesh=kind) for h in ("vertices", head))
            axes.loglog(vertices, errors, **STYLES[kind])
        draw_order(axes, vertices, errors, order)  # the last ones are those of the best meshes
        axes.set(title=title, xlabel="vertices")
    left.legend(loc="lower left")
    save(figure, target)


def draw_order(axes, vertices, errors, order):
    """A line below the curve, as steep as errors of this order in the length of edges are."""
    ends = vertices[2], vertices[-1]
    start = 0.55 * errors[2]
    axes.loglog(ends, [start, start * (ends[0] / ends[1])**(order / 2)], color="black", linewidth=0.8)
    axes.annotate(f"order {order}", (ends[0], start), xytext=(-4, -4), textcoords="offset points",
                  ha="right", va="center")


def plot_convergence(run, target):
    rows = rows_of(run.output)
    cases = values_of(rows, "case")
    figure, axes = panels(2, len(cases), 4.2, sharex=True, sharey="row")
    for (upper, lower), case in zip(axes.T, cases):
        least = min(column(rows, "energy", case=case))
        for method in values_of(rows, "method"):
            iterations, energies, moves = (column(rows, head, case=case, method=method)
                                           for head in ("iteration", "energy", "greatest move"))
            style = dict(STYLES[method], marker="o", markevery=[-1])  # where the method has ended
            upper.semilogy(iterations, [max(energy / least - 1, 1e-9) for energy in energies], **style)
            lower.semilogy(iterations, moves, **style)
        upper.set(title=case, ylim=(1e-5, 5e-2))
        lower.set(xlabel="iteration", ylim=(1e-5, 0.5))
    axes[0, 0].set(ylabel="energy / least energy - 1")
    axes[1, 0].set(ylabel="greatest move / edge length")
    axes[0, -1].legend(loc="upper right")
    save(figure, target)


def plot_quality_histogram(run, target):
    rows = rows_of(run.output)
    cases = values_of(rows, "case")
    figure, (axes,) = panels(1, len(cases), 2.8, sharey=True)
    for axis, case in zip(axes, cases):
        bins = column(rows, "quality from", case=case) + [1]
        before, after = (column(rows, head, case=case) for head in ("unit mesh %", "optimized %"))
        axis.stairs(before, bins, fill=True, color="#cccccc", label="unit mesh")
        axis.stairs(after, bins, color=GOOD, linewidth=1.4, label="optimized")
        axis.set(title=case, xlabel="quality of triangles", xlim=(0.5, 1))
    axes[0].set(ylabel="share, %")
    axes[0].legend(loc="upper left")
    save(figure, target)


def plot_cost_against_size(run, target):
    rows = [row for row in rows_of_markdown(run.output) if row["mesher"] == "ours"]
    figure, ((left, right),) = panels(1, 2, 2.8)
    vertices = column(rows, "vertices")
    left.semilogx(vertices, column(rows, "mesh us/vertex"), **STYLES["unit mesh"])
    left.semilogx(vertices, column(rows, "us/vertex/iteration"), **STYLES["optimizer"])
    left.set(title="time per vertex", ylabel="µs", xlabel="vertices", ylim=(0, None))
    left.legend(loc="lower left")
    right.loglog(vertices, column(rows, "peak bytes/vertex"), color=GOOD, marker="^")
    right.set(title="peak memory per vertex", ylabel="bytes", xlabel="vertices", ylim=(500, 20000))
    save(figure, target)


# ------------------------------------------------------------------ what comes from where

def copy_picture(run, target):
    shutil.copyfile(run.folder / target.name, target)


def copy_output(run, target):
    target.write_text(run.output, encoding="utf-8")


def draw_layers(_, target):
    target.write_text(layers.picture(layers.read_includes(PROJECT / "include")), encoding="utf-8")


INCLUDES = "the includes of the headers"
COST = "cost_against_size.py"  # is not run, since it takes long and wants a machine for itself

# the file of the manual, the command it comes from, and how
SOURCES = [
    ("fig/five_generators_isotropic.svg", "five_generators", copy_picture),
    ("fig/five_generators_constant.svg", "five_generators", copy_picture),
    ("fig/five_generators_varying.svg", "five_generators", copy_picture),
    ("fig/holes_and_constraints.svg", "holes_and_constraints", copy_picture),
    ("fig/quick_start.svg", "quick_start", copy_picture),
    ("fig/disc_tessellation.svg", "paper_disc_and_square", copy_picture),
    ("fig/square4_tessellation.svg", "paper_disc_and_square", copy_picture),
    ("fig/layer10.svg", "paper_line_refinement", copy_picture),
    ("fig/parallelogram_0.svg", "paper_parallelogram", copy_picture),
    ("fig/parallelogram_0_tessellation.svg", "paper_parallelogram", copy_picture),
    ("fig/parallelogram_5.svg", "paper_parallelogram", copy_picture),
    ("fig/parallelogram_5_tessellation.svg", "paper_parallelogram", copy_picture),
    ("fig/parallelogram_30.svg", "paper_parallelogram", copy_picture),
    ("fig/parallelogram_30_tessellation.svg", "paper_parallelogram", copy_picture),
    ("fig/parallelogram_100.svg", "paper_parallelogram", copy_picture),
    ("fig/parallelogram_100_tessellation.svg", "paper_parallelogram", copy_picture),
    ("fig/surface_ellipsoid.svg", "paper_surfaces", copy_picture),
    ("fig/surface_paraboloid.svg", "paper_surfaces", copy_picture),
    ("fig/surface_torus.svg", "paper_surfaces", copy_picture),
    ("fig/surface_saddle_sizes.svg", "paper_surfaces", copy_picture),
    ("fig/surface_saddle_curvature.svg", "paper_surfaces", copy_picture),
    ("fig/graph_surface.svg", "graph_surface", copy_picture),
    ("fig/surface_scan.svg", "remesh_scan", copy_picture),
    ("fig/layers.svg", INCLUDES, draw_layers),
    ("fig/poisson_error.svg", "poisson_boundary_layer", plot_poisson_errors),
    ("fig/convergence.svg", "convergence", plot_convergence),
    ("fig/quality_histogram.svg", "quality_histogram", plot_quality_histogram),
    ("fig/cost_against_size.svg", COST, plot_cost_against_size),
    ("tables/quick_start.txt", "quick_start", copy_output),
    ("tables/exactness.md", "exactness 20000", copy_output),
    ("tables/function_approximation.md", "function_approximation", copy_output)]


def run_in(folder, command, programs):
    """Runs an example in the folder."""
    name, *arguments = command.split()
    path = next((p / name for p in programs if (p / name).is_file()), None)
    if path is None:
        sys.exit(f"figures.py: {name} is in none of the folders {', '.join(map(str, programs))}")
    print(f"running {command}", flush=True)
    done = subprocess.run([path, *arguments], cwd=folder, stdout=subprocess.PIPE, text=True)
    if done.returncode != 0:
        sys.exit(f"figures.py: {command} failed with the status {done.returncode}")
    return Run(done.stdout, pathlib.Path(folder))


def parsed_arguments():
    def folder(text):
        return pathlib.Path(text).resolve()
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("programs", nargs="+", type=folder,
                        help="folders with the built examples")
    parser.add_argument("--cost", type=pathlib.Path, default=MANUAL / "tables/cost_against_size.md",
                        help="what cost_against_size.py has printed; default: the table of the manual")
    parser.add_argument("--only", nargs="+", default=[""], metavar="NAME",
                        help="the files whose names have one of these parts")
    return parser.parse_args()


def main():
    arguments = parsed_arguments()
    runs = {COST: Run(arguments.cost.read_text(encoding="utf-8"), None), INCLUDES: None}
    with tempfile.TemporaryDirectory() as folder:
        for name, command, make in SOURCES:
            if any(part in name for part in arguments.only):
                if command not in runs:
                    runs[command] = run_in(folder, command, arguments.programs)
                make(runs[command], MANUAL / name)


if __name__ == "__main__":
    main()
