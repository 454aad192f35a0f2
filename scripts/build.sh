#!/usr/bin/env bash
# Builds the presets named, or paraview511: the library, the Python package, the ParaView plugin and
# the program in build/. Installs missing Debian packages first and builds only what has changed.
#
#   scripts/build.sh [PRESET...]
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

presets=("${@:-paraview511}")
# A machine that only builds paraview511 need not have what the others are built with.
if [[ ${presets[*]} == paraview511 ]]; then
  scripts/packages.sh
else
  scripts/packages.sh --all
fi
# The numerics are the same in all presets; so they are compiled once and found by ccache then.
export CCACHE_BASEDIR=$PWD CCACHE_NOHASHDIR=1
for preset in "${presets[@]}"; do
  # Debian's VTK needs Debian's Python, also when another python3 comes first on the PATH.
  python=/usr/bin/python3
  if [[ $preset == vtk91 ]]; then
    scripts/vtk91.sh
    python=$PWD/build-vtk91/vtk/bin/python3
  fi
  cmake --preset "$preset" "-DPython3_EXECUTABLE=$python"
  cmake --build --preset "$preset"
  if [[ $preset == checked ]]; then
    find build-checked -name '*.gcda' -delete # counters of another build do not fit
  fi
done
