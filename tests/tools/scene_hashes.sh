#!/bin/sh
# The hash of every scene: scene_hashes.sh PROGRAM
#
# One line a scene, its name and what `render` printed, at a small size; then the shadow scenes as
# `shadow` draws them, by each method that goes with their lights. $GP_ISA chooses the shader code.
# Leaves out scenes whose data is not there. Exit status 1 if a scene fails.
program=$1
data=${GLASSPIPE_DATA:-../shared/data}
picture=$(mktemp -d)
trap 'rm -rf "$picture"' EXIT

# draw SCENE COMMAND [OPTION...]: one line
draw() {
    file=$1
    shift
    if [ ! -d "$data" ] && grep -qE '"(meshes|images|points|volumes)/' "$file"; then
        return
    fi
    hash=$(${EMULATOR:-} "$program" "$@" -q --size 256x256 -o "$picture/picture.ppm" "$file") || {
        echo "$file failed with $GP_ISA: $*" >&2
        exit 1
    }
    echo "$(basename "$file" .json) $* $hash"
}

for scene in scenes/*.json; do
    draw "$scene" render
done
for scene in scenes/shadow*.json; do
    draw "$scene" shadow --method hardware
done
for scene in shadow shadow_soft shadow_bunny; do
    draw "scenes/$scene.json" shadow --method plain
done
draw scenes/shadow_soft.json shadow --method plain --filter soft
