#!/bin/sh
# The hash of every scene: scene_hashes.sh PROGRAM
#
# One line a scene, its name and what `render` printed, at a small size. $GP_ISA chooses the shader
# code. Leaves out scenes whose data is not there. Exit status 1 if a scene fails.
program=$1
data=${GLASSPIPE_DATA:-../shared/data}
picture=$(mktemp -d)
trap 'rm -rf "$picture"' EXIT

for scene in scenes/*.json; do
    if [ ! -d "$data" ] && grep -qE '"(meshes|images|points|volumes)/' "$scene"; then
        continue
    fi
    hash=$(${EMULATOR:-} "$program" render -q --size 256x256 -o "$picture/picture.ppm" "$scene") || {
        echo "$scene failed with $GP_ISA" >&2
        exit 1
    }
    echo "$(basename "$scene" .json) $hash"
done
