#!/bin/sh
# Which Debian packages are missing, and how to get them.
#
#   packages.sh missing GROUP...    prints the missing packages, one a line
#   packages.sh report GROUP...     says so in words, with the command; exit status 1 if any is
#   packages.sh install GROUP...    installs what is missing (root, or by sudo)
#
# Groups: build lessons test lint check mpi. What is tested is what the build needs, a command or a header, not
# the package database: a compiler or library from elsewhere is as good. Nothing here needs a
# compiler to be present.
set -eu

CC=${CC:-gcc}
CXX=${CXX:-g++}

# group, package, then a command or a header that it provides
table() {
    cat <<EOF
build $(compiler_package "$CC" gcc) command $CC
build $(compiler_package "$CXX" g++) command $CXX
build libc6-dev header stdio.h
build libjansson-dev header jansson.h
build libxxhash-dev header xxhash.h
build libpng-dev header png.h
build zlib1g-dev header zlib.h
build libopenimageio-dev header OpenImageIO/imageio.h
build libopenmesh-dev header OpenMesh/Core/Mesh/Traits.hh
test libcmocka-dev header cmocka.h
test qemu-user command qemu-x86_64
test patch command patch
lessons patch command patch
lint clang-format command clang-format
check clang command clang++
check valgrind command valgrind
check llvm command llvm-cov
check chromium command chromium
check python3 command python3
check gcc-aarch64-linux-gnu command aarch64-linux-gnu-gcc
check g++-aarch64-linux-gnu command aarch64-linux-gnu-g++
check libc6-dev-arm64-cross file /usr/aarch64-linux-gnu/include/stdio.h
check qemu-user command qemu-aarch64
check pkg-config command pkg-config
check cmake command cmake
check doxygen command doxygen
check openimageio-tools command idiff
check libopenmpi-dev command mpicc
check openmpi-bin command mpirun
mpi libopenmpi-dev command mpicc
mpi openmpi-bin command mpirun
EOF
}

compiler_package() {
    case $1 in
    *clang*) echo clang ;;
    *) echo "$2" ;;
    esac
}

# Reads "package header" lines; prints the packages whose header the preprocessor does not find: in
# its output only their lines are left. Without a compiler, all of them.
packages_without_header() {
    while read -r package header; do
        printf '#if !__has_include(<%s>)\n%s\n#endif\n' "$header" "$package"
    done >"$scratch"
    if command -v "$CC" >/dev/null; then
        # shellcheck disable=SC2086 # CPPFLAGS holds several words
        "$CC" -xc -E -P ${CPPFLAGS:-} "$scratch"
    else
        grep -v '^#' "$scratch" || true
    fi
}

missing() {
    scratch=$(mktemp)
    trap 'rm -f "$scratch"' EXIT
    table | while read -r group package kind probe; do
        case " $* " in *" $group "*) ;; *) continue ;; esac
        case $kind in
        command) command -v "$probe" >/dev/null || echo "$package" ;;
        file) [ -e "$probe" ] || echo "$package" ;;
        esac
    done
    table | while read -r group package kind probe; do
        case " $* " in *" $group "*) ;; *) continue ;; esac
        [ "$kind" != header ] || echo "$package $probe"
    done | packages_without_header
}

as_root() {
    if [ "$(id -u)" = 0 ]; then
        echo env
    else
        echo "sudo env"
    fi
}

install_packages() {
    if ! command -v apt-get >/dev/null; then
        echo "missing: $*; these are Debian's names, and there is no apt-get here" >&2
        return 1
    fi
    echo "installing: $*"
    apt="$(as_root) DEBIAN_FRONTEND=noninteractive apt-get -q"
    # shellcheck disable=SC2086 # several words
    $apt install -y --no-install-recommends "$@" ||
        { $apt update && $apt install -y --no-install-recommends "$@"; }
}

action=$1
shift
packages=$(missing "$@" | sort -u | xargs)
case $action in
missing)
    for package in $packages; do
        echo "$package"
    done
    ;;
report)
    [ -n "$packages" ] || exit 0
    sudo=
    [ "$(id -u)" = 0 ] || sudo="sudo "
    {
        echo "missing packages: $packages"
        echo "install them with: make deps"
        echo "or: ${sudo}apt-get install -y --no-install-recommends $packages"
    } >&2
    exit 1
    ;;
install)
    [ -n "$packages" ] || exit 0
    # shellcheck disable=SC2086 # one word a package
    install_packages $packages
    left=$(missing "$@" | sort -u | xargs)
    [ -z "$left" ] || { echo "still missing after the installation: $left" >&2; exit 1; }
    ;;
*)
    echo "usage: packages.sh missing|report|install GROUP..." >&2
    exit 2
    ;;
esac
