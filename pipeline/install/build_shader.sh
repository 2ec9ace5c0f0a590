#!/bin/sh
# Builds a shader file for `glasspipe shader`, by the compiler that is there:
# build_shader.sh PREFIX FILE "LANES..."
#
# Prints the path of a shared library with the file's programs, compiled for these lane widths and for
# counting. It is kept in $XDG_CACHE_HOME/glasspipe under a hash of all that it is made of, so that the
# same file is compiled once. Messages, the compiler's included, go to stderr.
# Exit status 3: no compiler, or one that refuses the file; 4: nowhere to put the library.
set -u
prefix=$1 file=$2 widths=$3
rules=$prefix/share/glasspipe/shaders.mk

fail() {
    echo "$2" >&2
    exit "$1"
}

# first COMMAND...: the first that is there
first() {
    for command; do
        # shellcheck disable=SC2086 # a command with its options
        if [ -n "$command" ] && command -v ${command%% *} >/dev/null; then
            echo "$command"
            return
        fi
    done
    return 1
}

# The value of a variable of shaders.mk.
rule() {
    sed -n "s/^$1 := //p" "$rules"
}

cc=$(if [ -n "${CC:-}" ]; then first "$CC"; else first cc gcc clang; fi) ||
    fail 3 "no C compiler: ${CC:-cc, gcc and clang} not found (on Debian: apt-get install gcc g++)"
cxx=$(if [ -n "${CXX:-}" ]; then first "$CXX"; else first c++ g++ clang++; fi) || cxx=

flags="-O2 -fPIC -Wall -Wextra $(rule GP_MODEL) -I$prefix/include"
# Messages are about the user's lines, not about the inside of the vocabulary's macros.
if $cc --version | grep -qi clang; then
    flags="$flags -fmacro-backtrace-limit=1"
else
    flags="$flags $(rule GP_GCC_OPT) -ftrack-macro-expansion=0"
fi
flags="$flags -x c"
isas=$(rule "GP_ISAS_$(uname -m)")
isas=${isas:-$(rule GP_ISAS_generic)}

cache=${XDG_CACHE_HOME:-${HOME:-/tmp}/.cache}/glasspipe
mkdir -p "$cache" && work=$(mktemp -d "$cache/build.XXXXXX") ||
    fail 4 "$cache: a built shader has no place there; \$XDG_CACHE_HOME chooses another"
trap 'rm -rf "$work"' EXIT

# The preprocessor's output has the headers in it. It is the first to find what is wrong.
# shellcheck disable=SC2086 # flags are several words
$cc $flags -E "$file" >"$work/text.i" || exit 3
# It has not what counting includes, by which the library and the program know each other.
hash=$({ echo "$cc $cxx $flags $isas $widths" && $cc --version && cat "$work/text.i" &&
    cat "$prefix"/include/glasspipe/shader/*; } | sha256sum)
library=$cache/${hash%% *}.so
if [ -e "$library" ]; then
    echo "$library"
    exit
fi

# compile LANES: one variant
compile() {
    for isa in $isas; do
        [ "${isa%%:*}" = "$1" ] || continue
        name=${isa#*:}
        # shellcheck disable=SC2046,SC2086
        $cc $flags -DGP_LANES="$1" "-DGP_ISA_NAME=\"${name%%:*}\"" \
            $(echo "${name#*:}" | tr , ' ') -c "$file" -o "$work/lanes$1.o"
        return
    done
}

compile 4 || exit 3 # says what is wrong once
for lanes in $widths; do
    [ "$lanes" = 4 ] || compile "$lanes" 2>"$work/log$lanes" &
done
# shellcheck disable=SC2086
[ -z "$cxx" ] || $cxx -O1 -fPIC -std=gnu++20 -fno-exceptions -w -I"$prefix/include" -x c++ -c "$file" \
    -o "$work/count.o" || fail 3 "$file: this is what it needs to be counted, as C++"
wait
for lanes in $widths; do
    [ -e "$work/lanes$lanes.o" ] || { cat "$work/log$lanes" >&2 && exit 3; }
done
$cc -shared "$work"/*.o -o "$work/library.so" || exit 3
mv "$work/library.so" "$library" || exit 4
echo "$library"
