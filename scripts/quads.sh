#!/usr/bin/env bash
# Meshes the domains of the gallery of quads, draws them and writes the page docs/quads.md, with pictures in
# docs/quads/. For a test another folder than docs may be given, and some of the domains.
#
#   scripts/build.sh && scripts/quads.sh [FOLDER [NAME...]]
set -euo pipefail
exec "$(dirname "${BASH_SOURCE[0]}")/page.sh" quads python3 scripts/quads_gallery.py scripts/pictures/draw_quads.py "$@"
