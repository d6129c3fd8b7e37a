#!/usr/bin/env python3
"""The layers of the package, lowest first, as the includes of its headers show them.

    layers.py check INCLUDE_FOLDER [FILE.svg]  one line per header that includes an upper layer, per circle of
                                               includes, per header without a layer, and for a picture
                                               that is out of date; status 1 if there is any
    layers.py draw INCLUDE_FOLDER FILE.svg     draws that picture: the layers, their public headers, and
                                               how often each includes those below

An internal header belongs to the layer that its folder below CGAL/Anisotropic_mesh_2/internal names, a
public one to the layer that lists it here. A header may include its own layer and those before it.
"""
import collections
import re
import sys
import textwrap
from pathlib import Path

LAYERS = {
    "base": """license/Anisotropic_mesh_2 Anisotropic_mesh_2/parameters Anisotropic_mesh_2/Measure
        Anisotropic_mesh_2/Domain_rule Anisotropic_mesh_2/Planar_straight_line_graph_2
        Anisotropic_mesh_2/exceptions""",
    "metric": """Metric_tensor_2 Metric_tensor_3 Riemannian_metric_traits_2 Constant_metric_field_2
        Isotropic_metric_field_2 Oriented_sizes_metric_field_2 Gradient_metric_field_2
        Hessian_metric_field_2 Discrete_metric_field_2""",
    "domain": "Anisotropic_mesh_2/Curve_piece_2 Anisotropic_mesh_2/Boundary_graph_2 Anisotropic_mesh_domain_2",
    "kernel": """Anisotropic_mesh_vertex_base_2 Constrained_anisotropic_Delaunay_triangulation_2
        anisotropic_Delaunay_consistency_2""",
    "mesh": "Anisotropic_mesh_face_base_2 Anisotropic_Delaunay_mesh_2",
    "meshing": """Anisotropic_mesh_2/Point_placement Anisotropic_mesh_2/Refinement_result make_anisotropic_mesh_2
        refine_anisotropic_mesh_2""",
    "tessellation": """Anisotropic_mesh_2/Directional_distance_2 Anisotropic_mesh_2/Labelle_Shewchuk_distance_2
        Anisotropic_mesh_2/Multiplicative_weight_distance_2 Anisotropic_mesh_2/Visibility_sampling
        Anisotropic_Voronoi_diagram_2 anisotropic_visibility_region_2""",
    "energy": "anisotropic_mass_centre_2",
    "optimization": "Anisotropic_mesh_2/Optimization_state",
    "quality_moves": "improve_anisotropic_mesh_2 optimize_anisotropic_mesh_2",
    "statistics": "anisotropic_mesh_statistics_2 approximation_error_2",
    "surface": """Anisotropic_mesh_2/Parameter_rectangle
        Anisotropic_mesh_2/Callable_surface_3 Anisotropic_mesh_2/Parametric_ellipsoid_3
        Anisotropic_mesh_2/Parametric_torus_3 Anisotropic_mesh_2/Quadratic_graph_surface_3
        Anisotropic_mesh_2/Curvature_metric_3 Anisotropic_mesh_2/principal_curvatures_3
        Anisotropic_mesh_2/Surface_voronoi_region_3
        Surface_metric_field_2 Anisotropic_surface_mesh_3 make_anisotropic_surface_mesh_3
        optimize_anisotropic_surface_mesh_3 anisotropic_surface_mesh_statistics_3
        anisotropic_surface_Voronoi_regions_3""",
    "surface/triangulated": "Anisotropic_mesh_2/Triangulated_surface_3 Anisotropic_mesh_2/Vertex_metric_3",
    "IO": "Anisotropic_mesh_2/View_direction_3 Anisotropic_mesh_2/Voronoi_drawing",
}
PURPOSES = {
    "base": "numbers, vectors, sums in parallel, parameters",
    "metric": "tensors, fields, the exact cavity criterion, lengths",
    "domain": "curves, crossings, inside and outside",
    "kernel": "cavities, insertion, removal, moves",
    "mesh": "the domain in the triangulation; references; flips",
    "meshing": "unit lengths on the boundary, points inside",
    "tessellation": "regions, bisectors, orphans",
    "energy": "energy, gradient, Hessian",
    "optimization": "Lloyd, quasi-Newton, line search",
    "quality_moves": "moves, flips, insertions, removals",
    "statistics": "lengths, qualities, errors",
    "surface": "charts over the planar machinery",
    "surface/triangulated": "parametrization, curvature of triangles",
    "IO": "formats and pictures",
}
NAMES = list(LAYERS)
LAYER_OF_PUBLIC = {header: layer for layer, headers in LAYERS.items() for header in headers.split()}


def layer_of(header):
    """the layer of a header, given by its path below CGAL/ without .h; None if it has none"""
    internal = re.match(r"Anisotropic_mesh_2/internal/(.+)/\w+$", header)
    if internal:
        return next((name for name in reversed(NAMES) if (internal[1] + "/").startswith(name + "/")), None)
    return "IO" if header.startswith("Anisotropic_mesh_2/IO/") else LAYER_OF_PUBLIC.get(header)


def read_includes(folder):
    """header -> the headers of the package that it includes"""
    top = Path(folder) / "CGAL"
    headers = {path.relative_to(top).with_suffix("").as_posix(): path for path in sorted(top.rglob("*.h"))}
    own = re.compile(r"^#include <CGAL/(\S+)\.h>", re.M)
    return {header: [name for name in own.findall(path.read_text(encoding="utf-8")) if name in headers]
            for header, path in headers.items()}


def circles(includes):
    """the headers that include themselves over others"""
    def reached(start):
        seen, stack = set(), list(includes[start])
        while stack:
            header = stack.pop()
            if header not in seen:
                seen.add(header)
                stack += includes[header]
        return seen
    return [header for header in includes if header in reached(header)]


def complaints(includes):
    for header, included in includes.items():
        if layer_of(header) is None:
            yield f"{header}.h belongs to no layer"
            continue
        for other in included:
            if layer_of(other) is not None and NAMES.index(layer_of(other)) > NAMES.index(layer_of(header)):
                yield f"{header}.h ({layer_of(header)}) includes {other}.h of the upper layer {layer_of(other)}"
    for header in circles(includes):
        yield f"{header}.h includes itself over others"
    for header in LAYER_OF_PUBLIC:
        if header not in includes:
            yield f"{header}.h is listed in {Path(__file__).name} but is not there"


# ------------------------------------------------------------------ the picture

WIDTH, TEXT, CELL, HEAD, LINE = 1000, 520, 32, 130, 15


def public_names(includes, layer):
    return sorted((header.split("Anisotropic_mesh_2/")[-1] for header in includes
                   if layer_of(header) == layer and "/internal/" not in header), key=str.lower)


def text(x, y, content, style="", **attributes):
    extra = "".join(f' {name.replace("_", "-")}="{value}"' for name, value in attributes.items())
    return f'<text x="{x}" y="{y}" class="{style}"{extra}>{content}</text>'


def picture(includes):
    """one row per layer, the lowest at the bottom: what it is, and in the matrix whom it includes"""
    headers = collections.Counter(map(layer_of, includes))
    arrows = collections.Counter((layer_of(header), layer_of(other))
                                 for header, included in includes.items() for other in included)
    left, y = WIDTH - CELL * len(NAMES), HEAD
    body = [text(12, HEAD - 40, "Layers, from the lowest upwards", "name"),
            text(12, HEAD - 22, "with what each is for, its headers, and those that users include", "small"),
            text(12, HEAD - 6, "right: how many of its includes lead to which lower layer", "small")]
    for column, name in enumerate(NAMES):
        x = left + CELL * (column + 0.5) + 4
        body.append(text(x, HEAD - 6, name, "small", transform=f"rotate(-90 {x} {HEAD - 6})"))
    for row in reversed(range(len(NAMES))):
        name = NAMES[row]
        lines = textwrap.wrap(", ".join(public_names(includes, name)), 86, break_long_words=False)
        height = 30 + LINE * len(lines)
        colour = f"hsl({(200 + 47 * row) % 360}, 45%, 88%)"
        body += [f'<rect x="0.5" y="{y}" width="{TEXT}" height="{height - 4}" rx="4" fill="{colour}" stroke="#777"/>',
                 text(10, y + 18, f'{name}<tspan dx="10" class="purpose">{PURPOSES[name]}</tspan>', "name"),
                 text(TEXT - 8, y + 18, f"{headers[name]} headers", "small", text_anchor="end")]
        body += [text(10, y + 18 + LINE * (i + 1), line, "small") for i, line in enumerate(lines)]
        for column in range(row + 1):
            x, number = left + CELL * column, arrows[name, NAMES[column]]
            fill = colour if column == row else "#44698c" if number else "#f4f4f4"
            body.append(f'<rect x="{x + 1}" y="{y}" width="{CELL - 2}" height="{height - 4}" fill="{fill}"/>')
            if number and column < row:
                body.append(text(x + CELL / 2, y + height / 2 + 2, number, "number", text_anchor="middle"))
        y += height
    style = ("text { font-family: Helvetica, Arial, sans-serif; } .name { font-size: 14px; font-weight: bold; } "
             ".purpose { font-size: 12px; font-weight: normal; font-style: italic; } .small { font-size: 11px; } "
             ".number { font-size: 11px; fill: white; }")
    size = f'width="{WIDTH}" height="{y}"'
    return "\n".join([f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {WIDTH} {y}" {size}>',
                      f"<style>{style}</style>", f'<rect {size} fill="white"/>', *body, "</svg>", ""])


def main(arguments):
    if arguments[:1] == ["draw"] and len(arguments) == 3:
        Path(arguments[2]).write_text(picture(read_includes(arguments[1])), encoding="utf-8")
        return 0
    if arguments[:1] != ["check"] or len(arguments) not in (2, 3):
        sys.exit(__doc__)
    includes = read_includes(arguments[1])
    found = list(complaints(includes))
    if not found and len(arguments) == 3 and Path(arguments[2]).read_text(encoding="utf-8") != picture(includes):
        found = [f"{arguments[2]} is out of date: layers.py draw {arguments[1]} {arguments[2]}"]
    print("\n".join(found) or "every include leads to the same layer or to a lower one")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
