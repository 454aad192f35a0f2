#!/usr/bin/env bash
# Meshes and draws the domains of the gallery of quads and writes the page docs/quads.md, with
# pictures in docs/quads/. FOLDER replaces docs; NAME selects domains.
#
#   scripts/build.sh && scripts/quads.sh [FOLDER [NAME...]]
set -euo pipefail
exec "$(dirname "${BASH_SOURCE[0]}")/page.sh" quads python3 scripts/quads_gallery.py scripts/pictures/draw_quads.py "$@"
