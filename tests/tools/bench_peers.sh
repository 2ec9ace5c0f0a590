#!/bin/sh
# glasspipe against llvmpipe: bench_peers.sh GLASSPIPE PEER_BENCH FOLDER [CASE...]
#
# Draws every case with the one and the other in turn, a process each, so that both see the same
# machine; prints a table; leaves peers.json, the chart peers.svg and the lines of all runs in
# FOLDER. Says "skipped" where there is no EGL.
#
# ROUNDS (default 3) is how often, BENCH_SECONDS (1) how long each case is drawn by each,
# BENCH_THREADS (2) by how many threads. A run waits up to BENCH_WAIT seconds (5) for other
# processes to leave the processors alone; what they disturbed nonetheless is told apart by the
# lines' field "others".
set -eu

glasspipe=$1
peer=$2
folder=$3
shift 3
rounds=${ROUNDS:-3}
seconds=${BENCH_SECONDS:-1}
threads=${BENCH_THREADS:-2}
here=$(dirname "$0")
mkdir -p "$folder"

if ! driver=$("$peer" --driver 2>"$folder/driver.txt"); then
    echo "skipped: $(cat "$folder/driver.txt")"
    rm -f "$folder/driver.txt"
    exit 0
fi
rm -f "$folder/driver.txt"

# As many processors for both, and the same, as far as that can be had.
pin=
if [ "$(nproc)" -gt 2 ] && taskset -c 0,1 true 2>/dev/null; then
    pin="taskset -c 0,1"
fi

# Clock ticks that all processors together have worked so far.
worked() {
    awk '/^cpu / { print $2 + $3 + $4 + $7 + $8 + $9; exit }' /proc/stat 2>/dev/null || echo 0
}

wait_for_quiet() {
    left=$((${BENCH_WAIT:-5} * 10))
    while [ "$left" -gt 0 ]; do
        before=$(worked)
        sleep 0.1
        [ $(($(worked) - before)) -gt 2 ] || break
        left=$((left - 1))
    done
}

# One line of JSON to a file, or a message; failures are counted, not fatal.
failures=0
run() {
    lines=$1
    shift
    wait_for_quiet
    # shellcheck disable=SC2086 # pin is several words, or none
    $pin "$@" >>"$lines" || {
        echo "failed: $*" >&2
        failures=$((failures + 1))
    }
}

our_cases=" $("$glasspipe" bench -l | xargs) "
cases=
# shellcheck disable=SC2046 # names without spaces
[ $# -gt 0 ] || set -- $(sed '/^mean /d; s/[# ].*//' "$here/../peer/bench/cases.txt")
for case in "$@"; do
    case $our_cases in
    *" $case "*) cases="$cases $case" ;;
    *) echo "glasspipe has no case $case" >&2 ;;
    esac
done

rm -f "$folder/peers.json" "$folder/peers.svg"
: >"$folder/llvmpipe.jsonl"
: >"$folder/glasspipe.jsonl"
round=0
while [ "$round" -lt "$rounds" ]; do
    round=$((round + 1))
    floor= # found in the last round
    [ "$round" -lt "$rounds" ] || floor=--floor
    for case in $cases; do
        [ ! -t 2 ] || printf '\r%d of %d: %-20s' "$round" "$rounds" "$case" >&2
        run "$folder/llvmpipe.jsonl" "$peer" --threads "$threads" -t "$seconds" "$case"
        # shellcheck disable=SC2086 # floor is a word, or none
        run "$folder/glasspipe.jsonl" "$glasspipe" bench --threads "$threads" \
            -t "$seconds" $floor "$case"
    done
done
[ ! -t 2 ] || printf '\r%40s\r' '' >&2

processor=$(sed -n 's/^model name[^:]*: //p' /proc/cpuinfo | head -n 1)
awk -v date="$(date -u '+%Y-%m-%d %H:%M UTC')" -v threads="$threads" -v rounds="$rounds" \
    -v machine="$(nproc) x ${processor:-$(uname -m)}, $(uname -sm)" -v peer="$driver" \
    -v version="$("$glasspipe" --version | head -n 1)" -v json="$folder/peers.json" \
    -f "$here/bench_peers.awk" \
    "$here/../peer/bench/cases.txt" "$folder/llvmpipe.jsonl" "$folder/glasspipe.jsonl" ||
    failures=$((failures + 1))
[ -s "$folder/peers.json" ] || exit 1
"$peer" --chart "$folder/peers.json" >"$folder/peers.svg"
echo "$folder/peers.json, $folder/peers.svg"
[ "$failures" -eq 0 ]
