#!/bin/sh
# Fetches the arm64 libraries that the program needs, beside the system: arm64_libraries.sh FOLDER
#
# jansson, libpng and zlib, unpacked below FOLDER; nothing is installed, and apt's own lists stay as
# they are. Does nothing where they are there already.
folder=$(mkdir -p "$1" && cd "$1" && pwd) || exit 1
[ -e "$folder/usr/lib/aarch64-linux-gnu/libz.so" ] && exit 0 # made last, and to nowhere before that
mkdir -p "$folder/apt/lists/partial" "$folder/apt/cache/archives/partial" || exit 1
with_arm64() {
    apt-get -q -o APT::Architecture="$(dpkg --print-architecture)" \
        -o APT::Architectures::="$(dpkg --print-architecture)" -o APT::Architectures::=arm64 \
        -o Dir::State::lists="$folder/apt/lists" -o Dir::Cache="$folder/apt/cache" "$@"
}
with_arm64 update || exit 1
(cd "$folder/apt" && with_arm64 download libjansson-dev:arm64 libpng-dev:arm64 libpng16-16:arm64 zlib1g-dev:arm64 zlib1g:arm64) || exit 1
for package in "$folder"/apt/*.deb; do
    dpkg-deb -x "$package" "$folder" || exit 1
done
# zlib's link for compilers names its place on a whole system; beside the others it is found here.
shared=$folder/usr/lib/aarch64-linux-gnu
cp -P "$folder"/lib/aarch64-linux-gnu/libz.so.* "$shared/" && ln -sf libz.so.1 "$shared/libz.so" || exit 1
rm -rf "$folder/apt"
