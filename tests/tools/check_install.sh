#!/bin/sh
# Installs a build somewhere and uses it as a stranger would: check_install.sh BUILD
#
# The program says its version; the README's library sample becomes a program in C and C++, by make and
# by CMake (check_library.sh), and by pkg-config alone; the page on golden pictures works; after
# `make uninstall` no file is left.
set -eu
build=$1
prefix=$(cd "$build" && pwd)/installed
use=$build/use
rm -rf "$prefix" "$use"
mkdir -p "$use"
install="make BUILD=$build CC=gcc CXX=g++ OPT=-O2 WERROR=1 PREFIX=$prefix"

$install install
"$prefix/bin/glasspipe" --version
readelf -SW "$prefix/bin/glasspipe" >"$use/sections"
! grep ' \.debug' "$use/sections" || { echo "the program has debug information" && exit 1; }
for page in "$prefix"/share/man/man[15]/*; do
    echo "manual: $(basename "$page")"
done
bash -n "$prefix/share/bash-completion/completions/glasspipe"

sh tests/tools/check_headers.sh "$prefix/include" gcc g++ clang clang++
sh tests/tools/check_library.sh "$prefix"
# Without shaders.mk: at four lanes, from the static library.
readme() {
    awk -v first="$1" '/^```/ { inside = 0 } inside || $0 == first { inside = 1; print }' README.md
}
readme '/* triangle.c */' >"$use/triangle.c"
readme '/* main.c */' >"$use/main.c"
export PKG_CONFIG_PATH="$prefix/lib/pkgconfig"
# shellcheck disable=SC2046 # flags are several words
gcc -O2 $(pkg-config --cflags glasspipe) "$use/triangle.c" "$use/main.c" \
    "$prefix/lib/libglasspipe.a" -lm -o "$use/static"
(cd "$use" && ./static)

# The page on golden pictures as it is printed, its build server's part included, but for the place of
# the installation and what is installed here already. A link stands for the checkout.
blocks() {
    awk '/^```sh/ { inside = 1; next } /^```/ { inside = 0 } inside' GOLDEN_PICTURES.md |
        sed -e '/^apt-get/d' -e "s,/opt/glasspipe,$prefix,"
}
ln -sfn "$(pwd)" "$use/glasspipe"
blocks >"$use/page.sh"
grep -q '^make -C glasspipe install' "$use/page.sh"
build=$(cd "$build" && pwd)
(cd "$use" && BUILD=$build CC=gcc CXX=g++ OPT=-O2 WERROR=1 PATH="$prefix/bin:$PATH" sh -e page.sh) |
    grep -c '1 of 1 scenes as stored' | grep -qx 5

$install uninstall
left=$(find "$prefix" -type f -o -type l)
[ -z "$left" ] || { echo "left behind: $left" && exit 1; }
echo "installed, used through pkg-config, uninstalled"
