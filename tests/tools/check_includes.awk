# Checks what files include: awk -f floors.awk -f check_includes.awk FILE...
#
# Includes are written from the repository's root, those of the two public headers as users write
# them, <glasspipe/...>; they point to the same room or down (floors.awk).
# Further: a shader knows the shader language, its own header and what shaders share; applications know
# the machine by public headers, no unit and no executor, and techniques read no files; the truth
# shares no arithmetic with what it judges; intrinsics stand in pipeline/base/lanes, C++ in pipeline/io
# and the counting lanes, and each library where it belongs.

BEGIN { failed = 0 }

function complain(text)
{
    printf "%s:%d: %s\n", FILENAME, FNR, text
    failed = 1
}

function below(path, parent)
{
    return index(path, parent "/") == 1
}

function check_project(from, to,    fault)
{
    if (below(from, "tests"))
        return
    if ((fault = against_floors(unit(from), unit(to))) != "")
        complain(fault)
    if (below(from, "shaders_c"))
        check_shader(from, to)
    if (below(from, "pipeline/io") && to !~ /^pipeline\/(io|base|resources)\//)
        complain("pipeline/io knows base and resources, not " to)
    if (below(from, "apps") && below(to, "pipeline") && \
        to !~ /^pipeline\/(glasspipe\/glasspipe\.h$|base\/|resources\/|shader\/|list\/|io\/)/)
        complain("applications know the machine by its public headers, not by " to)
    if (below(from, "apps/techniques") && to ~ /^pipeline\/io\/(file|image\/)/)
        complain("a technique reads no files: " to)
    if (below(from, "apps/truth") && to !~ /^apps\/(truth|base)\/|^pipeline\/base\//)
        complain("the truth shares no arithmetic with what it judges: " to)
}

# NAME_shared.h is code that several shaders share, and may stand on other such code; other headers
# are uniforms and programs.
function check_shader(from, to,    is_code, is_shared, allowed, own)
{
    is_shared = to ~ /_shared\.h$/
    is_code = from ~ /\.c$|_shared\.h$/
    allowed = is_code ? "pipeline/glasspipe/shader.h" : "pipeline/shader/program.h"
    own = from
    sub(/\.c$/, ".h", own)
    if (to != allowed && to != own && \
        !(below(to, "shaders_c") && (from ~ /_shared\.h$/ || is_shared == (from ~ /\.c$/))))
        complain("a shader includes its own header, what shaders share and " allowed ", not " to)
}

function check_library(from, to)
{
    if (below(from, "shaders_c"))
        complain("a shader includes no library: " to)
    if (below(from, "tests"))
        return
    if (to ~ /intrin\.h$|^arm_/ && !below(from, "pipeline/base/lanes"))
        complain("only pipeline/base/lanes holds intrinsics")
    if (to ~ /^OpenImageIO\/|^zlib\.h$/ && !below(from, "pipeline/io"))
        complain("only pipeline/io knows " to)
    if (to == "jansson.h" && below(from, "pipeline") && !below(from, "pipeline/io"))
        complain("the pipeline needs no library but xxhash: " to)
}

FNR == 1 && FILENAME ~ /\.[ch]pp$/ && FILENAME !~ /^(pipeline\/io|tests)\/|\/counting/ {
    complain("C++ lives in pipeline/io and in the counting lanes")
}

/^[ \t]*#[ \t]*include[ \t]*"/ {
    split($0, quoted, "\"")
    if (quoted[2] !~ /\//)
        complain("write \"" quoted[2] "\" from the repository's root")
    else if (quoted[2] ~ /glasspipe\/[^\/]*$/)
        complain("write \"" quoted[2] "\" as users do, <glasspipe/...>")
    else
        check_project(FILENAME, quoted[2])
}

/^[ \t]*#[ \t]*include[ \t]*</ {
    split($0, angled, /[<>]/)
    if (below(angled[2], "glasspipe"))
        check_project(FILENAME, "pipeline/" angled[2])
    else
        check_library(FILENAME, angled[2])
}

END { exit failed }
