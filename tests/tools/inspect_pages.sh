#!/bin/sh
# Pages of `glasspipe inspect` in a browser, where Chromium and Python are: inspect_pages.sh PROGRAM
#
# Some scenes, whose pages have most of what there is; with $GP_TEST_INSPECT all of scenes/. Speaks TAP.
program=$1
. tests/tools/tap.sh
if [ -n "${EMULATOR:-}" ] || ! command -v chromium >/dev/null || ! command -v python3 >/dev/null; then
    skip "pages show what the trace has" "chromium and python3 are not both here"
    echo "1..$count"
    exit 0
fi
scenes='scenes/near_clip.json scenes/stencil_outline.json scenes/sorted.json'
[ -n "${GP_TEST_INSPECT:-}" ] && scenes=$(echo scenes/*.json)
# shellcheck disable=SC2086 # names without spaces
exec python3 tests/tools/inspect_pages.py "$program" $scenes
