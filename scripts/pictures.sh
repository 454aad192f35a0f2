#!/usr/bin/env bash
# Draws the pictures of the pages in docs with ParaView, those of docs/filters/, docs/choosing_singularities.md and
# docs/tutorial_paraview.md into docs/pictures/ or FOLDER.
#
#   scripts/build.sh && scripts/pictures.sh [FOLDER]              all of them
#   scripts/build.sh && scripts/pictures.sh --tutorial [FOLDER]   those of the tutorial, and the list of the texts in them
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
crossfield=${CROSSFIELD:-build/bin/crossfield}
only_tutorial=false
if [[ ${1:-} == --tutorial ]]; then
  only_tutorial=true
  shift
fi
plugin=$("$crossfield" --paths | sed -n 's/^plugin: //p')
folder=${1:-docs/pictures}
mkdir -p "$folder"

draw() {
  script=$1
  shift
  xvfb-run -a -s "-screen 0 1280x1024x24 -noreset" \
    pvpython "scripts/pictures/$script" --plugin "$plugin" "$@"
}

if ! $only_tutorial; then
  draw docs_pictures.py --folder "$folder"
  python=$("$crossfield" --paths | sed -n 's/^python: //p')
  xvfb-run -a pvpython scripts/pictures/drawings.py "$crossfield" docs/drawings
  xvfb-run -a pvpython scripts/pictures/surfaces.py "$crossfield" docs/surfaces
  PYTHONPATH=$python /usr/bin/python3 scripts/pictures/glossary.py docs/glossary
  PYTHONPATH=$python /usr/bin/python3 scripts/pictures/sizes.py docs/sizes
  PYTHONPATH=$python /usr/bin/python3 scripts/pictures/regions.py docs/regions
  PYTHONPATH=$python /usr/bin/python3 scripts/pictures/lines.py docs/lines
  CROSSFIELD=$crossfield scripts/parts.sh
fi

# Tests in ParaView's client perform the steps of the pages and save these pictures. The texts are not compared with the
# list, because this script replaces it.
build=$(dirname "$(dirname "$(command -v "$crossfield")")")
clients=$build/tests/paraview
if ! $only_tutorial; then
  ctest --test-dir "$build" -R '^ParaView\.SurfaceDesign$' --output-on-failure
  for step in design dragging; do
    cp "$clients/surface_design/$step.png" docs/stl_to_quads/
  done
fi
CROSSFIELD_DRAW=1 ctest --test-dir "$build" -R '^ParaView\.(Tutorial|RecordedRun)$' --output-on-failure
for run in tutorial recorded_run; do
  cut -f 1 "$clients/$run/tutorial_texts.txt" | uniq | while read -r picture; do
    cp "$clients/$run/${picture#tutorial_}" "$folder/$picture"
  done
done
cat "$clients"/{tutorial,recorded_run}/tutorial_texts.txt >"$folder/tutorial_texts.txt"
