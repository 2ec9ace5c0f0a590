#!/bin/sh
# What users include, as it is installed: check_headers.sh INCLUDE COMPILER...
#
# Each header compiles alone with every compiler, as C11 and as C++17, without a warning; those of the
# shader language in the one language that they are for. glasspipe.h leaks no name but gp_, Gp and GP_.
# Says so as TAP.
set -u
include=$1
shift
. tests/tools/tap.sh
log=$(mktemp)
trap 'rm -f "$log"' EXIT

# The standards of one header: the vocabulary is C in lanes, and C++20 in counting.
standards() {
    case $1 in
    *.hpp) echo c++20 ;;
    glasspipe/shader/types.h | glasspipe/shader/entry_points.h | glasspipe/shader/instructions.h | \
        glasspipe/shader/pixels.h | glasspipe/shader/textures.h) echo c11 ;;
    glasspipe/shader.h) echo c11 c++17 c++20 ;;
    *) echo c11 c++17 ;;
    esac
}

# alone COMPILER STANDARD HEADER
alone() {
    case $2 in
    c++*) language=c++ ;;
    *) language=c ;;
    esac
    printf '#include <%s>\nextern int unused;\n' "$3" |
        "$1" -std="$2" -pedantic -Wall -Wextra -Werror -fsyntax-only -I"$include" -x $language -
}

headers=$(cd "$include" && find glasspipe -name '*.h*' | sort)
for compiler; do
    case $compiler in
    *++*) kind='c++*' ;;
    *) kind='c1*' ;;
    esac
    good=0
    : >"$log"
    for header in $headers; do
        for standard in $(standards "$header"); do
            # shellcheck disable=SC2254 # a pattern
            case $standard in
            $kind) alone "$compiler" "$standard" "$header" >>"$log" 2>&1 || good=1 ;;
            esac
        done
    done
    tried "$good" "every header compiles alone: $compiler" "$log"
done

# Names at file scope, of what the preprocessor left of our own files, and our macros.
names() {
    printf '#include <glasspipe/glasspipe.h>\n' | "$1" -std=c11 -E -dD -I"$include" -x c - | awk '
        /^# [0-9]+ / { ours = $3 ~ /glasspipe\// }
        !ours { next }
        /^#define/ { sub(/\(.*/, "", $2); print $2 }
        /^#/ { next }
        { gsub(/"[^"]*"/, ""); text = text " " $0 }
        END {
            gsub(/__attribute__ *\(\(([^()]|\([^()]*\))*\)\)/, "", text)
            gsub(/[^A-Za-z0-9_]/, " & ", text)
            n = split(text, token, " ")
            for (i = 1; i <= n; i++) {
                t = token[i]
                if (t == "{") { in_enum[++depth] = kind == "enum"; fresh = in_enum[depth] }
                else if (t == "}") depth--
                else if (t == "(") { if (!depth && !nested && word !~ /^(void|_Bool)$/ && word) print word; nested++ }
                else if (t == ")") nested--
                else if (t == ";" || t == "[" || t == "=") { if (!depth && !nested && word) print word }
                if (depth && in_enum[depth] && fresh && t ~ /^[A-Za-z_]/) { print t; fresh = 0 }
                if (depth && in_enum[depth] && t == ",") fresh = 1
                if (t ~ /^(struct|union|enum)$/) kind = t
                else if (t == ";" || t == "}") kind = ""
                if (!depth && token[i - 1] == "*" && token[i - 2] == "(") print t
                word = t ~ /^[A-Za-z_][A-Za-z0-9_]*$/ ? t : ""
            }
        }' | sort -u
}
for compiler; do
    case $compiler in
    *++*) continue ;;
    esac
    names "$compiler" >"$log"
    # Some must be there, or the names were not found at all.
    for name in gp_device_create GpDevice GpShaderFn GP_EXECUTOR_FAST GP_VERSION gp_program_targets; do
        grep -qx "$name" "$log" || echo "not found: $name" >>"$log"
    done
    found=$(grep -vE '^(gp_|Gp|GP_|GLASSPIPE_H$)' "$log")
    echo "$found" >"$log"
    [ -z "$found" ]
    tried $? "glasspipe.h has no name without gp_, Gp or GP_" "$log"
    break
done
echo "1..$count"
exit "$failed"
