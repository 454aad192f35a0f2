#!/usr/bin/env bash
# Makes a page with pictures; quads.sh, surfaces.sh and others call it:
#
#   scripts/page.sh PAGE PYTHON MAKER DRAWER [FOLDER [NAME...]]
#
# `PYTHON MAKER PROGRAM MADE NAME...` writes PAGE.md, names.txt and the files that DRAWER draws into
# the folder MADE. The page is copied to FOLDER, by default docs, and the pictures to FOLDER/PAGE.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
page=$1 python=$2 maker=$3 drawer=$4
shift 4
docs=${1:-docs}
shift || true
made=build/$page
crossfield=build/bin/crossfield
plugin=$("$crossfield" --paths | sed -n 's/^plugin: //p')
rm -rf "$made"
mkdir -p "$docs/$page" "$made"

"$python" "$maker" "$crossfield" "$made" "$@"
mapfile -t names <"$made/names.txt"
xvfb-run -a -s "-screen 0 1280x1024x24 -noreset" pvpython "$drawer" \
  --plugin "$plugin" --width 420 "$made" "${names[@]}"
cp "$made"/*.png "$docs/$page/"
cp "$made/$page.md" "$docs/$page.md"
echo "The page is $docs/$page.md"
