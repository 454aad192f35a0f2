#!/usr/bin/env bash
# Fuzzes every reader, the writers of meshes and the numerics for MINUTES each, by default 5. New inputs are stored in
# build-checked/tests/fuzz/. Add inputs that fail, whose names are printed, to tests/fuzz/corpus/.
#
#   cmake --preset checked && cmake --build --preset checked && scripts/fuzz.sh [MINUTES]
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
seconds=$((60 * ${1:-5}))
found=build-checked/tests/fuzz
status=0

# fuzz NAME PROGRAM [ARGUMENTS]
fuzz() {
  name=$1
  shift
  mkdir -p "$found/$name"
  echo "== $name"
  nice -n 19 "$@" -max_total_time=$seconds -timeout=60 -max_len=4096 -rss_limit_mb=4096 \
    -detect_leaks=0 -print_final_stats=1 "-artifact_prefix=$found/$name-" \
    "$found/$name" "tests/fuzz/corpus/$name" >"$found/$name.log" 2>&1 || status=1
  grep -E "^stat::number_of_executed|SUMMARY|violated property|not one sentence|Test unit" \
    "$found/$name.log" || true
}

fuzz configuration build-checked/bin/fuzzConfiguration
fuzz formats build-checked/bin/fuzzFormats
for format in vtp vtu vtk stl obj ply csv dat dxf svg geojson msh poly off points.vtp points.csv; do
  fuzz $format build-checked/bin/fuzzReader --format=$format
done
exit $status
