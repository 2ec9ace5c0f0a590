# A public header as doxygen reads it: awk -f docs.awk HEADER
#
# Comments stay plain in the sources; here the one above a declaration becomes its documentation, and
# that of all that follow it without a blank line between, and the one behind a field is the field's. A
# field without a comment is one whose name says it. What stands behind the words of the shader language
# (gp_ and GP_ in its headers) is left out, and sections are only for readers of the source.
# Lines keep their numbers, but for one that is added at the top.

function close_group()
{
    if (grouped)
        printf "/**@}*/ "
    grouped = 0
}

# A comment above a declaration is held back until it is known what stands below.
function hold(text)
{
    held = held text "\n"
}
function let_go(shown)
{
    if (!shown)
        gsub(/[^\n]/, "", held)
    else if (held != "") {
        sub(/\n$/, " /**@{*/\n", held)
        grouped = 1
    }
    printf "%s", held
    held = ""
}

function comment_ends(text)
{
    return text ~ /\*\//
}

BEGIN {
    language = ARGV[1] ~ /shader\/(types|instructions|pixels|textures|entry_points)\.h$/
}

# inside a comment; a group opens behind the last line of one above a declaration
in_comment {
    gsub(/#/, "\\#")
    in_comment = !comment_ends($0)
    if (above)
        hold($0)
    else
        print
    next
}

# what is left out, to its end
dropping {
    dropping = dropping == "macro" ? ($0 ~ /\\$/ ? "macro" : "") : ($0 ~ /^}/ ? "" : "function")
    print ""
    next
}
language && /^#define (GP_|gp_(as|lane|coord)[( ])/ {
    dropping = $0 ~ /\\$/ ? "macro" : ""
    let_go(0)
    print ""
    next
}
# a comment behind the head of a function
language && /^GP_INLINE.*\/\*.*\*\/$/ && !/ gp_/ {
    at = index($0, "/*")
    let_go(1)
    print "/**" substr($0, at + 2) " " substr($0, 1, at - 1)
    next
}
language && /^GP_MAP|^GP_INLINE [a-z0-9]+ gp_|^__attribute__.* gp_/ {
    dropping = $0 ~ /^GP_MAP/ ? "" : "function"
    let_go(0)
    print ""
    next
}

/^\/\* ---/ {
    let_go(1)
    close_group()
    in_comment = !comment_ends($0)
    print
    next
}
FNR == 1 && /^\/\*/ {
    sub(/\/\*/, "/** @file\n *")
    print
    in_comment = !comment_ends($0)
    next
}
/^\/\*/ {
    close_group()
    let_go(1)
    sub(/\/\*/, "/**")
    hold($0)
    above = 1
    in_comment = !comment_ends($0)
    next
}
{
    let_go(1)
    above = 0
}
/^$|^#(if|endif|else)/ && !in_struct {
    close_group()
    print
    next
}

/^(typedef )?(struct|enum|union)[^;]*\{$/ {
    in_struct = 1
}
/^}/ {
    in_struct = 0
}
in_struct && /^ +\/\*/ {
    sub(/\/\*/, "/**")
    in_comment = !comment_ends($0)
    own_comment = 1
    print
    next
}
# each name of a field that has several
in_struct && /^ +[^(]*, [^(]*;/ {
    at = index($0, "/*")
    behind = at ? substr($0, at) : ""
    code = at ? substr($0, 1, at - 1) : $0
    gsub(/, /, ", /**< \\&nbsp; */ ", code)
    $0 = code behind
    if (!at)
        $0 = $0 " /**< \\&nbsp; */"
}
/[^ ].*\/\* / {
    own_comment = 0
    sub(/\/\* /, "/**< ")
    in_comment = !comment_ends($0)
    print
    next
}
in_struct && /^ +.*[;,]$/ || in_struct && /^ +[A-Z0-9_]+$/ {
    sub(/$/, own_comment ? "" : " /**< \\&nbsp; */")
    own_comment = 0
}
{
    print
}
