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
import functools
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import textwrap

import matplotlib
matplotlib.use("svg")
import matplotlib.pyplot as plt
import numpy
from matplotlib.patches import PathPatch
from matplotlib.path import Path

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


def save_compactly(figure, target):
    """Two digits after the point are enough for paths of thousands of triangles."""
    save(figure, target)
    shorten = functools.partial(re.sub, r"(\d\.\d\d)\d+", r"\1")
    target.write_text(re.sub(r' d="[^"]*"', lambda path: shorten(path[0]), target.read_text(encoding="utf-8")),
                      encoding="utf-8")


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


# ------------------------------------------------------------------ pictures that explain the method

Panel = collections.namedtuple("Panel", "title lines")  # lines: what a line is called -> the numbers of each

FILLS = ["#fbe3a0", "#bcd7ee", "#c9e6c3", "#f0c5c0", "#dccbe8", "#e5e5e5"]
QUALITIES = matplotlib.colormaps["YlGnBu_r"]


def panels_of(text, picture):
    found = []
    for line in text.splitlines():
        head, *rest = line.split()
        if head == "panel":
            name, _, title = line[len("panel "):].partition(" ")
            current = Panel(title.split("|"), collections.defaultdict(list))
            if name == picture:
                found.append(current)
        else:
            current.lines[head].append([float(number) for number in rest])
    return found


def points_of(numbers):
    return list(zip(numbers[0::2], numbers[1::2]))


def draw_polygons(axes, polygons, **style):
    path = Path.make_compound_path(*(Path(p + p[:1], closed=True) for p in polygons))
    axes.add_patch(PathPatch(path, **{"linewidth": 0.5, "edgecolor": "#333333", "facecolor": "none", **style}))


def draw_mesh(axes, panel, **style):
    draw_polygons(axes, [points_of(face[:6]) for face in panel.lines["face"]], **style)


def draw_regions(axes, panel):
    """Neighbours may have the same of the soft colours; their border tells them apart."""
    for i, fill in enumerate(FILLS):
        polygons = [points_of(region) for region in panel.lines["region"][i::len(FILLS)]]
        if polygons:
            draw_polygons(axes, polygons, facecolor=fill, edgecolor="#555555")


def draw_qualities(axes, panel):
    """Twelve tones from 0.4 to 1, one patch for each."""
    tones = collections.defaultdict(list)
    for *corners, quality in panel.lines["face"]:
        tones[min(max(int((quality - 0.4) * 20), 0), 11)].append(points_of(corners))
    for tone, polygons in sorted(tones.items()):
        draw_polygons(axes, polygons, facecolor=QUALITIES((tone + 0.5) / 12), edgecolor="#222222", linewidth=0.3)


def ellipse(tensor, centre, radius=1.):
    """The points whose vector from the centre has the length `radius` in the tensor."""
    m11, m12, m22 = tensor
    root = numpy.linalg.inv(numpy.linalg.cholesky([[m11, m12], [m12, m22]]).T)
    angles = numpy.linspace(0, 2 * numpy.pi, 73)[:-1]
    circle = radius * numpy.array([numpy.cos(angles), numpy.sin(angles)])
    return [tuple(p) for p in (numpy.array(centre)[:, None] + root @ circle).T]


def circumscribed(tensor, corners):
    """The ellipse through three points that is a circle in the tensor."""
    m = numpy.array([[tensor[0], tensor[1]], [tensor[1], tensor[2]]])
    a, b, c = map(numpy.array, corners)
    rows = numpy.array([2 * m @ (b - a), 2 * m @ (c - a)])
    centre = numpy.linalg.solve(rows, [b @ m @ b - a @ m @ a, c @ m @ c - a @ m @ a])
    return ellipse(tensor, centre, numpy.sqrt((a - centre) @ m @ (a - centre)))


def map_axes(rows, columns, height, titles):
    figure, axes = plt.subplots(rows, columns, figsize=(7, height), layout="constrained", squeeze=False)
    for axis, title in zip(axes.flat, titles):
        axis.set(title=title, aspect="equal")
        axis.axis("off")
    return figure, list(axes.flat)


def fit(axes):
    for axis in axes:
        axis.autoscale_view()


def draw_unit_triangle(_, target):
    h1, h2, theta = 2., 0.8, 0.45
    turn = numpy.array([[numpy.cos(theta), -numpy.sin(theta)], [numpy.sin(theta), numpy.cos(theta)]])
    stretch = turn @ numpy.diag([h1, h2])
    corners = numpy.array([[0, 0]] + [[numpy.cos(t), numpy.sin(t)] for t in (3.6, 3.6 + numpy.pi / 3)])
    figure, axes = map_axes(1, 2, 2.5, ["a unit triangle in the plane",
                                        r"the same, mapped by $M^{1/2}$"])
    for axis, images in zip(axes, (stretch, numpy.eye(2))):
        circle = [tuple(images @ [numpy.cos(t), numpy.sin(t)]) for t in numpy.linspace(0, 2 * numpy.pi, 97)[:-1]]
        draw_polygons(axis, [circle], facecolor="#e8f0f8", edgecolor=GOOD, linewidth=1.2)
        draw_polygons(axis, [[tuple(images @ p) for p in corners]], facecolor="#fbe3a0", linewidth=1.2)
        for vector, text in (([1, 0], "$h_1$"), ([0, 1], "$h_2$")):
            end = images @ vector
            axis.annotate("", end, (0, 0), arrowprops=dict(arrowstyle="->", color=MIDDLING, linewidth=1.2))
            axis.annotate(text if axis is axes[0] else "1", end, xytext=6 * end / numpy.linalg.norm(end) + [-3, -3],
                          textcoords="offset points", color=MIDDLING)
    fit(axes)
    save(figure, target)


def draw_method(run, target):
    metric, mesh, regions = panels_of(run.output, "method")
    figure, axes = map_axes(1, 3, 2.5, [p.title[0] for p in (metric, mesh, regions)])
    draw_polygons(axes[0], [[(0, 0), (4, 0), (4, 4), (0, 4)]])
    draw_polygons(axes[0], [ellipse(line[2:], line[:2], 0.5) for line in metric.lines["tensor"]],
                  facecolor="#e8f0f8", edgecolor=GOOD, linewidth=1)
    draw_mesh(axes[1], mesh)
    draw_regions(axes[2], regions)
    fit(axes)
    save_compactly(figure, target)


def draw_cases(run, target):
    found = panels_of(run.output, "cases")
    figure, axes = map_axes(2, 3, 4.8, [p.title[0] for p in found])
    for axis, panel in zip(axes, found):
        draw_mesh(axis, panel, linewidth=0.3)
    fit(axes)
    save_compactly(figure, target)


def draw_cavity(run, target):
    found = panels_of(run.output, "cavity")
    figure, axes = map_axes(1, 3, 2.5, [p.title[0] for p in found])
    holder = points_of(found[0].lines["face"][0][:6])
    draw_polygons(axes[0], [holder], facecolor="#fbe3a0", linewidth=1)
    for i, line in enumerate(found[0].lines["tensor"]):
        colour = MIDDLING if i == 0 else GOOD
        draw_polygons(axes[0], [circumscribed(line[2:], holder)], edgecolor=colour, linewidth=0.9)
        axes[0].plot(*line[:2], "o", color=colour)
        axes[0].annotate("pabc"[i], line[:2], xytext=(4, 4), textcoords="offset points", color=colour)
    for axis, panel in zip(axes[1:], found[1:]):
        draw_mesh(axis, panel, edgecolor="#888888")
        cavity = [points_of(face[:6]) for face in panel.lines["cavity"]]
        draw_polygons(axis, cavity, facecolor="#fbe3a0", linewidth=0.9)
        axis.plot(*panel.lines["point"][0], "o", color=MIDDLING)
        corners = numpy.array([corner for face in cavity for corner in face])
        middle, reach = (corners.min(0) + corners.max(0)) / 2, numpy.ptp(corners, 0).max()
        axis.set(xlim=middle[0] + numpy.array([-1, 1]) * reach, ylim=middle[1] + numpy.array([-1, 1]) * reach)
    fit(axes[:1])
    save_compactly(figure, target)


def draw_bisector(run, target):
    panel, = panels_of(run.output, "bisector")
    corners = points_of(panel.lines["face"][0][:6])
    regions = [points_of(region) for region in panel.lines["region"]]
    centre, = set(regions[0]) & set(regions[1]) & set(regions[2])
    figure, axes = plt.subplots(figsize=(4.2, 3.2), layout="constrained")
    for region, fill in zip(regions, FILLS):
        draw_polygons(axes, [region], facecolor=fill, linewidth=1)
    for i, j in ((0, 1), (1, 2), (2, 0)):
        middle = tuple((numpy.array(corners[i]) + corners[j]) / 2)
        axes.plot(*zip(middle, centre), color=MIDDLING, linestyle="--", linewidth=1)
        axes.plot(*middle, "s", color=MIDDLING)
    axes.plot(*centre, "o", color=MIDDLING)
    axes.plot(*zip(*corners), "o", color=GOOD)
    axes.set(aspect="equal")
    axes.axis("off")
    save(figure, target)


def draw_parameter(run, target):
    found = panels_of(run.output, target.stem[len("parameter_"):])
    figure, axes = map_axes(1, len(found), 6.0 / len(found) + 0.7, ["\n".join(p.title) for p in found])
    for axis, panel in zip(axes, found):
        axis.title.set_fontsize(8 if len(found) < 4 else 6)
        draw_qualities(axis, panel)
    fit(axes)
    bar = figure.colorbar(matplotlib.cm.ScalarMappable(matplotlib.colors.Normalize(0.4, 1), QUALITIES),
                          ax=axes, shrink=0.7, pad=0.01, aspect=25)
    bar.set_label("quality of triangles", fontsize=7)
    bar.ax.tick_params(labelsize=6)
    save_compactly(figure, target)


# concept: its models in the package, and what has a template parameter for it
CONCEPTS = {
    "MetricField_2": (
        "any function object from a point to a tensor, such as a lambda; Constant_, Isotropic_, Oriented_sizes_, "
        "Gradient_, Hessian_, Discrete_metric_field_2; Surface_metric_field_2",
        "make_anisotropic_mesh_2(), Riemannian_metric_traits_2; of a surface: Anisotropic_surface_mesh_3"),
    "RiemannianMetricTraits_2": (
        "Riemannian_metric_traits_2",
        "Constrained_anisotropic_Delaunay_triangulation_2, Anisotropic_Delaunay_mesh_2, both bases"),
    "AnisotropicMeshVertexBase_2": (
        "Anisotropic_mesh_vertex_base_2 over any vertex base of a triangulation",
        "Constrained_anisotropic_Delaunay_triangulation_2, Anisotropic_Delaunay_mesh_2"),
    "AnisotropicMeshFaceBase_2": (
        "Anisotropic_mesh_face_base_2 over any face base of a constrained triangulation",
        "Anisotropic_Delaunay_mesh_2"),
    "GeneratorMetric_2": (
        "Directional_distance_2, the default; Labelle_Shewchuk_distance_2, Multiplicative_weight_distance_2",
        "Anisotropic_Voronoi_diagram_2"),
    "ParametricSurface_3": (
        "Callable_surface_3, Parametric_ellipsoid_3, Parametric_torus_3, Quadratic_graph_surface_3, "
        "Triangulated_surface_3",
        "Surface_metric_field_2, Curvature_metric_3, principal_curvatures_3()")}


def draw_concepts(_, target):
    """A row per concept: models on the left, who needs one on the right."""
    body, y = [], 34
    for x, head in ((10, "models"), (415, "concept"), (690, "needed by")):
        body.append(layers.text(x, 20, head, "head"))
    for name, (models, users) in CONCEPTS.items():
        left, right = (textwrap.wrap(text, width) for text, width in ((models, 62), (users, 52)))
        height = 14 + 16 * max(len(left), len(right))
        boxes = (1, 360, "#f3f3f3", left), (400, 240, "#dbe8f5", []), (680, 319, "#f3f3f3", right)
        for x, width, fill, lines in boxes:
            body.append(f'<rect x="{x}" y="{y}" width="{width}" height="{height}" rx="4" fill="{fill}" stroke="#888"/>')
            body += [layers.text(x + 8, y + 19 + 16 * i, line, "list") for i, line in enumerate(lines)]
        body.append(layers.text(520, y + height / 2 + 5, name, "head", text_anchor="middle"))
        for x in (361, 641):
            body.append(f'<path d="M{x} {y + height / 2}h30" stroke="#444" marker-end="url(#tip)"/>')
        y += height + 10
    style = ("text { font-family: Helvetica, Arial, sans-serif; } .head { font-size: 14px; font-weight: bold; } "
             ".list { font-size: 12px; }")
    tip = '<marker id="tip" markerWidth="9" markerHeight="8" refY="4"><path d="M0 0L9 4L0 8z" fill="#444"/></marker>'
    head = [f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 1000 {y}" width="1000" height="{y}">',
            f"<style>{style}</style><defs>{tip}</defs>", f'<rect width="1000" height="{y}" fill="white"/>']
    target.write_text("\n".join([*head, *body, "</svg>", ""]), encoding="utf-8")


# ------------------------------------------------------------------ what comes from where

def copy_picture(run, target):
    shutil.copyfile(run.folder / target.name, target)


def copy_output(run, target):
    target.write_text(run.output, encoding="utf-8")


def draw_layers(_, target):
    target.write_text(layers.picture(layers.read_includes(PROJECT / "include")), encoding="utf-8")


INCLUDES = "the includes of the headers"
NOTHING = "nothing"
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
    ("fig/concepts.svg", NOTHING, draw_concepts),
    ("fig/unit_triangle.svg", NOTHING, draw_unit_triangle),
    ("fig/method.svg", "teaching_figures", draw_method),
    ("fig/cases.svg", "teaching_figures", draw_cases),
    ("fig/cavity.svg", "teaching_figures", draw_cavity),
    ("fig/bisector.svg", "teaching_figures", draw_bisector),
    ("fig/parameter_measure.svg", "teaching_figures", draw_parameter),
    ("fig/parameter_point_placement.svg", "teaching_figures", draw_parameter),
    ("fig/parameter_number_of_iterations.svg", "teaching_figures", draw_parameter),
    ("fig/parameter_region_evaluation.svg", "teaching_figures", draw_parameter),
    ("fig/parameter_quality_moves.svg", "teaching_figures", draw_parameter),
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
    runs = {COST: Run(arguments.cost.read_text(encoding="utf-8"), None), INCLUDES: None, NOTHING: None}
    with tempfile.TemporaryDirectory() as folder:
        for name, command, make in SOURCES:
            if any(part in name for part in arguments.only):
                if command not in runs:
                    runs[command] = run_in(folder, command, arguments.programs)
                make(runs[command], MANUAL / name)


if __name__ == "__main__":
    main()
