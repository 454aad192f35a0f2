#!/usr/bin/env bash
# Formats every .h and .cxx file of filters, pipelines and tests as .clang-format says.
#
#   scripts/format.sh           rewrites the files that differ
#   scripts/format.sh --check   only names them, and fails if there is one; the test Rules.Format
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

# This version and no other: each formats a little differently.
formatter=clang-format-14
if ! command -v "$formatter" >/dev/null; then
  echo "There is no $formatter here: apt-get install $formatter" >&2
  exit 77 # ctest reports a test that ends so as skipped
fi
# Not `git ls-files`, which leaves out a file not yet added, and refuses the folder of another user.
mapfile -d '' files < <(find filters pipelines tests -type f \( -name '*.h' -o -name '*.cxx' \) -print0 | sort -z)
if [[ ${#files[@]} -eq 0 ]]; then
  echo "No sources found in $PWD" >&2
  exit 1
fi

if [[ ${1:-} != --check ]]; then
  exec "$formatter" -i "${files[@]}"
fi
# One process for all of them: one for each takes forty times as long.
said=$("$formatter" --dry-run "${files[@]}" 2>&1)
if [[ -n $said ]]; then
  echo "$formatter would change:"
  grep -oP '^\S+(?=:\d+:\d+: warning: code should be clang-formatted)' <<<"$said" | sort -u | sed 's/^/  /' || echo "$said"
  echo "Run scripts/format.sh and commit what it changes."
  exit 1
fi
