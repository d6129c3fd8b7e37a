#!/usr/bin/env python3
"""The layers of the package, lowest first, as the includes of its headers show them.

    layers.py check INCLUDE_FOLDER    one line per header that includes an upper layer, per circle of
                                      includes and per header without a layer; status 1 if there is any

An internal header belongs to the layer that its folder below CGAL/Anisotropic_mesh_2/internal names, a
public one to the layer that lists it here. A header may include its own layer and those before it.
"""
import re
import sys
from pathlib import Path

LAYERS = {
    "base": """Anisotropic_mesh_2/parameters Anisotropic_mesh_2/Measure
        Anisotropic_mesh_2/Domain_rule Anisotropic_mesh_2/Planar_straight_line_graph_2
        Anisotropic_mesh_2/Invalid_domain_exception Anisotropic_mesh_2/Invalid_metric_tensor_exception
        Anisotropic_mesh_2/Too_many_vertices_exception""",
    "metric": """Metric_tensor_2 Metric_tensor_3 Riemannian_metric_traits_2 Constant_metric_field_2
        Isotropic_metric_field_2 Oriented_sizes_metric_field_2 Gradient_metric_field_2
        Hessian_metric_field_2 Discrete_metric_field_2""",
    "domain": "Anisotropic_mesh_2/Curve_piece_2 Anisotropic_mesh_2/Boundary_graph_2 Anisotropic_mesh_domain_2",
    "kernel": """Anisotropic_mesh_vertex_base_2 Constrained_anisotropic_Delaunay_triangulation_2
        Anisotropic_mesh_2/Delaunay_consistency anisotropic_Delaunay_consistency_2""",
    "mesh": "Anisotropic_mesh_face_base_2 Anisotropic_Delaunay_mesh_2",
    "meshing": "Anisotropic_mesh_2/Point_placement make_anisotropic_mesh_2 refine_anisotropic_mesh_2",
    "tessellation": """Anisotropic_mesh_2/Directional_distance_2 Anisotropic_mesh_2/Labelle_Shewchuk_distance_2
        Anisotropic_mesh_2/Multiplicative_weight_distance_2 Anisotropic_mesh_2/Region_integrals_2
        Anisotropic_mesh_2/Voronoi_bisector_2 Anisotropic_mesh_2/Voronoi_duality_2
        Anisotropic_mesh_2/Voronoi_piece_2 Anisotropic_mesh_2/Voronoi_region_2
        Anisotropic_mesh_2/Visibility_sampling Anisotropic_Voronoi_diagram_2 anisotropic_visibility_region_2""",
    "energy": "Anisotropic_mesh_2/Region_evaluation anisotropic_mass_centre_2",
    "optimization": "Anisotropic_mesh_2/Optimization_state lloyd_optimize_anisotropic_mesh_2",
    "quality_moves": "optimize_anisotropic_mesh_2",
    "statistics": """Anisotropic_mesh_2/Mesh_statistics Anisotropic_mesh_2/Approximation_error
        anisotropic_mesh_statistics_2 piecewise_constant_approximation_error_2
        piecewise_linear_approximation_error_2""",
    "surface": """Anisotropic_mesh_2/Parameter_rectangle Anisotropic_mesh_2/Degenerate_parametrization_exception
        Anisotropic_mesh_2/Callable_surface_3 Anisotropic_mesh_2/Parametric_ellipsoid_3
        Anisotropic_mesh_2/Parametric_torus_3 Anisotropic_mesh_2/Quadratic_graph_surface_3
        Anisotropic_mesh_2/Curvature_metric_3 Anisotropic_mesh_2/principal_curvatures_3
        Anisotropic_mesh_2/Surface_mesh_statistics Anisotropic_mesh_2/Surface_voronoi_region_3
        Surface_metric_field_2 Anisotropic_surface_mesh_3 make_anisotropic_surface_mesh_3
        optimize_anisotropic_surface_mesh_3 anisotropic_surface_mesh_statistics_3
        anisotropic_surface_Voronoi_regions_3""",
    "surface/triangulated": "Anisotropic_mesh_2/Triangulated_surface_3 Anisotropic_mesh_2/Vertex_metric_3",
    "IO": "Anisotropic_mesh_2/View_direction_3 Anisotropic_mesh_2/Voronoi_drawing",
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
    return {header: [name for name in re.findall(r"^#include <CGAL/(\S+)\.h>", path.read_text(), re.M) if name in headers]
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


def main(arguments):
    if len(arguments) != 2 or arguments[0] != "check":
        sys.exit(__doc__)
    found = list(complaints(read_includes(arguments[1])))
    print("\n".join(found) or "every include leads to the same layer or to a lower one")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
