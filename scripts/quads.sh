#!/usr/bin/env bash
# Meshes the domains of the gallery of quads, draws them and writes the page docs/quads.md, with pictures in
# docs/quads/. For a test another folder than docs may be given, and some of the domains.
#
#   scripts/build.sh && scripts/quads.sh [FOLDER [NAME...]]
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
docs=${1:-docs}
shift || true
made=build/quads
crossfield=build/bin/crossfield
plugin=$("$crossfield" --paths | sed -n 's/^plugin: //p')
rm -rf "$made"
mkdir -p "$docs/quads" "$made"

python3 scripts/quads_gallery.py "$crossfield" "$made" "$@"
mapfile -t names <"$made/names.txt"
xvfb-run -a -s "-screen 0 1280x1024x24 -noreset" pvpython pipelines/pvpython/draw_quads.py \
  --plugin "$plugin" --width 420 "$made" "${names[@]}"
cp "$made"/*.png "$docs/quads/"
cp "$made/quads.md" "$docs/quads.md"
echo "The gallery is in $docs/quads.md"
