#!/bin/sh
# The hash of every scene and of volumes: scene_hashes.sh PROGRAM
#
# One line a scene, its name and what `render` printed, at a small size; then the shadow scenes as
# `shadow` draws them, by each method that goes with their lights; then volumes as `voxelize` makes
# them, by each method. $GP_ISA chooses the shader code; nothing is printed where the processor has not.
# Leaves out scenes whose data is not there. Exit status 1 if a scene fails.
program=$1
data=${GLASSPIPE_DATA:-../shared/data}
picture=$(mktemp -d)
trap 'rm -rf "$picture"' EXIT

echo '{ "objects": [] }' >"$picture/empty.json"
if ${EMULATOR:-} "$program" render "$picture/empty.json" -o "$picture/empty.ppm" 2>&1 |
    grep "isa .* does not have it" >&2; then
    exit 0
fi

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

# volume OPTION...: one line
volume() {
    hash=$(${EMULATOR:-} "$program" voxelize -q "$@" -o "$picture/volume.nrrd" builtin:knot) || {
        echo "builtin:knot failed with $GP_ISA: $*" >&2
        exit 1
    }
    echo "knot voxelize $* $(printf '%s' "$hash" | tr '\n' ' ')"
}

volume -n 100
volume -n 130 --method thin
volume -n 150 --kind solid
volume -n 64 --method sheets
volume -n 40 --method sheets --bits 8
volume -n 40 --method sheets --kind solid
volume -n 64 --method slices
volume -n 64 --method ldi
volume -n 64 --method faces --kind solid
