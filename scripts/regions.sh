#!/usr/bin/env bash
# Meshes and draws the domains of the gallery of several materials and writes the page
# docs/regions_gallery.md, with pictures in docs/regions/. FOLDER replaces docs; NAME selects domains.
#
#   scripts/build.sh && scripts/regions.sh [FOLDER [NAME...]]
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
docs=${1:-docs}
shift || true
made=build/regions_gallery_page
rm -rf "$made"
scripts/page.sh regions_gallery python3 scripts/regions_gallery.py scripts/pictures/draw_regions.py "$made" "$@"
mkdir -p "$docs/regions"
cp "$made"/regions_gallery/*.png "$docs/regions/"
cp "$made/regions_gallery.md" "$docs/"
