#!/usr/bin/env bash
# Chooses singularities for the domains of tests, compares them with those of finer meshes and of random starts,
# draws them and writes the page docs/automatic.md, with pictures in docs/automatic/. It takes minutes.
#
#   scripts/build.sh && scripts/automatic.sh [FOLDER [NAME...]]
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
docs=${1:-docs}
shift || true
made=build/automatic
crossfield=build/bin/crossfield
plugin=$("$crossfield" --paths | sed -n 's/^plugin: //p')
rm -rf "$made"
mkdir -p "$docs/automatic" "$made"

pvpython scripts/automatic.py "$crossfield" "$made" "$@"
mapfile -t names <"$made/names.txt"
xvfb-run -a -s "-screen 0 1280x1024x24 -noreset" pvpython pipelines/pvpython/draw_chosen.py \
  --plugin "$plugin" --width 420 "$made" "${names[@]}"
cp "$made"/*.png "$docs/automatic/"
cp "$made/automatic.md" "$docs/automatic.md"
echo "The page is $docs/automatic.md"
