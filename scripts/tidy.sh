#!/usr/bin/env bash
# Runs clang-tidy with the checks of .clang-tidy. Exits with 1 if it finds anything. Run it before a
# change is merged; `scripts/test.sh --all` leaves it out because it takes 15 seconds per file.
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
