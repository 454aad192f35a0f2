#!/usr/bin/env bash
# Runs the commands of the pages that take one part from start to end, and draws the pictures of these pages
# from the files that were written, into the folders of the pages in docs or FOLDER.
#
#   scripts/build.sh && scripts/parts.sh [FOLDER]
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
crossfield=$(realpath "${CROSSFIELD:-build/bin/crossfield}")
plugin=$("$crossfield" --paths | sed -n 's/^plugin: //p')
python=$("$crossfield" --paths | sed -n 's/^python: //p')
results=$(mktemp -d)
trap 'rm -r "$results"' EXIT

for page in mesh_a_part named_svg stress_at_holes flow_around_a_profile two_materials; do
  /usr/bin/python3 tests/python/test_docs.py "docs/$page.md" "$crossfield" "$plugin" "$results/$page" -- pvpython
done
PYTHONPATH=$python /usr/bin/python3 scripts/pictures/parts.py "$results" "${1:-docs}"
