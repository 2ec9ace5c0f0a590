#!/bin/sh
# Stored hashes of what the program draws, case by case:
#
#   golden_pictures.sh PROGRAM            compares every case of tests/golden/pictures.txt, as TAP
#   golden_pictures.sh PROGRAM CASE       writes that case's line anew, or adds it
#
# A line is "ARGUMENTS = WHAT IS PRINTED". Every scene is there, every case of `bench', and every name
# that an option of a technique (a command with --error) takes, by the program's own words: one that is
# missing is a failure. A case whose data is not here ($GLASSPIPE_DATA) is skipped, and so are those of
# millions of points, which take half a minute to open, and of millions of draws, which take gigabytes,
# unless $GP_TEST_LARGE asks for them.
program=$1
cases=tests/golden/pictures.txt
data=${GLASSPIPE_DATA:-../shared/data}
. tests/tools/tap.sh
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT

# What a case prints, in one line; pictures where it says so, or where they are all there is.
draw() {
    case $1 in
    bench*)
        # shellcheck disable=SC2086
        ${EMULATOR:-} "$program" $1 -q -t 0 2>/dev/null |
            sed 's/.*"width":\([0-9]*\),"height":\([0-9]*\).*"hash":"\([0-9a-f]*\)".*/hash \1x\2 \3/'
        return
        ;;
    *--picture* | render* | shadow* | points* | volume* | warp* | fragments*) output=$scratch/picture.ppm ;;
    *) output=$scratch/volume.nrrd ;;
    esac
    # shellcheck disable=SC2086 # arguments of several words, none with blanks
    ${EMULATOR:-} "$program" $1 -q -o "$output" 2>&1 | tr '\n' ' ' | sed 's/ $//'
}

# lacks_data FILE DRAWN: a scene that names data; a case of bench that draws nothing
lacks_data() {
    [ ! -d "$data" ] && { [ -z "$2" ] || { [ -f "$1" ] && grep -qE "$names_data" "$1"; }; }
}
names_data='"(meshes|images|points|volumes)/'

# The names that an option takes, from the refusal of another; none for numbers.
names_of() {
    "$program" "$1" none.json "--$2" '?' 2>&1 |
        sed -n "s/.*: expected \\(.*\\), not '?'\$/\\1/p" | grep -vE 'number|such as' | sed 's/,//g; s/ or / /'
}

check_scenes() {
    for scene in scenes/*.json scenes/lessons/[0-9]*.json; do
        case $scene in *.lesson.json) continue ;; esac
        grep -q "^render $scene " "$cases" || result "not ok" "no case draws $scene"
    done
}

check_bench() {
    for name in $("$program" bench --list); do
        grep -q "^bench $name = " "$cases" || result "not ok" "no case draws bench $name"
    done
}

# Executor and instruction set change no bit.
check_names() {
    for option in $("$program" "$1" --help | sed -n 's/^ *\(-., \)\?--\([a-z-]*\)=.*/\2/p' |
        grep -vxE 'executor|isa'); do
        for name in $(names_of "$1" "$option"); do
            grep -qE "^$1 .*--$option $name( |\$)" "$cases" ||
                result "not ok" "no case of $1 has --$option $name"
        done
    done
}

if [ -n "$2" ]; then
    line="$2 = $(draw "$2")"
    awk -v wanted="$2" -v line="$line" -F ' = ' '$1 == wanted { print line; found = 1; next }
        { print } END { if (!found) print line }' "$cases" >"$scratch/cases" &&
        cp "$scratch/cases" "$cases" && echo "$line"
    exit
fi

while IFS= read -r line; do
    arguments=${line%% = *}
    # shellcheck disable=SC2086 # its first two words
    set -- $arguments
    case "$arguments$GP_TEST_LARGE" in
    bench*_8m | bench*_im | bench*_96)
        skip "$arguments" "takes long, and much memory; GP_TEST_LARGE=1 draws it"
        continue
        ;;
    esac
    drawn=$(draw "$arguments")
    if lacks_data "$2" "$drawn"; then
        result ok "$arguments # SKIP no data"
    elif [ "$line" = "$arguments = $drawn" ]; then
        result ok "$arguments"
    else
        result "not ok" "$arguments"
        printf '#   drawn  %s\n#   stored %s\n' "$drawn" "${line#* = }"
    fi
done <"$cases"
check_scenes
check_bench
techniques=0
for command in $("$program" --help | sed -n '/^Commands:/,/^$/s/^  \([a-z]*\) .*/\1/p'); do
    if "$program" "$command" --help 2>/dev/null | grep -q -- '--error='; then
        check_names "$command"
        techniques=$((techniques + 1))
    fi
done
[ "$techniques" -ge 2 ] || result "not ok" "only $techniques techniques are found in the help"
echo "1..$count"
exit "$failed"
