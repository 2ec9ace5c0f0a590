# Checks that includes point down the layers: awk -f check_includes.awk FILE...
#
# A file may include its own header, headers of lower layers, and those of its own layer unless the
# layer is one of units, which never know each other. Includes are written from the repository's
# root. Three more rules: only lanes.h includes intrinsics; C++ and the libraries behind it stay in
# pipeline/io; pictures and meshes come in through pipeline/io, not past it.

BEGIN {
    # layer 0: results, lanes, mathematics; 1: formats and memory; 2: the vocabulary; 3: the units;
    # 4: those that know the order of units
    layer("0", "base fpcontrol lanes detmath")
    layer("1", "format format_srgb pool surface")
    layer("2", "state compare packet texture texture_address texture_filter program profile " \
               "shader geometry")
    layer("3", "index_range input_assembly vertex_stage clip viewport setup scissor raster interpolate " \
               "pixel_stage texture_read alpha_test depth_stencil blend output")
    layer("4", "list list_check needs trace isa reference reference_draw device glasspipe")

    failed = 0
}

function layer(number, names,    list, n, i)
{
    n = split(names, list, " ")
    for (i = 1; i <= n; i++)
        layer_of[list[i]] = number
}

function complain(text)
{
    printf "%s:%d: %s\n", FILENAME, FNR, text
    failed = 1
}

# "pipeline/units/raster.h" -> "raster"; "pipeline/fast/bin.h" -> "fast/bin"
function unit_name(path)
{
    sub(/^pipeline\//, "", path)
    sub(/\.[a-z]+$/, "", path)
    return path
}

function area(path)
{
    if (path ~ /^pipeline\/io\//)
        return "io"
    if (path ~ /^pipeline\/fast\//)
        return "fast"
    sub(/\/.*/, "", path)
    return path
}

function known(name)
{
    if (name ~ /^fast\//)
        return "4"
    if (name ~ /^counting/)
        return "2"
    return name in layer_of ? layer_of[name] : ""
}

function check_pipeline(from, to)
{
    if (from == to)
        return
    if (known(from) == "") {
        if (!(from in told))
            complain("pipeline/" from " is in no layer; its place is tests/tools/check_includes.awk")
        told[from]
        return
    }
    if (known(to) == "")
        complain("includes pipeline/" to ", which is in no layer")
    else if (known(to) > known(from))
        complain("layer " known(from) " includes pipeline/" to ".h of layer " known(to))
    else if (known(to) == 3 && known(from) == 3)
        complain("a unit includes another unit: pipeline/" to ".h")
}

function check_project(from, to)
{
    if (area(from) == "pipeline" || area(from) == "fast") {
        if (area(to) != "pipeline" && area(to) != "fast")
            complain("the pipeline includes " to)
        else
            check_pipeline(unit_name(from), unit_name(to))
    } else if (area(from) == "io") {
        if (area(to) != "io" && (area(to) != "pipeline" || known(unit_name(to)) > 2))
            complain("pipeline/io includes " to "; it may know layers 0 to 2")
    } else if (area(from) == "shaders_c") {
        # NAME_surface.h is code that several shaders share, and may stand on other such code; other
        # headers are uniforms and programs
        code = "\\.c$|_surface\\.h$"
        allowed = from ~ code ? "pipeline/shader.h" : "pipeline/shader/program.h"
        own = from
        sub(/\.c$/, ".h", own)
        shared = area(to) == "shaders_c" && \
            (from ~ /_surface\.h$/ || (from ~ /\.h$/) == (to !~ /_surface\.h$/))
        if (to != allowed && to != own && !shared)
            complain("a shader includes its own header, what shaders share and " allowed ", not " to)
    } else if (area(from) == "apps") {
        if ((area(to) == "tests" && to !~ /^tests\/truth\//) || \
            (area(to) == "pipeline" && known(unit_name(to)) !~ /^[0124]$/))
            complain("apps include glasspipe.h, io, shaders_c, tests/truth, not " to)
        if (from ~ /\/tech_/ && area(to) == "io")
            complain("a technique reads no files: " to)
    } else if (from ~ /^tests\/truth\//) {
        if (to !~ /^tests\/truth\/|^apps\/camera\.h$|^pipeline\/(base|pool)\.h$/)
            complain("the truth shares no arithmetic with what it judges: " to)
    }
}

function check_library(from, to)
{
    if (to ~ /intrin\.h$|^arm_/ && from != "pipeline/base/lanes.h" && area(from) != "tests")
        complain("only pipeline/base/lanes.h holds intrinsics")
    if (to ~ /^(OpenImageIO|OpenMesh)\// && area(from) != "io")
        complain("only pipeline/io knows " to)
    if (to == "zlib.h" && area(from) !~ /^(io|tests)$/)
        complain("only pipeline/io and tests know " to)
    if (area(from) == "shaders_c")
        complain("a shader includes no library: " to)
    if (to ~ /^(jansson|cmocka)\.h$/ && area(from) ~ /^(pipeline|fast)$/)
        complain("the pipeline needs no library but xxhash: " to)
}

FNR == 1 && FILENAME ~ /\.(cpp|hpp)$/ && FILENAME !~ /^pipeline\/(io\/|counting)/ && \
    FILENAME !~ /^tests\// {
    complain("C++ lives in pipeline/io and in the counting lanes")
}

/^[ \t]*#[ \t]*include[ \t]*"/ {
    split($0, quoted, "\"")
    if (quoted[2] !~ /\//)
        complain("write \"" quoted[2] "\" from the repository's root")
    else
        check_project(FILENAME, quoted[2])
}

/^[ \t]*#[ \t]*include[ \t]*</ {
    split($0, angled, /[<>]/)
    check_library(FILENAME, angled[2])
}

END { exit failed }
