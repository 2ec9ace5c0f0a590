#!/bin/sh
# Runs one test program and keeps what it says: run_test.sh RESULT PROGRAM [ARGUMENT...]
#
# The program speaks TAP (cmocka's do when asked): a plan "1..N", then "ok" or "not ok" lines.
# RESULT, whose folder is made, receives that and a last line with the exit status. Always succeeds:
# summary.awk is the judge.
# TEST_SECONDS limits each program (default 600); EMULATOR runs it (for another processor).
result=$1
shift
export CMOCKA_MESSAGE_OUTPUT=TAP
case $1 in
sh) emulator= ;; # which emulates what it runs itself
*) emulator=${EMULATOR:-} ;;
esac
# Each test's own counts (make coverage): programs that differ cannot add to one file.
[ -z "${PROFILES:-}" ] ||
    export LLVM_PROFILE_FILE="$PROFILES/$(basename "$result" .tap).%m.profraw"
mkdir -p "$(dirname "$result")"
# shellcheck disable=SC2086 # EMULATOR may hold arguments
timeout "${TEST_SECONDS:-600}" $emulator "$@" >"$result.part" 2>&1
echo "# exit status $?" >>"$result.part"
mv "$result.part" "$result"
