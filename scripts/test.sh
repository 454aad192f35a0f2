#!/usr/bin/env bash
# Builds for ParaView and runs the tests of that build. Exits with 0 only if all tests pass.
#
#   scripts/test.sh [OPTIONS OF CTEST]         about 25 minutes on a new machine with 2 cores
#   scripts/test.sh --all [OPTIONS OF CTEST]   also for plain VTK and with sanitizers: about two hours
#
# ctest runs once per build. tests/left_out lists the tests that a build leaves out. With --all, the builds for plain VTK and with
# sanitizers are skipped if they have passed with the same files, options and compilers: a second run continues after an interruption.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

# Preset, folder, list of the tests that are left out, and whether the tests of the numerics are built, which do not depend on VTK.
stages=("paraview build quick ON")
if [[ "${1:-}" == --all ]]; then
  shift
  stages=("vtk build-vtk vtk OFF" "checked build-checked checked ON" "paraview build none ON")
  scripts/packages.sh --all # before the compilers are asked for their versions
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

# Prints a hash of what a build for plain VTK or with sanitizers and its tests depend on. Fails outside a clone.
inputs() {
  local files
  mapfile -d '' files < <(
    git ls-files -z --cached --others --exclude-standard -- . ':!docs' ':!paraview-plugin' ':!CHANGELOG.md'
  )
  [[ ${#files[@]} -gt 0 ]] || return 1
  {
    printf '%s\n' "${options[@]}" "/${excluded[*]}/"
    c++ --version
    clang++-14 --version
    sha256sum -- "${files[@]}" || true # names deleted files
  } 2>&1 | sha256sum
}

failed=()
for stage in "${stages[@]}"; do
  read -r preset folder list numerics <<<"$stage"
  hash=""
  if [[ $preset != paraview ]]; then # the last build always runs
    hash=$(inputs) || true
  fi
  if [[ -n $hash ]] && grep --quiet --no-messages --line-regexp --fixed-strings "$hash" "$folder/passed.txt"; then
    echo "Skipped $preset: it has passed with these files, options and compilers. To run it again, delete $folder/passed.txt."
    continue
  fi
  CROSSFIELD_BUILD_NUMERICS_TESTS=$numerics scripts/build.sh "$preset"
  patterns=$(
    { sed '/^#/d' "tests/left_out/$list.txt"; printf '%s\n' "${excluded[@]}"; } |
      sed '/^$/d' | paste --serial --delimiters='|'
  )
  exclude=()
  if [[ -n $patterns ]]; then
    exclude=(-E "$patterns")
  fi
  # clang's OpenMP (build checked) leaves an empty file when a process is stopped as it starts, and
  # the next process with the same number then aborts.
  find /dev/shm -maxdepth 1 -name '__KMP_REGISTERED_LIB_*' -size 0 -mmin +1 -delete || true
  echo "Tests of $preset, $((SECONDS / 60)) minutes after the start:"
  if ! ctest --test-dir "$folder" --output-on-failure --parallel 2 "${exclude[@]}" "${options[@]}"; then
    failed+=("$folder")
  elif [[ -n $hash && $hash == "$(inputs)" ]]; then # no file was edited meanwhile
    echo "$hash" >>"$folder/passed.txt"
  fi
done
if [[ ${#failed[@]} -gt 0 ]]; then
  # The summary of ctest names the failures of the last build only.
  echo "Tests failed in these builds:" >&2
  for folder in "${failed[@]}"; do
    sed "s|^[0-9]*:|  $folder: |" "$folder/Testing/Temporary/LastTestsFailed.log" >&2 || true
  done
  exit 1
fi
