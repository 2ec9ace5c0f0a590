#!/bin/sh
# Whether check_circles.awk finds what it should; run from the repository's root
#
# Small objects are compiled in places of the real tree: without a fault, calling each other, calling
# up, and in a folder that has no floor.
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT

# object NAME TEXT: compiles it as the source of that name
object() {
    mkdir -p "$scratch/$(dirname "$1")"
    echo "$2" | ${CC:-cc} -xc -c - -o "$scratch/$1.o"
}

# expect TEXT INCLUDE: what the check says of the objects and includes; TEXT "" where there is no fault
expect() {
    said=$({ find "$scratch" -name '*.o' -exec nm -A -P {} +; [ -z "$2" ] || printf '%s\n' "$2"; } |
        awk -v objects="$scratch/" -f tests/tools/floors.awk -f tests/tools/check_circles.awk)
    status=$?
    case $status-$said in
    0-*) [ -z "$1" ] && return ;;
    1-*"$1"*) [ -n "$1" ] && return ;;
    esac
    echo "expected '$1', not: $said"
    exit 1
}

object apps/base/one 'int two(void); int one(void) { return two(); }'
object apps/base/two 'int two(void) { return 0; }'
object apps/frame/up 'int one(void); int up(void) { return one(); }'
expect ""

object apps/base/two.lanes8 'int one(void); int three(void) { return one(); }'
expect "circle of 2 files by call: apps/base/"
rm "$scratch/apps/base/two.lanes8.o"

object apps/base/two 'int up(void); int two(void) { return up(); }'
expect "apps/base/two needs apps/frame/up of a floor above: up"
expect "circle of 2 folders: apps/"

object apps/base/two 'int nowhere(void); int two(void) { return nowhere(); }'
object apps/heap/nowhere 'int nowhere(void) { return 0; }'
expect "apps/heap/nowhere stands on no floor"
rm -r "$scratch/apps/heap"

object apps/base/two 'int up(void) __attribute__((weak)); int two(void) { return up ? up() : 0; }'
expect ""
expect "circle of 2 files by include" \
    "apps/base/one.h:#include \"apps/base/two.h\"
apps/base/two.h:#include \"apps/base/one.h\""
