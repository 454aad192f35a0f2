#!/usr/bin/env bash
# Meshes and draws the surfaces of the gallery and writes the page docs/surfaces_gallery.md, with
# pictures in docs/surfaces_gallery/. FOLDER replaces docs; NAME selects surfaces.
#
#   scripts/build.sh && scripts/surfaces.sh [FOLDER [NAME...]]
set -euo pipefail
exec "$(dirname "${BASH_SOURCE[0]}")/page.sh" surfaces_gallery pvpython scripts/surfaces_gallery.py scripts/pictures/draw_surfaces.py "$@"
