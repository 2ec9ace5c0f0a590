#!/bin/sh
# Pages of `glasspipe inspect` in a browser, where Chromium and Python are: inspect_pages.sh PROGRAM [lessons]
#
# Some scenes, whose pages have most of what there is, or some lessons; with $GP_TEST_INSPECT all of scenes/ and
# frames of every technique, or all lessons. Speaks TAP.
program=$1
. tests/tools/tap.sh
if [ -n "${EMULATOR:-}" ] || ! command -v chromium >/dev/null || ! command -v python3 >/dev/null; then
    skip "pages show what the trace has" "chromium and python3 are not both here"
    echo "1..$count"
    exit 0
fi
[ "${2:-}" = lessons ] && exec python3 tests/tools/lesson_pages.py "$program"
# Scenes by their files, frames of techniques by what follows `glasspipe inspect`.
set -- scenes/near_clip.json scenes/stencil_outline.json scenes/sorted.json \
    'builtin:teapot --technique fragments --method dp --size 64x48 --pixels 20'
if [ -n "${GP_TEST_INSPECT:-}" ]; then
    set -- scenes/*.json \
        'scenes/default.json --size 1280x720' \
        'scenes/together.json --size 1280x700' \
        'builtin:teapot --technique fragments --method dp --size 160x120' \
        'builtin:teapot --technique fragments --method sorted --size 160x120' \
        'builtin:teapot --technique fragments --method bucket1 --size 160x120' \
        'builtin:knot --technique points --method ewa --size 160x120' \
        'builtin:knot --technique points --method ternary --size 160x120' \
        'builtin:ball:32 --technique volume --method raycast --size 160x120' \
        'builtin:ball:32 --technique volume --method slices --size 160x120' \
        'builtin:ball:32 --technique volume --method splat --size 160x120' \
        'builtin:knot --technique warp --method layers --size 160x120' \
        'builtin:knot --technique warp --method relief --size 160x120 --pixels 40' \
        'scenes/shadow.json --technique shadow --method plain --map 512 --size 160x120' \
        'builtin:knot --technique voxelize -n 32 --pixels 60'
fi
exec python3 tests/tools/inspect_pages.py "$program" "$@"
