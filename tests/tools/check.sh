#!/bin/sh
# Everything: `make check` runs this from the repository's root: check.sh BUILD
#
# Each step is a line; what it said is in BUILD/check/STEP.log, and its end is shown when it fails.
# The last line counts the steps. Configurations are built side by side in BUILD/check/.
out=$1/check
mkdir -p "$out"
passed=0 failed=0 skipped=0

# step NAME COMMAND...: status 0 passed, 77 skipped, anything else failed
step() {
    name=$1
    shift
    printf '%-28s' "$name"
    started=$(date +%s)
    "$@" >"$out/$name.log" 2>&1
    status=$?
    seconds=$(($(date +%s) - started))
    case $status in
    0)
        passed=$((passed + 1))
        printf 'ok       %4d s  %s\n' "$seconds" "$(tail -n 1 "$out/$name.log")"
        ;;
    77)
        skipped=$((skipped + 1))
        printf 'skipped          %s\n' "$(tail -n 1 "$out/$name.log")"
        ;;
    *)
        failed=$((failed + 1))
        printf 'FAILED   %4d s  %s\n' "$seconds" "$out/$name.log"
        tail -n 30 "$out/$name.log" | sed 's/^/    /'
        ;;
    esac
}

configuration() {
    build=$1
    shift
    make BUILD="$out/$build" WERROR=1 "$@"
}

# One picture: all lists of scene hashes are the same.
same_hashes() {
    # empty where the processor has not the width
    # shellcheck disable=SC2046 # paths without spaces
    set -- $(find "$out" -path '*/test/*.scenes' -size +0)
    for list; do
        diff "$1" "$list" || { echo "$list differs from $1" && return 1; }
    done
    echo "$(wc -l <"$1") pictures, the same in $# lists of builds and widths"
    [ -s "$1" ]
}

# The golden frames on another processor. Of the libraries only xxhash's header is needed.
aarch64() {
    mkdir -p "$out/include" && ln -sf /usr/include/xxhash.h "$out/include/" || return 1
    configuration aarch64 CC=aarch64-linux-gnu-gcc CXX= ARCH=aarch64 LDFLAGS=-static \
        CPPFLAGS="-isystem $(cd "$out/include" && pwd)" EMULATOR=qemu-aarch64 test-golden
}

# Lines of stdin as commands, as many at once as there are processors.
side_by_side() {
    xargs -P "$(nproc)" -I '{}' sh -c '{}'
}

# The same bytes from 1 to 7 ranks, whichever of them dies.
ranks() {
    configuration gcc-O2 CC=gcc CXX=g++ OPT=-O2 mpi &&
        GP_TEST_MPI=all sh tests/tools/mpi.sh "$out/gcc-O2/bin/glasspipe" "$out/gcc-O2/bin/glasspipe-mpi"
}

# Every value of every one-argument function, every blend, every code: minutes, not seconds.
exhaustive() {
    for source in tests/kernel/check_*.c; do
        program=$out/gcc-O2/test/$(basename "$source" .c)
        configuration gcc-O2 CC=gcc CXX=g++ OPT=-O2 "$program" >&2 || return 1
        echo "$program >$program.log"
    done >"$out/exhaustive.txt"
    side_by_side <"$out/exhaustive.txt" || return 1
    echo "$(wc -l <"$out/exhaustive.txt") programs"
}

# Both executors on 200,000 random frames.
differential() {
    program=$out/gcc-O2/test/differential
    configuration gcc-O2 CC=gcc CXX=g++ OPT=-O2 "$program" >&2 || return 1
    seq 0 20000 199999 | while read -r first; do
        echo "$program $first..$((first + 19999)) >$out/seeds-$first.log"
    done | side_by_side
    grep -h '^not ok' "$out"/seeds-*.log
    tail -qn 1 "$out"/seeds-*.log | awk '{ passed += $1; failed += $3 }
        END { print passed " passed, " failed " failed"; exit failed > 0 || passed != 200000 }'
}

peer() {
    configuration gcc-O2 CC=gcc CXX=g++ OPT=-O2 check-peer >"$out/peer.txt" || {
        cat "$out/peer.txt"
        return 1
    }
    cat "$out/peer.txt"
    ! grep '^skipped:' "$out/peer.txt" || return 77
}

step lint configuration gcc-O2 CC=gcc CXX=g++ OPT=-O2 lint
for compiler in gcc/g++ clang/clang++; do
    for level in 0 2 3; do
        name=${compiler%/*}-O$level
        step "$name" configuration "$name" CC="${compiler%/*}" CXX="${compiler#*/}" \
            OPT="-O$level" scene-hashes test
    done
done
for side in 16 32; do
    step "tile-$side" configuration "tile-$side" CC=gcc CXX=g++ CPPFLAGS="-DGP_TILE=$side" \
        scene-hashes test-golden differential SEEDS=0..1999
done
step aarch64-scenes env WERROR=1 sh tests/tools/aarch64_program.sh "$out" scene-hashes
step one-picture same_hashes
step sanitizers configuration sanitizers OPT=-O1 SANITIZE=address,undefined \
    GP_TEST_EVERY_BYTE=1 TEST_SECONDS=3600 test
# without WERROR: instrumented, gcc 12 takes vectors that are set lane by lane for unset ones
step threads make BUILD="$out/threads" OPT=-O1 SANITIZE=thread differential SEEDS=0..299
step threads-test env TEST_SECONDS=3600 make BUILD="$out/threads" OPT=-O1 SANITIZE=thread \
    SEEDS=0..299 test
step aarch64 aarch64
step exhaustive-mathematics exhaustive
step differential differential
step fuzz make fuzz FUZZ_S=60
step soak configuration gcc-O2 CC=gcc CXX=g++ OPT=-O2 soak SOAK_S=600
step many-processes sh tests/tools/many_processes.sh "$out/gcc-O2/bin/glasspipe" 64
step ranks ranks
step valgrind sh tests/tools/valgrind.sh "$out/gcc-O2/bin/glasspipe"
step matrix make matrix BUILD="$1" WERROR=1 PICTURES=6
step faults configuration gcc-O2 CC=gcc CXX=g++ OPT=-O2 faults MOST=100
step exhaustive-tests env GP_TEST_FANS=1000000 GP_TEST_ALL_BLENDS=1 GP_TEST_BUNNY_WINDOW=1 \
    GP_TEST_PRINTED=1 GP_TEST_INSPECT=1 GP_TEST_LARGE=1 \
    GP_TEST_PROMISES="$(date +%s)" GP_TEST_FRAGMENT_VIEWS=100 \
    TEST_SECONDS=3600 make BUILD="$out/gcc-O2" CC=gcc CXX=g++ OPT=-O2 WERROR=1 test
for name in gcc-O0 gcc-O2 gcc-O3 clang-O0 clang-O2 clang-O3 aarch64; do
    step "code-$name" sh tests/tools/check_code.sh "$out/$name"
done
step docs sh tests/tools/docs.sh "$out/gcc-O2/include" tests/tools/docs.awk "$out/docs"
step install sh tests/tools/check_install.sh "$out/gcc-O2"
step peer peer
# the longest last
for cpu in Nehalem Haswell-noTSX; do
    step "as-$cpu" env TEST_SECONDS=7200 make BUILD="$out/gcc-O2" CC=gcc CXX=g++ OPT=-O2 WERROR=1 \
        EMULATOR="qemu-x86_64 -cpu $cpu" SEEDS=0..299 test
done

echo "$passed passed, $failed failed, $skipped skipped"
[ "$failed" = 0 ]
