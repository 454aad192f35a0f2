#!/usr/bin/env bash
# Draws the pictures of docs/filters/ and docs/choosing_singularities.md with ParaView, into
# docs/pictures/ or FOLDER. Screenshots of ParaView's windows are made manually, except those of the
# recorded run, which its test makes (the committed ones have 128 colours).
#
#   scripts/build.sh && scripts/pictures.sh [FOLDER]
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
crossfield=${CROSSFIELD:-build/bin/crossfield}
plugin=$("$crossfield" --paths | sed -n 's/^plugin: //p')
folder=${1:-docs/pictures}
mkdir -p "$folder"

draw() {
  script=$1
  shift
  xvfb-run -a -s "-screen 0 1280x1024x24 -noreset" \
    pvpython "scripts/pictures/$script" --plugin "$plugin" "$@"
}

draw docs_pictures.py --folder "$folder"
python=$("$crossfield" --paths | sed -n 's/^python: //p')
xvfb-run -a pvpython scripts/pictures/drawings.py "$crossfield" docs/drawings
xvfb-run -a pvpython scripts/pictures/surfaces.py "$crossfield" docs/surfaces
PYTHONPATH=$python /usr/bin/python3 scripts/pictures/glossary.py docs/glossary
PYTHONPATH=$python /usr/bin/python3 scripts/pictures/sizes.py docs/sizes
PYTHONPATH=$python /usr/bin/python3 scripts/pictures/regions.py docs/regions
PYTHONPATH=$python /usr/bin/python3 scripts/pictures/lines.py docs/lines

build=$(dirname "$(dirname "$(command -v "$crossfield")")")
ctest --test-dir "$build" -R '^ParaView\.(RecordedRun|SurfaceDesign)$' --output-on-failure
for step in design dragging; do
  cp "$build/tests/paraview/surface_design/$step.png" docs/stl_to_quads/
done
for step in propose drag quads; do
  cp "$build/tests/paraview/recorded_run/$step.png" "$folder/tutorial_$step.png"
done
