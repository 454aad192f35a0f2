#!/usr/bin/env bash
# Builds everything, then computes and draws the first figure of the paper: the cross field on the
# unit disk with four singularities of quarter index 1. The results are in build/demo/.
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
rm -f "$demo"/cross_field*

cat >"$demo/four.csv" <<'END'
x,y,quarter_index,radius
0.4242640687119285,0.4242640687119285,1,0.1
-0.4242640687119285,0.4242640687119285,1,0.1
-0.4242640687119285,-0.4242640687119285,1,0.1
0.4242640687119285,-0.4242640687119285,1,0.1
END
echo "The cross field, by the program:"
build/bin/crossfield solve builtin:disk --singularities "$demo/four.csv" --size 0.02 --method constrained \
  --output "$demo/cross_field.vtu"
echo "The same field and its picture, by ParaView:"
plugin=$(build/bin/crossfield --paths | sed -n 's/^plugin: //p')
# -noreset: ParaView opens and closes a window first, and a server that resets refuses the next one.
xvfb-run -a -s "-screen 0 1280x1024x24 -noreset" pvpython pipelines/pvpython/place_singularities.py --plugin "$plugin" \
  --singularities "$demo/four.csv" --output "$demo/cross_field_paraview.vtu" \
  --picture "$demo/cross_field.png"

echo "The field is in $PWD/$demo/cross_field.vtu"
echo "The picture is in $PWD/$demo/cross_field.png"
