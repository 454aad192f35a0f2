#!/usr/bin/env bash
# Builds everything, then meshes a plate with three holes: singularities are chosen for it, and become the
# irregular nodes of an all-quad mesh. Then draws the first figure of the paper, the cross field on the unit
# disk with four singularities of quarter index 1. The results are in build/demo/.
#
#   scripts/demo.sh           builds first
#   scripts/demo.sh --built   takes what is built
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

if [[ "${1:-}" != --built ]]; then
  scripts/build.sh
fi
demo=build/demo
mkdir -p "$demo"
rm -f "$demo"/cross_field* "$demo"/quads*

echo "Quads, by the program:"
build/bin/crossfield quads tests/data/parts/plate3.vtp --quads 1000 --output "$demo/quads.vtu" \
  --save-singularities "$demo/chosen.csv"
plugin=$(build/bin/crossfield --paths | sed -n 's/^plugin: //p')
# -noreset: ParaView opens and closes a window first, and a server that resets refuses the next one.
draw() {
  script=$1
  shift
  xvfb-run -a -s "-screen 0 1280x1024x24 -noreset" pvpython "pipelines/pvpython/$script" --plugin "$plugin" "$@"
}
echo "The same quads and their picture, by ParaView:"
draw mesh_quads.py --domain tests/data/parts/plate3.vtp --quads 1000 --output "$demo/quads_paraview.vtu" \
  --picture "$demo/quads.png"

cat >"$demo/four.csv" <<'END'
x,y,quarter_index,radius
0.4242640687119285,0.4242640687119285,1,0.1
-0.4242640687119285,0.4242640687119285,1,0.1
-0.4242640687119285,-0.4242640687119285,1,0.1
0.4242640687119285,-0.4242640687119285,1,0.1
END
echo "A cross field, by the program:"
build/bin/crossfield solve builtin:disk --singularities "$demo/four.csv" --size 0.02 --method constrained \
  --output "$demo/cross_field.vtu"
echo "The same field and its picture, by ParaView:"
draw place_singularities.py --singularities "$demo/four.csv" --output "$demo/cross_field_paraview.vtu" \
  --picture "$demo/cross_field.png"

echo "The quads are in $PWD/$demo/quads.vtu, their picture in $PWD/$demo/quads.png"
echo "The field is in $PWD/$demo/cross_field.vtu, its picture in $PWD/$demo/cross_field.png"
