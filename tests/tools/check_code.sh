#!/bin/sh
# Looks for machine code that would change bits: check_code.sh BUILD
#
# In the objects of the pipeline and the shaders: reciprocal estimates (their results differ between
# makers), fused multiply-adds (one rounding instead of two), x87 arithmetic (80 bits), and calls to
# functions of the C library whose results differ between processors and versions. Files that convert
# channels name fused ones where their one rounding is the right one (flt_fused, x86 only).
set -eu
objects=$(find "$1"/obj/pipeline "$1"/obj/shaders_c -name '*.o' ! -path '*/pipeline/io/*')
[ -n "$objects" ] || { echo "no objects in $1" && exit 1; }

# A cross build is read by its own tools.
prefix=
[ "$(basename "$1")" != aarch64 ] || prefix=aarch64-linux-gnu-

# shellcheck disable=SC2086 # one word an object
${prefix}objdump -d --no-show-raw-insn $objects | awk '
    BEGIN {
        estimate = "^v?(rcp|rsqrt)(14|28)?[ps][sd]$|^f?(recp[es]|rsqrt[es])$|^ur(ecpe|sqrte)$"
        fused = "^vfn?m(add|sub|addsub|subadd)[0-9]*[ps][sdh]$|^fn?m(add|sub|la|ls)$|^fml[as]l2?$"
        named = "^vfmadd[0-9]*ps$"
        converts = "/pipeline/fast/lanes/(memory/transfer|output/blend(_bits)?|shade/(blend_sorted" \
                   "|framebuffer_fetch|gathered)|texture/sample)\\.lanes(8|16)\\.o:$"
        x87 = "^f(i?(ld|st|add|sub|mul|div)r?[pslt]*|sqrt|sin|cos|sincos|ptan|patan|yl2x|scale)$"
        failed = 0
    }
    /file format/ { file = $1; arm = /aarch64/; may_name = file ~ converts }
    /^[0-9a-f]+ </ { where = $2 }
    /^ *[0-9a-f]+:\t/ {
        instructions++
        if (may_name && $2 ~ named)
            by_name++
        else if ($2 ~ estimate || $2 ~ fused || (!arm && $2 ~ x87)) {
            print file " " where " " $2
            failed = 1
        }
    }
    END {
        print instructions + 0 " instructions: " (failed ? "some" : "none") \
              " estimated, fused or x87; " by_name + 0 " fused by name"
        exit failed || instructions == 0
    }'

library='(a?(sin|cos|tan)h?|atan2|sincos|exp(2|10|m1)?|log(2|10|1p)?|pow|cbrt|hypot|fma)f?'
# shellcheck disable=SC2086
if ${prefix}nm -u -A $objects | grep -E " U $library\$"; then
    echo "calls to the C library's mathematics, whose bits differ between processors"
    exit 1
fi
echo "no estimate, no fused multiply-add but those by name, no x87, no library mathematics"
