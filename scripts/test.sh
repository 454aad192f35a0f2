#!/usr/bin/env bash
# Builds for ParaView and runs the tests of that build. Exits with 0 only if all tests pass.
#
#   scripts/test.sh [OPTIONS OF CTEST]         about 20 minutes on a new machine with 2 cores
#   scripts/test.sh --all [OPTIONS OF CTEST]   also for plain VTK and with sanitizers: about 60 minutes
#
# ctest runs once per build. tests/left_out lists the tests that a build leaves out.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

# Names of presets and of the lists of tests that they leave out.
presets=(paraview)
lists=(quick)
if [[ "${1:-}" == --all ]]; then
  shift
  presets=(vtk checked paraview)
  lists=(vtk checked none)
fi
# ctest takes one option -E only, so patterns given here join those of the list.
options=()
excluded=()
while [[ $# -gt 0 ]]; do
  case $1 in
    -E | --exclude-regex)
      excluded+=("$2")
      shift
      ;;
    *) options+=("$1") ;;
  esac
  shift
done

scripts/build.sh "${presets[@]}"
echo "Installed and built in $((SECONDS / 60)) minutes: ${presets[*]}"

# clang's OpenMP (build checked) leaves an empty file when a process is stopped as it starts, and
# the next process with the same number then aborts.
find /dev/shm -maxdepth 1 -name '__KMP_REGISTERED_LIB_*' -size 0 -mmin +1 -delete || true

# Runs the tests of one build: run_tests FOLDER LIST
run_tests() {
  local patterns
  patterns=$(
    { sed -e '/^#/d' -e '/^$/d' "tests/left_out/$2.txt"; printf '%s\n' "${excluded[@]}"; } |
      sed '/^$/d' | paste --serial --delimiters='|'
  )
  local exclude=()
  if [[ -n $patterns ]]; then
    exclude=(-E "$patterns")
  fi
  ctest --test-dir "$1" --output-on-failure --parallel 2 "${exclude[@]}" "${options[@]}"
}

failed=()
for i in "${!presets[@]}"; do
  folder=build-${presets[i]}
  if [[ ${presets[i]} == paraview ]]; then
    folder=build
  fi
  echo "Tests of ${presets[i]}:"
  run_tests "$folder" "${lists[i]}" || failed+=("$folder")
done
if [[ ${#failed[@]} -gt 0 ]]; then
  # The summary of ctest names the failures of the last build only.
  echo "Tests failed in these builds:" >&2
  for folder in "${failed[@]}"; do
    sed "s|^[0-9]*:|  $folder: |" "$folder/Testing/Temporary/LastTestsFailed.log" >&2 || true
  done
  exit 1
fi
