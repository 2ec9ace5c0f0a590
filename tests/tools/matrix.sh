#!/bin/sh
# One table of builds and processors against pictures: `make matrix` runs this from the root: matrix.sh OUT
#
# Configurations: BUILDS (compiler-level, tile-SIDE, aarch64), each on processors (this one, and by qemu-user
# Nehalem with SSE2 only, Haswell with AVX2, and ARM), at each lane width that build and processor have, on 1
# and 3 threads, and by the reference executor. Pictures: scenes and techniques, PICTURES or all of
# tests/golden/pictures.txt that take a moment. Builds lie where `make check` has them, and are shared.
#
#     make matrix BUILDS='gcc-O2 clang-O0' PROCESSORS='here Nehalem' PICTURES=4
#
# Every picture's hash is held against the golden list. One line for each build and processor, then the
# count of configurations, of pictures drawn, and of differences. Exit status 1 where there is any.
out=$1
builds=${BUILDS:-gcc-O0 gcc-O1 gcc-O2 gcc-O3 clang-O0 clang-O1 clang-O2 clang-O3 tile-16 tile-32 tile-128 aarch64}
processors=${PROCESSORS:-here Nehalem Haswell-noTSX}
mkdir -p "$out"
here=$(mktemp -d)
trap 'rm -rf "$here"' EXIT

# Pictures of built-in data, so that each is there everywhere: command = hash.
awk -v most="${PICTURES:-1000}" '
    / = / && !/meshes\/|points\/|volumes\/|images\/|^bench/ { of[$1]++; if (of[$1] <= most) print }
' tests/golden/pictures.txt >"$here/pictures"

build() { # NAME: the program, built
    name=$1
    case $name in
    gcc-O* | clang-O*)
        set -- CC="${name%-O*}" CXX="$(echo "${name%-O*}" | sed 's/gcc/g++/;s/clang/clang++/')" OPT="-O${name#*-O}"
        ;;
    tile-*) set -- CC=gcc CXX=g++ CPPFLAGS="-DGP_TILE=${name#tile-}" ;;
    aarch64) return ;;
    esac
    make BUILD="$out/$name" WERROR=1 "$@" program >"$here/log" 2>&1 || { tail -n 5 "$here/log"; return 1; }
}

# Whether all data is there that a picture needs.
is_there() {
    scene=$(echo "$1" | grep -o 'scenes/[^ ]*\.json')
    [ -d "${GLASSPIPE_DATA:-../shared/data}" ] || [ -z "$scene" ] ||
        ! grep -qE '"(meshes|images|points|volumes)/' "$scene"
}

# draws EMULATOR PROGRAM: every picture at the width and options that are set; counts into $here/counts
draws() {
    while IFS= read -r line; do
        command=${line% = *}
        is_there "$command" || continue
        # shellcheck disable=SC2086 # words
        got=$($1 "$2" ${command%% *} -q $options ${command#* } -o "$here/picture.$(extension "$command")" 2>"$here/error" |
            head -n 1)
        case ${line#* = } in
        "${got:-nothing}"*) echo same ;;
        *) echo "differs: $name $processor $width $options: $command: $got" ;;
        esac
    done <"$here/pictures" >>"$here/counts"
}

extension() {
    case $1 in
    voxelize*--picture*) echo ppm ;;
    voxelize*) echo nrrd ;;
    *) echo ppm ;;
    esac
}

runs() { # EMULATOR PROGRAM WIDTH: whether there are such lanes
    echo '{ "objects": [] }' >"$here/empty.json"
    GP_ISA=$3 $1 "$2" render -q "$here/empty.json" --size 8x8 -o "$here/empty.ppm" >"$here/said" 2>&1
}

printf '%-10s %-14s %-22s %9s %9s %12s\n' build processor lanes runs pictures differences
configurations=0 drawn=0 differences=0
for name in $builds; do
    build "$name" || { echo "$name: not built"; differences=$((differences + 1)); continue; }
    for processor in $processors; do
        emulator=
        program=$out/$name/bin/glasspipe
        [ "$processor" = here ] || emulator="qemu-x86_64 -cpu $processor"
        if [ "$name" = aarch64 ]; then
            program=$out/aarch64-program/bin/glasspipe
            emulator="qemu-aarch64 -L /usr/aarch64-linux-gnu"
            [ "$processor" = here ] && [ -x "$program" ] || continue
        fi
        : >"$here/counts"
        lanes='' runs=0
        for width in lanes4 lanes8 lanes16; do
            runs "$emulator" "$program" "$width" || continue
            lanes="$lanes$width "
            for options in "--threads 1" "--threads 3" "--executor reference"; do
                runs=$((runs + 1))
                GP_ISA=$width
                export GP_ISA
                draws "$emulator" "$program"
                unset GP_ISA
            done
        done
        wrong=$(grep -c '^differs' "$here/counts")
        all=$(wc -l <"$here/counts")
        grep -h '^differs' "$here/counts" | head -n 5
        printf '%-10s %-14s %-22s %9d %9d %12d\n' "$name" "$processor" "$lanes" "$runs" "$all" "$wrong"
        configurations=$((configurations + runs)) drawn=$((drawn + all)) differences=$((differences + wrong))
    done
done
echo "$configurations configurations, $(wc -l <"$here/pictures") pictures each, $drawn drawn, $differences differences"
[ "$differences" = 0 ] && [ "$drawn" -gt 0 ]
