# Results as TAP, for scripts that read this by `.`: tests/tools/tap.sh
#
# count and failed are theirs to print and to exit with.
# shellcheck shell=sh disable=SC2034
count=0 failed=0

# result WORD NAME: the word is "ok" or "not ok"
result() {
    count=$((count + 1))
    echo "$1 $count - $2"
    [ "$1" = ok ] || failed=1
}

# tried STATUS NAME LOG: ok where the status is 0; where it is not, the log stands behind
tried() {
    if [ "$1" = 0 ]; then
        result ok "$2"
    else
        result "not ok" "$2"
        sed 's/^/# /' "$3"
    fi
}

# skip NAME REASON
skip() {
    result ok "$1 # SKIP $2"
}
