#!/bin/sh
# One table of builds and processors against pictures: `make matrix` runs this from the root: matrix.sh OUT
#
# Configurations: BUILDS (compiler-level, tile-SIDE, plain without intrinsics, aarch64), each on PROCESSORS
# (this one, and by qemu-user Nehalem with SSE2 only and Haswell with AVX2; ARM's program by qemu-aarch64), at
# each lane width that build and processor have (-O1 and tiles are built with one alone), on 1 and 3 threads,
# and by the reference executor. Pictures: scenes and techniques, so many of each command of
# tests/golden/pictures.txt (PICTURES, default 2; EMULATED of them where a processor is emulated, default 1).
# Builds lie where `make check` has them, and are shared.
#
#     make matrix BUILDS='gcc-O2 clang-O0' PROCESSORS='here Nehalem' PICTURES=4
#
# Every picture's hash is held against the golden list, and the bytes of some pages of `glasspipe inspect`
# against those of the first build. One line for each build and processor, or why it was left out; then the
# count of configurations, of pictures drawn, and of differences. Exit status 1 where there is any.
out=$1
builds=${BUILDS:-gcc-O2 clang-O2 gcc-O0 clang-O0 gcc-O1 clang-O1 gcc-O3 clang-O3 tile-16 tile-32 plain aarch64}
processors=${PROCESSORS:-here Nehalem Haswell-noTSX}
mkdir -p "$out"
here=$(mktemp -d)
trap 'rm -rf "$here"' EXIT

# Pictures of built-in data, so that each is there everywhere: command = hash. As many of each command, evenly.
for list in here:"${PICTURES:-2}" emulated:"${EMULATED:-1}"; do
    awk -v most="${list#*:}" '
        / = / && !/meshes\/|points\/|volumes\/|images\/|^bench/ { line[++all] = $0; total[$1]++ }
        END {
            for (i = 1; i <= all; i++) {
                split(line[i], word)
                n = of[word[1]]++
                if (int(n * most / total[word[1]]) != int((n - 1) * most / total[word[1]]) || n == 0) print line[i]
            }
        }
    ' tests/golden/pictures.txt >"$here/pictures.${list%:*}"
done

build() { # NAME: the program, built
    name=$1
    case $name in
    gcc-O* | clang-O*)
        set -- CC="${name%-O*}" CXX="$(echo "${name%-O*}" | sed 's/gcc/g++/;s/clang/clang++/')" OPT="-O${name#*-O}"
        [ "${name#*-O}" != 1 ] || set -- "$@" ISAS=4:sse2:
        ;;
    tile-*) set -- CC=gcc CXX=g++ ISAS=4:sse2: CPPFLAGS="-DGP_TILE=${name#tile-}" ;;
    plain) set -- CC=gcc CXX=g++ ISAS="4:generic: 8:generic: 16:generic:" CPPFLAGS=-DGP_PLAIN_LANES ;;
    aarch64)
        sh tests/tools/aarch64_program.sh "$out" program >"$here/log" 2>&1
        return
        ;;
    esac
    make BUILD="$out/$name" WERROR="${WERROR:-}" "$@" program >"$here/log" 2>&1
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
    done <"$here/pictures.$kind" >>"$here/counts"
}

# pages EMULATOR PROGRAM: bytes of pages, which are no pictures, but counted with them
pages() {
    while IFS= read -r page; do
        # shellcheck disable=SC2086 # words
        $1 "$2" inspect -q --no-timings --size 64x48 --pixels 12 $page -o "$here/page.html" 2>"$here/error"
        sum=$(cksum <"$here/page.html")
        rm -f "$here/page.html"
        grep -q "^$page = " "$here/pages" 2>/dev/null || echo "$page = $sum" >>"$here/pages"
        if grep -qxF "$page = $sum" "$here/pages"; then
            echo same
        else
            echo "differs: $name $processor: inspect $page"
        fi
    done >>"$here/counts" <<EOF
scenes/default.json
scenes/shadow.json --technique shadow --method plain
builtin:knot --technique points
EOF
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

left_out() { # BUILD PROCESSOR REASON
    printf '%-10s %-14s left out: %s\n' "$1" "$2" "$3"
    missed=$((missed + 1))
}

printf '%-10s %-14s %-22s %9s %9s %12s %6s\n' build processor lanes runs pictures differences s
configurations=0 drawn=0 differences=0 missed=0
for name in $builds; do
    compiler=${name%-O*}
    case $name in
    tile-* | plain) compiler=gcc ;;
    aarch64) compiler=aarch64-linux-gnu-gcc ;;
    esac
    command -v "$compiler" >/dev/null || { left_out "$name" all "$compiler is not installed"; continue; }
    build "$name" || { tail -n 5 "$here/log"; echo "$name: not built"; differences=$((differences + 1)); continue; }
    for processor in $processors; do
        started=$(date +%s)
        emulator=
        program=$out/$name/bin/glasspipe
        kind=here
        [ "$processor" = here ] || { kind=emulated; emulator="qemu-x86_64 -cpu $processor"; }
        if [ "$name" = aarch64 ]; then
            [ "$processor" = here ] || continue
            program=$out/aarch64-program/bin/glasspipe
            processor=ARM kind=emulated
            emulator="qemu-aarch64 -L /usr/aarch64-linux-gnu"
        fi
        [ -z "$emulator" ] || command -v "${emulator%% *}" >/dev/null ||
            { left_out "$name" "$processor" "${emulator%% *} is not installed"; continue; }
        : >"$here/counts"
        lanes='' runs=0
        for width in lanes4 lanes8 lanes16; do
            runs "$emulator" "$program" "$width" || continue
            lanes="$lanes$width "
            GP_ISA=$width
            export GP_ISA
            for options in "--threads 1" "--threads 3" "--executor reference"; do
                # which is the same text at every width
                [ "$options" = "--executor reference" ] && [ "$lanes" != "$width " ] && continue
                runs=$((runs + 1))
                draws "$emulator" "$program"
            done
            unset GP_ISA
        done
        [ "$kind" = emulated ] || pages "$emulator" "$program"
        wrong=$(grep -c '^differs' "$here/counts")
        all=$(wc -l <"$here/counts")
        grep -h '^differs' "$here/counts" | head -n 5
        printf '%-10s %-14s %-22s %9d %9d %12d %6d\n' "$name" "$processor" "$lanes" "$runs" "$all" "$wrong" \
            $(($(date +%s) - started))
        configurations=$((configurations + runs)) drawn=$((drawn + all)) differences=$((differences + wrong))
    done
done
echo "$configurations configurations, $(wc -l <"$here/pictures.here") pictures each ($(wc -l <"$here/pictures.emulated")" \
    "where emulated), $drawn drawn, $missed left out, $differences differences"
[ "$differences" = 0 ] && [ "$drawn" -gt 0 ]
