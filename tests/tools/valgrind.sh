#!/bin/sh
# A few commands under valgrind, which sees what was never set: valgrind.sh PROGRAM
#
# Lanes of SSE2, and of AVX2: it knows no more. Skipped (77) where it is not installed.
program=$(realpath "$1")
command -v valgrind >/dev/null || { echo "valgrind is not installed (make deps)"; exit 77; }
here=$(mktemp -d)
trap 'rm -rf "$here"' EXIT
cd "$here" || exit 4
echo '{ "lights": [ { "direction": [1, -2, -1] } ], "objects": [ { "mesh": "builtin:cube" } ] }' >scene.json
runs=0
for isa in sse2 avx2; do
    for line in "render scene.json --size 24x16 -o a.png" "shadow scene.json --size 24x16 --map 32 -o a.exr" \
        "voxelize builtin:cube -n 16 -o a.nrrd" "points builtin:cube --size 24x16 -o a.ppm" \
        "fragments builtin:cube --size 24x16 -o a.pfm" "pixel scene.json 12 8" "explain scene.json --json"; do
        # shellcheck disable=SC2086 # words
        GP_ISA=$isa valgrind -q --error-exitcode=99 --leak-check=full --errors-for-leak-kinds=definite \
            "$program" $line >said 2>error || {
            echo "$isa: $line"
            head -n 30 error
            exit 1
        }
        runs=$((runs + 1))
    done
done
echo "$runs commands, nothing unset and nothing lost"
