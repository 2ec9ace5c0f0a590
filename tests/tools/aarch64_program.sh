#!/bin/sh
# The whole program for ARM, in OUT/aarch64-program: aarch64_program.sh OUT GOAL...
#
# Without OpenImageIO, which brings too much with it, and OpenMesh. Goals that run it use qemu-aarch64.
out=$1
shift
libraries=$(mkdir -p "$out" && cd "$out" && pwd)/arm64
sh tests/tools/arm64_libraries.sh "$libraries" || exit 1
mkdir -p "$libraries/include" && ln -sf /usr/include/xxhash.h "$libraries/include/" || exit 1
shared=$libraries/usr/lib/aarch64-linux-gnu
exec make BUILD="$out/aarch64-program" WERROR="${WERROR:-}" CC=aarch64-linux-gnu-gcc CXX=aarch64-linux-gnu-g++ ARCH=aarch64 \
    WITH_OIIO= WITH_OPENMESH= CPPFLAGS="-isystem $libraries/include -idirafter $libraries/usr/include" \
    LDFLAGS="-L$shared -Wl,-rpath,$shared -Wl,-rpath-link,$shared" \
    EMULATOR="qemu-aarch64 -L /usr/aarch64-linux-gnu" "$@"
