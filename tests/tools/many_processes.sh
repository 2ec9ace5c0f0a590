#!/bin/sh
# Many of the program at once: many_processes.sh PROGRAM [COUNT]: all end well, with the same hash.
program=$(realpath "$1")
count=${2:-64}
here=$(mktemp -d)
trap 'rm -rf "$here"' EXIT
echo '{ "lights": [ { "direction": [1, -2, -1] } ], "objects": [ { "mesh": "builtin:knot" } ] }' \
    >"$here/scene.json"
i=0
while [ $i -lt "$count" ]; do
    i=$((i + 1))
    (
        cd "$here" && mkdir "$i" && cd "$i" &&
            "$program" shadow ../scene.json --size 160x120 -q -o picture.png >hash 2>error
        echo $? >status
    ) &
done
wait
statuses=$(cat "$here"/*/status | sort | uniq -c | xargs)
hashes=$(cat "$here"/*/hash | sort | uniq -c | xargs)
files=$(cat "$here"/*/picture.png | cksum)
expected=$(i=0; while [ $i -lt "$count" ]; do cat "$here/1/picture.png"; i=$((i + 1)); done | cksum)
cat "$here"/*/error
echo "$count processes: exit codes $statuses; hashes $hashes"
[ "$statuses" = "$count 0" ] && [ "$(echo "$hashes" | wc -w)" = 5 ] && [ "$files" = "$expected" ]
