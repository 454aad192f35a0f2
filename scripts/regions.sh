#!/usr/bin/env bash
# Meshes and draws the domains of the gallery of several materials and writes the page
# docs/regions_gallery.md, with pictures in docs/regions_gallery/. FOLDER replaces docs; NAME selects domains.
#
#   scripts/build.sh && scripts/regions.sh [FOLDER [NAME...]]
set -euo pipefail
exec "$(dirname "${BASH_SOURCE[0]}")/page.sh" regions_gallery python3 scripts/regions_gallery.py scripts/pictures/draw_regions.py "$@"
