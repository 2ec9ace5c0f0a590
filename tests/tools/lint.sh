#!/bin/sh
# What the sources and their objects tell: floors, circles, sizes, format, words. Run from the
# repository's root, by `make lint`: lint.sh BUILD OBJECT...
# Says every fault with its file and line; exit status 1 if there is any.
build=$1
shift
failed=0

fault() {
    echo "$1" >&2
    failed=1
}

# Prints "file:line: text" for each match of an extended expression in the given files; a fault.
forbid() {
    reason=$1 expression=$2
    shift 2
    if found=$(grep -nE "$expression" "$@" /dev/null); then
        echo "$found"
        fault "$reason"
    fi
}

sources=$(find pipeline shaders_c apps tests -name '*.[ch]' -o -name '*.cpp' -o -name '*.hpp' | sort)
shaders=$(find shaders_c -name '*.c' | sort)
texts=$(find Makefile README.md CONTRIBUTING.md GOLDEN_PICTURES.md CLUSTER.md .ci pipeline shaders_c apps tests scenes -type f \
    ! -name '*.png' ! -name lint.sh | sort)

# Longer than 500 lines, with the reason.
long_files='
tests/                           the facts of one unit stay together
'

# shellcheck disable=SC2086 # lists of files without spaces
{
    awk -f tests/tools/floors.awk -f tests/tools/check_includes.awk $sources ||
        fault "lint: includes that point up"
    { nm -A -P "$@"; echo "$sources" | grep -v '^tests/' | xargs grep -E '^#include ("|<glasspipe/)'; } |
        awk -v objects="$build/obj/" -f tests/tools/floors.awk -f tests/tools/check_circles.awk ||
        fault "lint: calls that point up, or in a circle"
    sh tests/tools/check_circles_self.sh || fault "lint: circles are not found"
    awk -v reasons="$long_files" -f tests/tools/check_sizes.awk $sources ||
        fault "lint: sizes and sections"

    forbid "lint: reciprocal estimates differ between processors (R29)" \
        '(_mm[0-9]*_|GP_NATIVE\()(rcp|rsqrt)|vrecpe|vrsqrte' $sources
    forbid "lint: fast-math and contraction change bits" \
        '^[^#]*(fast-math|Ofast)|STDC FP_CONTRACT ON' $sources
    forbid "lint: a shader is pure and has no library" \
        '^ +static |^static [^(]*[=;]|malloc|[a-z]f\(' $shaders
    # shellcheck disable=SC2013 # words, not lines
    for rule in $(grep -ohE '\bR[0-9]{1,2}\b' $sources | sort -u); do
        grep -qw "$rule" pipeline/CONVENTIONS.md ||
            fault "$(grep -lw "$rule" $sources | head -1): $rule is not in pipeline/CONVENTIONS.md"
    done
    forbid "lint: a path of one machine" '(^|[^[:alnum:].$])/(work|home|root|Users|mnt)/' $texts
    forbid "lint: unfinished" '(^|[^[:alnum:]])(TODO|FIXME|XXX)([^[:alnum:]]|$)' $texts

    if command -v clang-format >/dev/null; then
        clang-format --dry-run -Werror --ferror-limit=1 $sources ||
            fault "lint: run clang-format -i on these files"
    else
        echo "clang-format: skipped, not installed (make deps)"
    fi
}

[ "$failed" = 0 ] && echo "lint: $(echo "$sources" | wc -l) files, no fault"
exit "$failed"
