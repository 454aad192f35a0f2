#!/usr/bin/env bash
# Computes and draws every figure of the paper and writes the gallery page docs/gallery.md, with
# pictures in docs/gallery/. Fields and table are in build/figures/. FOLDER replaces docs.
#
#   scripts/build.sh && scripts/figures.sh [FOLDER]
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
docs=${1:-docs}
crossfield=build/bin/crossfield
plugin=$("$crossfield" --paths | sed -n 's/^plugin: //p')
mkdir -p "$docs/gallery"

"$crossfield" figures -o build/figures
for field in build/figures/*.vtu; do
  name=$(basename "$field" .vtu)
  width=420
  crosses=25
  case $name in ellipse_*) width=900 crosses=70 ;; esac
  xvfb-run -a -s "-screen 0 1280x1024x24 -noreset" pvpython pipelines/pvpython/draw_fields.py \
    --plugin "$plugin" --width $width --crosses $crosses --picture "$docs/gallery/$name.png" "$field"
done
xvfb-run -a -s "-screen 0 1280x1024x24 -noreset" pvpython pipelines/pvpython/draw_h.py \
  --plugin "$plugin" --width 960 --picture "$docs/gallery/h_field.png"
python3 scripts/gallery.py build/figures/summary.csv >"$docs/gallery.md"
echo "The gallery is in $docs/gallery.md"
