#!/usr/bin/env bash
# Runs clang-tidy with the checks of .clang-tidy; the exit status is 1 if it finds anything. By hand, before
# a change is merged, as it takes 15 seconds for every file: `scripts/test.sh --all` has no time for it.
#
#   cmake --preset checked -DPython3_EXECUTABLE=/usr/bin/python3
#   scripts/tidy.sh [FILE...]     without files: all of filters and pipelines
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

files=("$@")
if [[ ${#files[@]} == 0 ]]; then
  mapfile -t files < <(find filters pipelines -name '*.cxx' | sort)
fi
printf '%s\0' "${files[@]}" |
  xargs -0 -n 1 -P "$(nproc)" clang-tidy-14 --quiet -p build-checked
