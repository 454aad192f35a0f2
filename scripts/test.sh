#!/usr/bin/env bash
# Builds for ParaView 5.11 and runs the tests of that build; the exit status is that of the tests.
#
#   scripts/test.sh [OPTIONS OF CTEST]         on a new machine at most 20 minutes with 2 cores
#   scripts/test.sh --all [OPTIONS OF CTEST]   also for VTK 9.1 and with sanitizers: at most 60 minutes
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

# Names of presets. Each builds in build-NAME, the first in build.
presets=(paraview511)
# Tests of each build that are left out, as what they check does not depend on it: another build has them.
# docs/testing.md has the table. By name, so that a new test runs everywhere until somebody says otherwise.
declare -A skipped=()
if [[ "${1:-}" == --all ]]; then
  shift
  presets+=(vtk91 checked)
  # What is left uses VTK: filters, files read and written, the Python package, an installed tree.
  skipped[vtk91]='^(Numerics|bench|Rules|Readme|Valgrind|Verify\.Corrupted)\.|^Verify\.NothingIsAFailure$'
  skipped[vtk91]+='|^Corpus\.(Geometry|Numbers|Configurations|Verified)\.'
  skipped[vtk91]+='|^Automatic\.|^Program\.(Help|Usage|Energy|Optimize|Figures|Check|Corners|Variants|Page|Exact|WholeRuns)\.'
  skipped[checked]='^(Rules|Verify\.Corrupted|Automatic)\.|^Verify\.NothingIsAFailure$'
  # Aborted at fifty reports: half a minute, and ten times that with the sanitizers. What the figures run,
  # other tests run as well.
  skipped[vtk91]+='|^Vtk\.ConfigurationProposalFilter\.KeepsTheRulesOfAFilter$'
  skipped[checked]+='|^Vtk\.Variants\.KeepTheRulesOfAFilter$|^Program\.(Figures|Page)\.'
  skipped[checked]+='|^Vtk\.ConfigurationProposalFilter\.KeepsTheRulesOfAFilter$'
  # Two to three minutes each with the sanitizers; shorter tests run the same code there.
  skipped[checked]+='|^Numerics\.PlanarMesher\.RefusesGapsThatWouldTakeMillionsOfTriangles$'
  skipped[checked]+='|^Numerics\.VariantsOfThePaper\.TheEightOfTheRingCanBeImposed$'
  skipped[checked]+='|^Program\.Optimize\.parts_arrive_and_stay$'
else
  # These need packages that only --all installs; on a machine that has them they would run here, too.
  skipped[paraview511]='^(Package|Valgrind)\.'
  # Three minutes of drawing that a change is rarely about.
  skipped[paraview511]+='|^Docs\.Pictures$|^Scripts\.(Figures|Variants)$'
fi

scripts/build.sh "${presets[@]}"
echo "Installed and built in $((SECONDS / 60)) minutes: ${presets[*]}"

# clang's OpenMP (build checked) leaves an empty file when a process is stopped as it begins, and the next
# process of the same number dies of it.
find /dev/shm -maxdepth 1 -name '__KMP_REGISTERED_LIB_*' -size 0 -mmin +1 -delete || true

# One list of the tests of all builds, so that one run of ctest reports on them together.
mkdir -p build-all
{
  echo "include(\"$PWD/tests/AllTests.cmake\")"
  for preset in "${presets[@]}"; do
    folder=build-$preset
    prefix=$preset.
    if [[ $preset == paraview511 ]]; then
      folder=build
      prefix=
    fi
    echo "tests_of(\"$PWD/$folder\" \"$prefix\" [==[${skipped[$preset]:-}]==])"
  done
} >build-all/CTestTestfile.cmake
ctest --test-dir build-all --output-on-failure --parallel 2 "$@"
