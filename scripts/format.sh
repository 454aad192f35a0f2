#!/usr/bin/env bash
# Formats every .h and .cxx file of filters, pipelines and tests by the rules of .clang-format.
#
#   scripts/format.sh           rewrites the files that differ
#   scripts/format.sh --check   only lists them and fails if there are any: the test Rules.Format
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

# Other versions format slightly differently.
formatter=clang-format-14
if ! command -v "$formatter" >/dev/null; then
  echo "$formatter is missing. To install it: apt-get install $formatter" >&2
  exit 77 # ctest reports this as a skipped test
fi
# `git ls-files` would leave out new files and fail in the folder of another user.
mapfile -d '' files < <(find filters pipelines tests -type f \( -name '*.h' -o -name '*.cxx' \) -print0 | sort -z)
if [[ ${#files[@]} -eq 0 ]]; then
  echo "No sources found in $PWD" >&2
  exit 1
fi

if [[ ${1:-} != --check ]]; then
  exec "$formatter" -i "${files[@]}"
fi
# One process for all files: one per file takes forty times as long.
findings=$("$formatter" --dry-run "${files[@]}" 2>&1)
if [[ -n $findings ]]; then
  echo "$formatter would change:"
  grep -oP '^\S+(?=:\d+:\d+: warning: code should be clang-formatted)' <<<"$findings" | sort -u | sed 's/^/  /' || echo "$findings"
  echo "Run scripts/format.sh and commit the changes."
  exit 1
fi
