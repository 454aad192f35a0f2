#!/usr/bin/env bash
# Runs clang-tidy with the checks of .clang-tidy over the files named, or over every file of filters and
# pipelines that the build compiles; any finding fails. Takes 10 to 20 seconds a file.
#
#   scripts/build.sh && scripts/tidy.sh [--build FOLDER] [FILE...]
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

if ! command -v clang-tidy >/dev/null; then
  echo "Install clang-tidy; it is not in scripts/packages.sh, as no test needs it." >&2
  exit 2
fi
build=build
if [[ "${1:-}" == --build ]]; then
  build=$2
  shift 2
fi
# Without a compile command clang-tidy would guess one, so only files that have one.
mapfile -t compiled < <(sed -n 's/^ *"file": "\(.*\)",*$/\1/p' "$build/compile_commands.json" |
  grep --extended-regexp "^$PWD/(filters|pipelines)/" | sort --unique)
files=()
for file in "${@:-${compiled[@]}}"; do
  file=$(realpath "$file")
  if ! printf '%s\n' "${compiled[@]}" | grep --quiet --line-regexp --fixed-strings "$file"; then
    echo "$file is not compiled in $build." >&2
    exit 2
  fi
  files+=("$file")
done
# xargs fails when one of the files has a finding.
printf '%s\0' "${files[@]}" |
  xargs --null --max-args=1 --max-procs=2 clang-tidy --quiet \
    --extra-arg=-Wno-unknown-warning-option -p "$build" # g++ has some that clang has not
echo "${#files[@]} files are clean."
