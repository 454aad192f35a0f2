#!/usr/bin/env bash
# Builds the given presets, by default paraview: the library, the Python package, the ParaView
# plugin, the program and the tests, in build/. Installs missing Debian packages first. Compiles
# only what has changed.
#
#   scripts/build.sh [--without-tests] [PRESET...]
#
#   --without-tests   in a new build folder: does not configure or compile tests and benchmarks,
#                     and does not install the packages that only they need
#
# Warnings are errors in a new build folder with tests, and without if the variable
# CROSSFIELD_WARNINGS_AS_ERRORS of the environment is ON: a user's compiler may print others than ours. The variable
# CROSSFIELD_BUILD_NUMERICS_TESTS=OFF leaves out the tests of the numerics.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

tests=yes
if [[ "${1:-}" == --without-tests ]]; then
  tests=no
  shift
fi
presets=("${@:-paraview}")
if [[ ${presets[*]} != paraview ]]; then
  scripts/packages.sh --all
elif [[ $tests == yes ]]; then
  scripts/packages.sh --tests
else
  scripts/packages.sh
fi
for preset in "${presets[@]}"; do
  folder=build-$preset
  if [[ $preset == paraview ]]; then
    folder=build
  fi
  # Debian's VTK needs Debian's Python, even if another python3 comes first on the PATH.
  python=/usr/bin/python3
  if [[ $preset == vtk ]]; then
    scripts/vtk.sh
    python=$PWD/build-vtk/vtk/bin/python3
  fi
  options=("-DPython3_EXECUTABLE=$python")
  target=all
  if [[ $tests == yes ]]; then
    options+=(-DCROSSFIELD_BUILD_TESTING=ON)
    options+=("-DCROSSFIELD_BUILD_NUMERICS_TESTS=${CROSSFIELD_BUILD_NUMERICS_TESTS:-ON}")
    strict=ON
  elif [[ ! -e $folder/CMakeCache.txt ]]; then
    options+=(-DCROSSFIELD_BUILD_TESTING=OFF)
    strict=OFF
  else
    target=product # a folder that was configured with tests keeps them
  fi
  if [[ ! -e $folder/CMakeCache.txt ]]; then # another value would compile everything again
    options+=("-DCROSSFIELD_WARNINGS_AS_ERRORS=${CROSSFIELD_WARNINGS_AS_ERRORS:-$strict}")
  fi
  cmake --preset "$preset" "${options[@]}"
  cmake --build --preset "$preset" --target "$target"
  if [[ $preset == checked ]]; then
    find build-checked -name '*.gcda' -delete # counters of an earlier build do not match
  fi
done
