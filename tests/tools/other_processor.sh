#!/bin/sh
# A short form of the tests as if this were another x86 processor: other_processor.sh CPU BUILD WIDTH...
#
# CPU is a model that qemu-x86_64 knows; WIDTHs, of 4, 8 and 16, are the lanes that it has. Speaks TAP.
# Skipped where there is no such emulator.
cpu=$1 build=$2
shift 2
number=0 failed=0
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT

command -v qemu-x86_64 >/dev/null || {
    echo "1..0 # SKIP qemu-x86_64 is not installed (make deps)"
    exit
}

# attempt NAME STATUS COMMAND...: ok if the command, emulated, ends with this status
attempt() {
    name=$1 wanted=$2
    shift 2
    number=$((number + 1))
    qemu-x86_64 -cpu "$cpu" "$@" >"$scratch/said" 2>&1
    status=$?
    if [ "$status" = "$wanted" ]; then
        echo "ok $number - $name"
    else
        failed=1
        echo "not ok $number - $name: status $status instead of $wanted"
        grep -v -e '^ok' -e "TCG doesn't support" "$scratch/said" | tail -n 12 | sed 's/^/# /'
    fi
}

echo '{ "size": [64, 64], "background": [0, 0.5, 1, 1], "objects": [] }' >"$scratch/empty.json"
render() {
    attempt "$1" "$2" "$build/bin/glasspipe" render -o "$scratch/empty.ppm" "$scratch/empty.json"
}

export CMOCKA_MESSAGE_OUTPUT=TAP
unset GP_ISA

echo "1..6"
render "a scene without objects" 0
for width in 4 8 16; do
    export GP_ISA=lanes$width
    case " $* " in
    *" $width "*) attempt "golden frames at $GP_ISA" 0 "$build/test/golden" --first 8 ;;
    *) render "$GP_ISA is refused" 2 ;;
    esac
    unset GP_ISA
done
attempt "lane widths" 0 "$build/test/test_widths"
attempt "differential" 0 "$build/test/differential" 0..19
exit "$failed"
