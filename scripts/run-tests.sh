#!/usr/bin/env bash
# Builds everything and runs all tests; the status is CTest's.
set -euo pipefail
. "$(dirname "${BASH_SOURCE[0]}")/prepare.sh"

install_missing "${program_packages[@]}" libeigen3-dev python3
build build/tests
ctest --test-dir build/tests --parallel "$(nproc)" --output-on-failure --no-tests=error
