# Results as TAP, for scripts that read this by `.`: tests/tools/tap.sh
#
# count and failed are theirs to print and to exit with.
# shellcheck shell=sh disable=SC2034
count=0 failed=0

# result STATUS NAME LOG: ok where the status is 0; where it is not, the log stands behind
result() {
    count=$((count + 1))
    if [ "$1" = 0 ]; then
        echo "ok $count - $2"
    else
        echo "not ok $count - $2"
        sed 's/^/# /' "$3"
        failed=1
    fi
}

# skip NAME REASON
skip() {
    count=$((count + 1))
    echo "ok $count - $1 # SKIP $2"
}
