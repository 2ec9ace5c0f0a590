#!/bin/sh
# What can be checked without compiling: layers, format, words. Run from the repository's root.
# Says every fault with its file and line; exit status 1 if there is any.
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
texts=$(find Makefile README.md CONTRIBUTING.md .ci pipeline shaders_c apps tests scenes -type f \
    ! -name '*.png' ! -name lint.sh | sort)

# shellcheck disable=SC2086 # lists of files without spaces
{
    awk -f tests/tools/check_includes.awk $sources || fault "lint: includes that point up"

    forbid "lint: reciprocal estimates differ between processors (R29)" \
        '_mm[0-9]*_(rcp|rsqrt)|vrecpe|vrsqrte' $sources
    forbid "lint: fast-math and contraction change bits" \
        'fast-math|Ofast|STDC FP_CONTRACT ON' $sources
    forbid "lint: a shader is pure and has no library" \
        '^ +static |^static [^(]*[=;]|malloc|[a-z]f\(' $shaders
    forbid "lint: a path of one machine" '(^|[^[:alnum:].$])/(work|home|root|Users|mnt)/' $texts
    forbid "lint: unfinished" '(^|[^[:alnum:]])(TODO|FIXME|XXX)([^[:alnum:]]|$)' $texts

    for file in $sources; do
        lines=$(wc -l <"$file")
        [ "$lines" -le 800 ] || fault "$file: $lines lines, at most 800"
    done

    if command -v clang-format >/dev/null; then
        clang-format --dry-run -Werror --ferror-limit=1 $sources ||
            fault "lint: run clang-format -i on these files"
    else
        echo "clang-format: skipped, not installed (make deps)"
    fi
}

[ "$failed" = 0 ] && echo "lint: $(echo "$sources" | wc -l) files, no fault"
exit "$failed"
