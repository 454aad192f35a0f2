#!/usr/bin/env bash
# Builds the library, the Python package, the ParaView plugin and the program in build/.
# Installs missing Debian packages first and builds only what has changed.
#
#   scripts/build.sh
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

scripts/packages.sh
# Debian's VTK needs Debian's Python, also when another python3 comes first on the PATH.
cmake --preset paraview511 -DPython3_EXECUTABLE=/usr/bin/python3
cmake --build --preset paraview511
