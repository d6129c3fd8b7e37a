# This file is part of Anisotropic_mesh_2.
#
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Author(s)     : the Anisotropic_mesh_2 developers
"""The domains and metrics on which meshers are compared, and meshes in Medit files."""

import collections
import math
import random


class Case:
    """A polygon or a disc with a metric.

    The metric is written once, by the two sizes and a vector along the first of
    them, as formulas that muParser, the MathEvalAniso field of gmsh and Python
    all understand: + - * /, abs, min, max, sqrt. If the program has domain and
    metric built in, `builtin` is their name.
    """

    def __init__(self, name, corners, h1, h2, direction=("1", "0"), builtin=None, scale=1, radius=None):
        self.name = name
        self.corners = corners
        self.radius = radius              # of the disc that the corners approximate
        self.builtin = builtin
        self.scale = scale
        self.h1, self.h2 = f"({h1})", f"({h2})"
        self.direction = [f"({component})" for component in direction]
        self.tensor_at = eval("lambda x, y: (" + ", ".join(self.tensor_formulas()) + ")",
                              {"abs": abs, "min": min, "max": max, "sqrt": math.sqrt})

    def tensor_formulas(self):
        """The entries m11, m12, m22, with the scale."""
        u, v = self.direction
        a, b = (f"({self.scale}*{h}*{self.scale}*{h})" for h in (self.h1, self.h2))
        norm = f"({u}*{u}+{v}*{v})"
        return (f"({u}*{u}/{a}+{v}*{v}/{b})/{norm}",
                f"{u}*{v}*(1/{a}-1/{b})/{norm}",
                f"({v}*{v}/{a}+{u}*{u}/{b})/{norm}")

    def size_arguments(self):
        """The metric for the program, as formulas for the two sizes and the angle."""
        u, v = self.direction
        return ["--h1", self.h1, "--h2", self.h2, "--theta", f"atan2({v},{u})"]

    def area(self):
        if self.radius is not None:
            return math.pi * self.radius * self.radius
        pairs = zip(self.corners, self.corners[1:] + self.corners[:1])
        return sum(a[0] * b[1] - a[1] * b[0] for a, b in pairs) / 2

    def area_tolerance(self):
        """How much of the area a mesh may lack or have in excess: chords cut off parts of a disc."""
        return 1e-6 if self.radius is None else 0.02

    def diameter(self):
        return max(math.dist(a, b) for a in self.corners for b in self.corners)

    def ideal_vertices(self):
        """The number of vertices of a unit mesh, up to a few percent."""
        tensors = [self.tensor_at(x, y) for x, y in random_points(self.corners, 100000)]
        densities = [math.sqrt(m11 * m22 - m12 * m12) for m11, m12, m22 in tensors]
        return 2 / math.sqrt(3) * self.area() * math.fsum(densities) / len(densities)


def rectangle(side):
    return [(0, 0), (side, 0), (side, side), (0, side)]


def circle(radius, number):
    angles = [2 * math.pi * i / number for i in range(number)]
    return [(radius * math.cos(a), radius * math.sin(a)) for a in angles]


def square4(name, scale=1):
    return Case(name, rectangle(4), "0.031+x/4", "0.031+y/4", builtin="square4", scale=scale)


def scale_of_square4(vertices):
    """The scale at which a unit mesh of square4 has this number of vertices."""
    return round(math.sqrt(226.88 / vertices), 6)


def all_cases():
    small = "abs(y-5)/5+0.04"
    large = f"abs(5-4*abs(y-5)/5)*({small})"
    ring = "abs(sqrt(x*x+y*y)-0.5)"
    share = f"min(10*{ring},1)"
    return [
        Case("disc", circle(10, 256), "1.5", "0.3", ("1", "1"), builtin="disc", radius=10),
        square4("square4"),
        Case("square10", rectangle(10), small, large, builtin="square10"),
        Case("layer10", rectangle(10), large, small, builtin="layer10"),
        Case("parallelogram", [(0, 0), (30, 0), (40, 14), (10, 14)], "2", "0.5", builtin="parallelogram"),
        # an angle is needed at the origin too
        Case("polar-2", rectangle(1), f"0.001+0.198*{ring}", f"0.1*{share}+0.025*(1-{share})", ("x+1e-99", "y")),
        square4("square4-10k", scale=0.1508),
        square4("square4-100k", scale=0.04766)]


# ------------------------------------------------------------------ meshes

# edges and triangles count the points from 0 and come without references
Triangle_mesh = collections.namedtuple("Triangle_mesh", "points edges triangles")


def random_points(corners, number):
    """Points of a convex polygon, the same in every run."""
    random_number = random.Random(1)
    n = len(corners)
    o = tuple(math.fsum(c[k] for c in corners) / n for k in range(2))
    pairs = list(zip(corners, corners[1:] + corners[:1]))
    areas = [(a[0] - o[0]) * (b[1] - o[1]) - (a[1] - o[1]) * (b[0] - o[0]) for a, b in pairs]
    points = []
    for a, b in random_number.choices(pairs, areas, k=number):
        s, t = sorted((random_number.random(), random_number.random()))
        points.append(tuple(s * a[k] + (t - s) * b[k] + (1 - t) * o[k] for k in range(2)))
    return points


def outline(corners):
    n = len(corners)
    return Triangle_mesh(corners, [(i, (i + 1) % n) for i in range(n)], [])


def scattered_triangles(corners, number, size):
    """Small triangles here and there."""
    points = [(x + dx, y + dy) for x, y in random_points(corners, number) for dx, dy in ((0, 0), (size, 0), (0, size))]
    return Triangle_mesh(points, [], [(3*i, 3*i + 1, 3*i + 2) for i in range(number)])


def read_mesh(path):
    """Reads points, edges and triangles and skips everything else.

    Points that no triangle uses are dropped, like those that gmsh writes for centers.
    """
    dimension, sections = 2, {"Vertices": [], "Edges": [], "Triangles": []}
    with open(path, encoding="utf-8") as file:
        words = (word for line in file for word in line.split())
        for word in words:
            if word == "Dimension":
                dimension = int(next(words))
            elif word in sections:
                corners = {"Vertices": dimension, "Edges": 2, "Triangles": 3}[word]
                kind = float if word == "Vertices" else int
                for _ in range(int(next(words))):
                    sections[word].append(tuple([kind(next(words)) for _ in range(corners)]))
                    next(words)
    return used_part(sections["Vertices"], sections["Edges"], sections["Triangles"])


def used_part(points, edges, triangles):
    number = {v: i for i, v in enumerate(sorted({v for t in triangles for v in t}))}
    return Triangle_mesh([points[v - 1][:2] for v in number],
                         [(number[a], number[b]) for a, b in edges if a in number and b in number],
                         [tuple([number[v] for v in t]) for t in triangles])


def write_mesh(path, mesh):
    with open(path, "w", encoding="utf-8") as file:
        file.write(f"MeshVersionFormatted 2\nDimension 2\n\nVertices\n{len(mesh.points)}\n")
        file.writelines(f"{x!r} {y!r} 0\n" for x, y in mesh.points)
        file.write(f"\nEdges\n{len(mesh.edges)}\n")
        file.writelines(f"{a + 1} {b + 1} 1\n" for a, b in mesh.edges)
        if mesh.triangles:
            file.write(f"\nTriangles\n{len(mesh.triangles)}\n")
            file.writelines(f"{a + 1} {b + 1} {c + 1} 0\n" for a, b, c in mesh.triangles)
        file.write("\nEnd\n")


def write_tensors(path, header, tensors):
    """The entries m11 m12 m22, as .sol and .mtr files have them below their headers."""
    with open(path, "w", encoding="utf-8") as file:
        file.write(header)
        file.writelines(f"{a!r} {b!r} {c!r}\n" for a, b, c in tensors)
