#!/bin/sh
# Prints a C file that holds the files named, as page_files.h has them: page_files.sh FILE...
cat <<EOF
#include "apps/inspect/page_files.h"

#define HOLD(name, path)                                                                           \\
    extern const char name[], name##_end[];                                                        \\
    __asm__(".section .rodata\n" #name ": .incbin \"" path "\"\n" #name "_end: .byte 0\n.text\n");

EOF
number=0
for file; do
    echo "HOLD(page_file_$number, \"$file\")"
    number=$((number + 1))
done
echo
echo 'const PageFile page_files[] = {'
number=0
for file; do
    echo "    { \"$file\", page_file_$number, page_file_${number}_end },"
    number=$((number + 1))
done
echo '    { NULL, NULL, NULL },'
echo '};'
