#!/usr/bin/env bash
# Computes the examples of docs/variants.md: every variant of the paper on its own example. Fields
# and tables are written to build/variants/, pictures to docs/ or FOLDER.
#
#   scripts/build.sh && scripts/variants.sh [FOLDER]
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
root=$PWD
docs=${1:-$root/docs} # an absolute path
mkdir -p "$docs"
crossfield=$root/build/bin/crossfield
plugin=$("$crossfield" --paths | sed -n 's/^plugin: //p')
mkdir -p build/variants
cd build/variants

draw() {
  xvfb-run -a -s "-screen 0 1280x1024x24 -noreset" \
    pvpython "$root/pipelines/pvpython/draw_fields.py" --plugin "$plugin" "$@"
}

# on_circle DISTANCE COUNT FIRST_DEGREES QUARTER_INDEX RADIUS
on_circle() {
  awk -v r="$1" -v n="$2" -v a="$3" -v k="$4" -v h="$5" 'BEGIN {
    print "x,y,quarter_index,radius"
    for (i = 0; i < n; ++i) {
      t = atan2(0, -1) * (a / 180 + 2 * i / n)
      printf "%.12g,%.12g,%d,%g\n", r * cos(t), r * sin(t), k, h
    } }'
}

echo "== An imprinted circle of quarter index -1 in the quarter disk, with unit norms"
for radius in 0.06 0.2; do
  printf 'x,y,quarter_index,radius\n0.42,0.42,-1,%s\n' $radius >minus.csv
  "$crossfield" solve builtin:quarter-disk -s minus.csv --mode imprint --unit-holes --size 0.02 \
    -o quarter-$radius.vtu
done
draw --picture "$docs/variants_imprint.png" quarter-0.06.vtu quarter-0.2.vtu

echo "== Single triangles, near the reference and far from it"
for distance in 0.85 0.3; do
  on_circle $distance 4 45 1 0.1 >triangles.csv
  "$crossfield" solve builtin:disk -s triangles.csv --mode triangle --epsilon 0.05 --size 0.05 \
    -o triangle-$distance.vtu
done
draw --picture "$docs/variants_triangle.png" triangle-0.85.vtu triangle-0.3.vtu

for ratio in 0.4 0.46; do
  echo "== The ring r1/r2 = $ratio, epsilon = 1/100"
  "$crossfield" domain ring --inner-radius $ratio --size 0.02 -o ring-$ratio.vtp
  for start in harmonic constant; do
    "$crossfield" solve ring-$ratio.vtp --method ginzburg-landau --epsilon 0.01 --size 0.02 \
      --start $start -o ring-$ratio-$start.vtu | tee ring-$ratio-$start.txt
  done
  awk 'BEGIN { print "x,y,quarter_index,radius" }
    /^quarter index/ { printf "%s,%s,%s,0.02\n", $5, $6, $3 }' \
    ring-$ratio-constant.txt >ring-$ratio.csv
  "$crossfield" compare ring-$ratio.vtp -s ring-$ratio.csv --size 0.02 --epsilon 0.01 --in-place \
    --methods constrained,unit-holes,unit-norm,penalty -o ring-$ratio.vtm || true
  draw --picture "$docs/variants_ring_$ratio.png" ring-$ratio-harmonic.vtu \
    ring-$ratio-constant.vtu ring-$ratio/unit-norm.vtu ring-$ratio/penalty.vtu
done

echo "== The flat ellipse"
"$crossfield" domain ellipse --width 6 --height 1.2 --size 0.06 -o ellipse.vtp
cat >rectangle.csv <<'END'
x,y,quarter_index,radius
-2.1,-0.2,1,0.06
-2.1,0.2,1,0.06
2.1,-0.2,1,0.06
2.1,0.2,1,0.06
END
"$crossfield" compare ellipse.vtp -s rectangle.csv --size 0.06 --epsilon 0.06 --in-place \
  --methods ginzburg-landau,constrained,unit-norm,penalty -o ellipse.vtm || true
draw --picture "$docs/variants_ellipse.png" --columns 1 --width 900 --crosses 70 \
  ellipse/ginzburg-landau.vtu ellipse/constrained.vtu ellipse/unit-norm.vtu

echo "== Sets at unsuitable positions, with the penalty"
on_circle 0.6 5 17 1 0.1 >five.csv
"$crossfield" solve builtin:disk -s five.csv --epsilon 0.05 --size 0.05 -o five.vtu
cat >seven.csv <<'END'
x,y,quarter_index,radius
-0.6,0.6,1,0.1
-0.6,-0.6,1,0.1
0.6,-0.35,1,0.1
-0.2,0.2,-1,0.1
-0.2,-0.2,-1,0.1
0.5,-0.62,-1,0.05
0.6,0.6,-1,0.1
END
"$crossfield" solve builtin:disk -s seven.csv --epsilon 0.05 --size 0.05 -o seven.vtu
draw --picture "$docs/variants_penalty.png" five.vtu seven.vtu
