#!/usr/bin/env bash
# Builds everything for ParaView 5.11, for VTK 9.1 and with sanitizers, and runs all tests; the exit
# status is that of the tests.
#
#   scripts/test.sh [OPTIONS OF CTEST]
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

# Names of presets. Each builds in build-NAME, the first in build.
presets=(paraview511 vtk91 checked)
# Tests of the others that do not depend on the VTK and would only be repeated.
declare -A skipped=(
  [vtk91]='^(Numerics|bench|Rules)\.'
  [checked]='^(Rules|Verify\.Spoilt)\.')

scripts/build.sh "${presets[@]}"

# clang's OpenMP (build checked) leaves an empty file when a process is stopped as it begins, and the next
# process of the same number dies of it.
find /dev/shm -maxdepth 1 -name '__KMP_REGISTERED_LIB_*' -size 0 -mmin +1 -delete || true

# One list of the tests of all builds, so that one run of ctest reports on them together.
mkdir -p build-all
{
  echo "include(\"$PWD/tests/AllTests.cmake\")"
  echo "tests_of(\"$PWD/build\" \"\" \"\")"
  for preset in "${presets[@]:1}"; do
    echo "tests_of(\"$PWD/build-$preset\" \"$preset.\" [==[${skipped[$preset]:-}]==])"
  done
} >build-all/CTestTestfile.cmake
ctest --test-dir build-all --output-on-failure --parallel 2 "$@"
