#!/bin/sh
# Runs every command that is printed, as it is printed: printed_commands.sh PROGRAM PREFIX
#
# Those of the README in a fresh checkout: what the program brings, and out/bin/glasspipe. Those of the
# manual pages as after `make install PREFIX=...': in an empty folder. Those of --help must stand in the
# manual page too. A page's commands run in order in one folder, and other data is nowhere. A command
# passes that exits with 0; of `compare' 1 too, which says that the pictures differ.
#
# Charts and whole benchmarks take minutes, and --help says what the pages say: these are skipped, with
# a word, unless $GP_TEST_PRINTED asks for all.
program=$(realpath "$1")
prefix=$2
root=$(pwd)
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
unset GLASSPIPE_DATA
. tests/tools/tap.sh

# Puts the lines together that end with a backslash.
joined() {
    sed -e ':again' -e '/\\$/N' -e 's/\\\n */ /' -e 't again'
}

readme_commands() {
    sed -n '/^    /s/^    //p' "$1" | joined | grep -E '^(out/bin/)?glasspipe ' | sed 's/  *# .*//'
}

page_commands() {
    sed -n '/^\.SH EXAMPLES/,/^\.fi/p' "$1" | grep -v '^\.' | sed -e 's/\\e/\\/g' -e 's/\\-/-/g' | joined
}

help_commands() { # unwrapped
    ARGP_HELP_FMT=rmargin=200 ${EMULATOR:-} "$program" $1 --help | sed -n '/^Examples:/,/^$/s/^  //p' | joined
}

run_one() { # PAGE COMMAND, in the page's folder
    case "$2 " in
    *"glasspipe chart "* | *"glasspipe bench " | *"glasspipe bench --images "*)
        if [ -z "$GP_TEST_PRINTED" ]; then
            skip "$1: $2" "takes minutes; GP_TEST_PRINTED=1 runs it"
            return
        fi
        ;;
    esac
    sh -c "$2" >.out 2>.err </dev/null
    status=$?
    case "$status$2" in
    0* | 1*"glasspipe compare "*) result ok "$1: $2" ;;
    *)
        result "not ok" "$1: $2"
        echo "# exit status $status"
        sed 's/^/# /' .err
        ;;
    esac
}

# run_page PAGE, its commands from stdin; at least one
run_page() {
    cat >"$scratch/commands"
    [ -s "$scratch/commands" ] || result "not ok" "$1: no command is found"
    while IFS= read -r command; do
        run_one "$1" "$command"
    done <"$scratch/commands"
}

# wrapper FILE PROGRAM: a program that may be emulated
wrapper() {
    mkdir -p "$(dirname "$1")"
    printf '#!/bin/sh\nexec %s "%s" "$@"\n' "${EMULATOR:-}" "$2" >"$1"
    chmod +x "$1"
}

# A checkout, in which `make run' has drawn its picture.
mkdir "$scratch/checkout"
cp -r scenes "$scratch/checkout/"
wrapper "$scratch/checkout/out/bin/glasspipe" "$program"
cd "$scratch/checkout" || exit 1
out/bin/glasspipe render -q scenes/together.json -o out/together.png >/dev/null
readme_commands "$root/README.md" >"$scratch/list"
run_page README.md <"$scratch/list"

# Installed.
wrapper "$scratch/bin/glasspipe" "$prefix/bin/glasspipe"
PATH=$scratch/bin:$PATH
pages=0
for page in "$root"/apps/man/*.1; do
    name=$(basename "$page" .1)
    [ "$name" != glasspipe-mpi ] || continue # runs the others' commands: tests/tools/mpi.sh
    mkdir "$scratch/$name"
    cd "$scratch/$name" || exit 1
    case $name in # which is for a folder of one's own
    *-test) cp -r "$prefix/share/glasspipe/scenes" . ;;
    esac
    page_commands "$page" >"$scratch/list"
    run_page "$name(1)" <"$scratch/list"
    pages=$((pages + 1))
    command=${name#glasspipe}
    help_commands "$(echo "${command#-}" | tr - ' ')" >"$scratch/help" # some are of two words
    [ -s "$scratch/help" ] || result "not ok" "$name --help: no command is found"
    while IFS= read -r line; do
        grep -qxF -e "$line" "$scratch/list" || result "not ok" "$name --help: not in the page: $line"
    done <"$scratch/help"
    if [ -n "$GP_TEST_PRINTED" ]; then
        cd "$scratch/checkout" || exit 1
        PATH=$scratch/checkout/out/bin:$PATH run_page "$name --help" <"$scratch/help"
    else
        skip "$name --help" "its commands are the page's; GP_TEST_PRINTED=1 runs them in the checkout"
    fi
done
[ "$pages" -ge 9 ] || result "not ok" "only $pages manual pages"
echo "1..$count"
exit "$failed"
