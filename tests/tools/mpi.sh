#!/bin/sh
# The same bytes from ranks as from one process, and what becomes of a run whose ranks die:
#
#   mpi.sh PROGRAM [MPI_PROGRAM]    without the latter all is skipped
#
# A small part; with $GP_TEST_MPI=all as much as was asked: 200 scenes, 100 frames, a picture of 16384 x
# 16384, a rank killed at 50 moments. Speaks TAP.
program=$(realpath "$1") ranked=${2:+$(realpath "$2")}
. tests/tools/tap.sh
if [ -z "$ranked" ]; then
    skip "ranks draw what one process draws" "no mpicc and mpirun here: make deps-mpi installs them"
    echo "1..$count"
    exit 0
fi
scenes=$(realpath scenes)
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder" || exit 1
if [ -n "${GP_TEST_MPI:-}" ]; then
    copies=200 last=99 kills=50 many='1 2 3 4 7' large=16384x16384
else
    copies=9 last=5 kills=2 many=3 large=8320x256
fi

# ranks K ARGUMENT...: on this machine, as root too, whatever its processors
ranks() {
    number=$1
    shift
    OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1 \
        ${MPIRUN:-mpirun} -q --oversubscribe -n "$number" "$ranked" "$@"
}

# Text without what differs from run to run.
timeless() {
    sed 's/; [0-9.]* s$//'
}

# --- a folder of scenes ---
mkdir golden
i=0
while [ $i -lt $copies ]; do
    for name in toon near_clip point_sprites sorted stencil_outline two_sided_stencil alpha_blend scissor; do
        [ $i -lt $copies ] || break
        cp "$scenes/$name.json" "golden/s$i.json"
        i=$((i + 1))
    done
done
cp -r "$scenes/models" golden/
"$program" test golden --size 96x80 --json >drawn.json 2>/dev/null
for scene in golden/*.json; do
    name=$(basename "$scene" .json)
    [ "$name" = s1 ] || "$program" render "$scene" --size 96x80 -q -o one.png >"golden/$name.hash"
done
sed -i 's/[0-9a-f]$/x/' golden/s2.hash
"$program" test golden --size 96x80 -v | timeless >one.txt
for k in $many; do
    ranks "$k" test golden --size 96x80 -v >ranks.log 2>&1
    code=$?
    timeless <ranks.log | cmp one.txt - >differ.log 2>&1 && [ $code = 1 ]
    tried $? "$k ranks: a folder of $copies scenes has the same results" differ.log
done

# --- frames ---
cat >path.json <<'END'
{ "rate": 10, "keys": [
  { "time": 0, "camera": { "eye": [0.4, 2.3, 6] }, "objects": { "teapot": { "material": { "diffuse": [1, 0.2, 0.2] } } } },
  { "time": 0.3, "camera": { "eye": [3, 2, 5] } },
  { "time": 9.9, "camera": { "eye": [-4, 3, 4] }, "objects": { "teapot": { "material": { "diffuse": [0.1, 0.2, 0.9] } } } } ] }
END
mkdir one
"$program" render "$scenes/toon.json" --path path.json --frames "0:$last" --size 128x96 \
    -o 'one/f_####.png' >one.txt 2>/dev/null
for k in $many; do
    mkdir ranks
    ranks "$k" render "$scenes/toon.json" --path path.json --frames "0:$last" --size 128x96 \
        -o 'ranks/f_####.png' >ranks.txt 2>ranks.log
    { cmp one.txt ranks.txt && diff -r one ranks; } >differ.log 2>&1
    tried $? "$k ranks: $((last + 1)) frames are the same files" differ.log
    rm -r ranks
done

# --- one picture, by windows ---
"$program" render "$scenes/together.json" --size 640x384 -o one.png >one.txt 2>/dev/null
"$program" render "$scenes/default.json" --size $large -o large.png >large.txt 2>/dev/null
for k in $many; do
    ranks "$k" render "$scenes/together.json" --size 640x384 -o ranks.png >ranks.txt 2>ranks.log
    { cmp one.txt ranks.txt && cmp one.png ranks.png; } >differ.log 2>&1
    tried $? "$k ranks: one picture by windows is the same file" differ.log
done
ranks 3 render "$scenes/default.json" --size $large -o ranks.png >ranks.txt 2>ranks.log
{ cmp large.txt ranks.txt && cmp large.png ranks.png; } >differ.log 2>&1
tried $? "3 ranks: a picture of $large in strips is the same file" differ.log

# --- errors of a chart, of which times are another matter ---
errors() {
    grep -E '"(method|options|error)":'
}
set -- chart shadow "$scenes/shadow.json" --size 96x64 --map 64,256 --method plain,hardware -t 0.01 -o charts --json
"$program" "$@" 2>/dev/null | errors >one.txt
for k in $many; do
    ranks "$k" "$@" 2>ranks.log | errors >ranks.txt
    { [ -s one.txt ] && cmp one.txt ranks.txt; } >differ.log 2>&1
    tried $? "$k ranks: a chart has the same errors" differ.log
done

# --- ranks that are not alike ---
OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1 ${MPIRUN:-mpirun} -q --oversubscribe \
    -n 1 "$ranked" render "$scenes/together.json" --size 640x384 --threads 1 -o ranks.png : \
    -n 1 env GP_ISA=sse2 "$ranked" render "$scenes/together.json" --size 640x384 --threads 3 -o ranks.png : \
    -n 1 "$ranked" render "$scenes/together.json" --size 640x384 --threads 2 --executor reference -o ranks.png \
    >ranks.txt 2>ranks.log
cmp one.png ranks.png >differ.log 2>&1
tried $? "ranks with other instruction sets, threads and executors: the same file" differ.log

ranks 3 render "$scenes/together.json" --size 640x384 -o ranks.png --verify 100 >ranks.txt 2>ranks.log &&
    cmp one.png ranks.png >>ranks.log 2>&1
tried $? "3 ranks: each window drawn twice is the same" ranks.log

# --- what is wrong ---
ranks 3 render none.json --turn 4 -o 'f_#.png' >ranks.txt 2>ranks.log
code=$?
[ $code = 3 ] && [ "$(grep -c '^glasspipe: .*none.json: no such file' ranks.log)" = 1 ] &&
    [ "$(wc -l <ranks.log)" = 1 ]
tried $? "3 ranks: a scene that is missing is told once, and is exit code 3" ranks.log
OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1 ${MPIRUN:-mpirun} -q --oversubscribe \
    -n 1 "$ranked" render "$scenes/toon.json" --turn 9 --size 96x64 -o 'f_#.png' : \
    -n 1 "$ranked" render none.json --turn 9 --size 96x64 -o 'f_#.png' >ranks.txt 2>ranks.log
[ $? = 3 ] && [ "$(grep -c '^glasspipe: frame [0-9], rank 1 on .*: none.json: no such file' ranks.log)" = 1 ]
tried $? "a scene that one rank cannot read is told once, with the rank, and is exit code 3" ranks.log
ranks 3 render --no-such-option >ranks.txt 2>ranks.log
[ $? = 2 ] && [ "$(grep -c 'no-such-option' ranks.log)" = 1 ]
tried $? "3 ranks: a wrong option is told once, and is exit code 2" ranks.log
ranks 2 compare one.png ranks.png >ranks.txt 2>ranks.log && [ "$(wc -l <ranks.txt)" -lt 10 ]
tried $? "2 ranks: a command without items is run once" ranks.log

# --- a rank that dies ---
kill_one() { # MOMENT
    rm -rf ranks && mkdir ranks
    ranks 3 render "$scenes/toon.json" --path path.json --frames 0:59 --size 640x480 --threads 1 \
        -o 'ranks/f_####.png' >ranks.txt 2>ranks.log &
    run=$! waited=0
    while [ $waited -lt 200 ] && [ ! -e 'ranks/f_####.png.journal' ] && [ $(($2 % 10)) != 9 ]; do
        sleep 0.05
        waited=$((waited + 1))
    done
    sleep "$1"
    # the ranks are children of mpirun, which is this shell's, or its function's
    mpi=$(pgrep -P $run | head -1)
    victims=$(pgrep -P "${mpi:-0}" glasspipe; pgrep -P $run glasspipe)
    victim=$(echo "$victims" | sed -n "$(($2 % 3 + 1))p")
    [ -z "$victim" ] || kill -9 "$victim" 2>/dev/null
    wait $run
    ended=$?
    [ -z "$victim" ] && return 2
    [ $ended != 0 ] || return 2
    ls -A ranks | grep tmp && return 1
    for file in ranks/*.png; do
        [ ! -e "$file" ] || cmp "$file" "whole/$(basename "$file")" || return 1
    done
    # before the ranks know of each other nobody can say who died, and nothing was begun
    [ ! -e 'ranks/f_####.png.journal' ] || {
        begun=$((begun + 1))
        grep -q '^glasspipe: rank [0-9]* on .*ended; --resume' ranks.log || return 1
    }
    ranks 3 render "$scenes/toon.json" --path path.json --frames 0:59 --size 640x480 --threads 1 \
        -o 'ranks/f_####.png' --resume >ranks.txt 2>>ranks.log || return 1
    diff -r whole ranks && cmp whole.txt ranks.txt
}
mkdir whole
"$program" render "$scenes/toon.json" --path path.json --frames 0:59 --size 640x480 \
    -o 'whole/f_####.png' >whole.txt 2>/dev/null
moment=0 late=0 begun=0 log=
while [ $moment -lt $kills ]; do
    kill_one "0.$((moment * 7 % 5))$((moment * 3 % 10 + 1))" $moment >differ.log 2>&1
    status=$?
    [ $status != 2 ] || late=$((late + 1))
    [ $status != 1 ] || log="$log $moment"
    [ $status != 1 ] || { cat ranks.log >>differ.log; cp differ.log failed.log; }
    moment=$((moment + 1))
done
[ -z "$log" ] || { echo "moments:$log" >>failed.log; }
[ -z "$log" ] && [ $late -lt $kills ]
tried $? "a rank killed at $kills moments ($begun of them after the first frame, $late after the end): no half file, named, and --resume goes on" \
    "$([ -e failed.log ] && echo failed.log || echo differ.log)"
echo "1..$count"
exit $failed
