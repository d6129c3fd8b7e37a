#!/usr/bin/env bash
# Builds the command-line program and meshes a plate with a hole: domain and
# metric in; mesh, tessellation, pictures and statistics out.
set -euo pipefail
. "$(dirname "${BASH_SOURCE[0]}")/prepare.sh"

install_missing "${program_packages[@]}"
build build/program -D ANISOTROPIC_MESH_2_BUILD_TESTS=OFF -D ANISOTROPIC_MESH_2_BUILD_EXAMPLES=OFF

out=build/program/plate
mkdir -p "$out"
# small across the rim of the hole, growing with the distance r from it
r="sqrt(x^2+y^2)"
build/program/program/anisotropic_mesh_2 examples/Anisotropic_mesh_2/data/plate.poly \
  --h1 "0.02+0.2*abs($r-0.5)" --h2 "0.1+0.1*abs($r-0.5)" --theta "atan2(y,x)" \
  -o "$out/mesh.mesh" -o "$out/mesh.vtu" -o "$out/mesh.svg" \
  --voronoi "$out/tessellation.svg" --stats "$out/statistics.json"
cat "$out/statistics.json"
echo "Written to $PWD/$out:"
ls "$out"
