#!/bin/sh
# The public headers as HTML: docs.sh INCLUDE FILTER OUT
#
# INCLUDE holds the headers as they are installed. A function, struct, enumeration or macro without a
# comment is an error, and so is all else that doxygen warns of. What shaders are compiled into (lanes,
# their mathematics, counting) is not for callers and left out.
include=$1 filter=$2 out=$3
command -v doxygen >/dev/null || { echo "doxygen: not installed (make deps)" >&2 && exit 77; }
rm -rf "$out"
mkdir -p "$out"
doxygen - <<EOF || exit 1
PROJECT_NAME = glasspipe
PROJECT_BRIEF = "a software GPU of the 2005 class that gives the same bits everywhere"
INPUT = $include/glasspipe
RECURSIVE = YES
FILE_PATTERNS = *.h
EXCLUDE_PATTERNS = */base/lanes* */base/detmath.h
FILTER_PATTERNS = "*.h=awk -f $filter"
STRIP_FROM_PATH = $include
STRIP_FROM_INC_PATH = $include
OUTPUT_DIRECTORY = $out
HTML_OUTPUT = .
GENERATE_LATEX = NO
HAVE_DOT = NO
QUIET = YES
OPTIMIZE_OUTPUT_FOR_C = YES
TYPEDEF_HIDES_STRUCT = YES
EXTRACT_STATIC = YES
DISTRIBUTE_GROUP_DOC = YES
JAVADOC_AUTOBRIEF = YES
MARKDOWN_SUPPORT = NO
MACRO_EXPANSION = YES
EXPAND_ONLY_PREDEF = YES
PREDEFINED = "GP_INLINE=static inline" "__attribute__(x)="
WARN_NO_PARAMDOC = NO
WARN_AS_ERROR = FAIL_ON_WARNINGS
EOF
echo "documentation: $out/index.html, $(find "$out" -name '*.html' | wc -l) pages"
