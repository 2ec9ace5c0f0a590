#!/bin/sh
# The README's library sample, used as a stranger would from what is installed:
# check_library.sh PREFIX [short]
#
# Four projects, in C and in C++, by make and by CMake, are cut out of the README's own text and built
# in empty folders with nothing but PREFIX. Each draws at every lane width that the processor has: one
# hash, and the picture that the README shows. Says so as TAP. short: C by make alone.
set -u
prefix=$(cd "$1" && pwd)
short=${2:-}
root=$(pwd)
use=$(mktemp -d)
trap 'rm -rf "$use"' EXIT
readme=$root/README.md
export PKG_CONFIG_PATH="$prefix/lib/pkgconfig"
CC=${CC:-gcc} CXX=${CXX:-g++}
unset MAKEFLAGS MFLAGS MAKELEVEL GP_ISA
. tests/tools/tap.sh

# One block of the README, which names its file in the first line.
block() {
    awk -v first="$1" '/^```/ { inside = 0 } inside || $0 == first { inside = 1; print }' "$readme"
}

# Draws at each width that the processor has: one hash, the README's picture.
draws() {
    first=
    for isa in sse2 avx2 avx512 neon; do
        drawn=$(GP_ISA=$isa "$1" 2>&1) || case $drawn in
        *"this processor, or this build, does not have it"*) continue ;;
        *) echo "GP_ISA=$isa: $drawn" && return 1 ;;
        esac
        echo "$isa $drawn"
        [ "${first:=$drawn}" = "$drawn" ] || return 1
    done
    [ -n "$first" ] && "$prefix/bin/glasspipe" compare "$2/triangle.ppm" \
        "$root/scenes/pictures/triangle.png"
}

# project LANGUAGE: the files of a folder, cut out of the README
project() {
    mkdir -p "$use/$1" && cd "$use/$1" || return
    block '/* triangle.c */' >triangle.c
    block '# Makefile' >Makefile
    command -v pkg-config >/dev/null ||
        sed -i "s,\$(shell pkg-config.*),$prefix/share/glasspipe/shaders.mk," Makefile
    block '# CMakeLists.txt' >CMakeLists.txt
    if [ "$1" = C ]; then
        block '/* main.c */' >main.c
    else
        block '/* main.c */' >main.cpp
        sed -i 's/main\.c/main.cpp/' CMakeLists.txt
    fi
    [ -s triangle.c ] && [ -s Makefile ] && [ -s CMakeLists.txt ] && [ -s main.c* ]
}

by_make() {
    (project "$1" && make CC="$CC" CXX="$CXX" CFLAGS='-Wall -Wextra -Werror' \
        CXXFLAGS='-std=c++17 -Wall -Wextra -Werror' && draws ./draw .) >"$use/log" 2>&1
    tried $? "$1 by make: one hash at every width, and the README's picture" "$use/log"
}

by_cmake() {
    (project "$1" && cmake -S . -B build -DCMAKE_PREFIX_PATH="$prefix" -DCMAKE_C_COMPILER="$CC" \
        -DCMAKE_CXX_COMPILER="$CXX" -DCMAKE_CXX_STANDARD=17 \
        -DCMAKE_C_FLAGS='-Wall -Wextra -Werror' -DCMAKE_CXX_FLAGS='-Wall -Wextra -Werror' &&
        cmake --build build -j2 && cd build && draws ./draw .) >"$use/log" 2>&1
    tried $? "$1 by CMake: one hash at every width, and the README's picture" "$use/log"
}

# A main beside shaders that are compiled for several widths would stand there several times.
main_is_refused() {
    (project C && echo 'int main(void) { return 0; }' >>triangle.c &&
        ! make CC="$CC" CXX="$CXX" triangle.lanes8.o 2>message &&
        grep 'a shader file has no main' message) >"$use/log" 2>&1
    tried $? "a main in a shader file is refused with a sentence" "$use/log"
}

by_make C
main_is_refused
if [ -z "$short" ]; then
    by_make C++
    for language in C C++; do
        if command -v cmake >/dev/null; then
            by_cmake "$language"
        else
            skip "$language by CMake" "cmake is not installed"
        fi
    done
fi
echo "1..$count"
exit "$failed"
