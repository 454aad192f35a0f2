#!/usr/bin/env bash
# Meshes a plate with three holes: chooses singularities, which become the irregular nodes of an
# all-quad mesh, and draws the mesh. Then computes and draws the cross field of the first figure of
# the paper, on the unit disk with four singularities of quarter index 1. Results are in
# build/demo/.
#
#   scripts/demo.sh           installs packages and builds first, without tests: about 14 minutes on 2 cores
#   scripts/demo.sh --built   uses the existing build
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

if [[ "${1:-}" != --built ]]; then
  scripts/build.sh --without-tests
fi
demo=build/demo
mkdir -p "$demo"
rm -f "$demo"/cross_field* "$demo"/quads*

echo "Quads, computed by the program:"
build/bin/crossfield quads tests/data/parts/plate3.vtp --quads 1000 --output "$demo/quads.vtu" \
  --save-singularities "$demo/chosen.csv"
plugin=$(build/bin/crossfield --paths | sed -n 's/^plugin: //p')
# -noreset: ParaView opens and closes a window first, and a server that resets refuses the next
# connection.
draw() {
  script=$1
  shift
  xvfb-run -a -s "-screen 0 1280x1024x24 -noreset" pvpython "pipelines/pvpython/$script" --plugin "$plugin" "$@"
}
echo "The same quads, computed and drawn by ParaView:"
draw mesh_quads.py --domain tests/data/parts/plate3.vtp --quads 1000 --output "$demo/quads_paraview.vtu" \
  --picture "$demo/quads.png"

cat >"$demo/four.csv" <<'END'
x,y,quarter_index,radius
0.4242640687119285,0.4242640687119285,1,0.1
-0.4242640687119285,0.4242640687119285,1,0.1
-0.4242640687119285,-0.4242640687119285,1,0.1
0.4242640687119285,-0.4242640687119285,1,0.1
END
echo "A cross field, computed by the program:"
build/bin/crossfield solve builtin:disk --singularities "$demo/four.csv" --size 0.02 --method constrained \
  --output "$demo/cross_field.vtu"
echo "The same field, computed and drawn by ParaView:"
draw place_singularities.py --singularities "$demo/four.csv" --output "$demo/cross_field_paraview.vtu" \
  --picture "$demo/cross_field.png"

echo "Cross field: $PWD/$demo/cross_field.vtu"
echo "Its picture: $PWD/$demo/cross_field.png"
echo "Quad mesh:   $PWD/$demo/quads.vtu"
echo "Its picture: $PWD/$demo/quads.png"
