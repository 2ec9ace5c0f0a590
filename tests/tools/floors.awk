# The floors of the sources, and which one a file stands on: to be put before another script by -f.
#
# A file needs only files of its own room and of floors below, by include and by call. A room is a
# folder with all below it, or one file; rooms of one floor do not know each other. A folder that is
# not in the table is a fault: its place must be chosen.

BEGIN {
    # from the ground up; "/*" is each folder below
    floor("pipeline/base")
    floor("pipeline/resources")
    floor("pipeline/shader")
    floor("pipeline/units")
    floor("pipeline/list")
    floor("pipeline/reference pipeline/fast/draws")
    floor("pipeline/fast/lanes") # names, and the table of stages
    floor("pipeline/fast/lanes/memory")
    floor("pipeline/fast/lanes/texture pipeline/fast/lanes/output")
    floor("pipeline/fast/lanes/geometry pipeline/fast/lanes/shade")
    floor("pipeline/fast/lanes/raster")
    floor("pipeline/fast/lanes/tile")
    floor("pipeline/fast")
    floor("pipeline/glasspipe") # the public headers
    floor("pipeline") # the device
    floor("pipeline/io")
    floor("shaders_c")
    floor("apps/base")
    floor("apps/frame apps/items")
    floor("apps/compare apps/points apps/volumes apps/depth_images apps/fragments")
    floor("apps/scene")
    floor("apps/truth apps/effect")
    floor("apps/techniques")
    floor("apps/techniques/*")
    floor("apps/techniques/registry")
    floor("apps/charts apps/bench apps/golden apps/inspect")
    floor("apps/commands")
    floor("apps/commands/*")
    floor("apps") # main
    floor("apps/mpi")
    # rooms in which no file knows another, but texture and texture_read are one unit
    apart["pipeline/units"] = 1
}

function floor(rooms,    list, n, i)
{
    floors++
    n = split(rooms, list, " ")
    for (i = 1; i <= n; i++) {
        floor_of[list[i]] = floors
        while (sub(/\/[^\/]*$/, "", list[i]))
            has_rooms[list[i]] = 1 # only its own files stand here
    }
}

# "pipeline/units/blend.h" and "out/obj/pipeline/units/blend.lanes8.o" -> "pipeline/units/blend"
function unit(path)
{
    if (objects != "" && index(path, objects) == 1)
        path = substr(path, length(objects) + 1)
    sub(/(\.lanes[0-9]+|\.count)?\.[a-z]+$/, "", path)
    return path
}

function folder(name)
{
    return name ~ /\// ? substr(name, 1, match(name, /\/[^\/]*$/) - 1) : ""
}

# The room of a unit, "" where the table has none.
function room(name,    at, parent)
{
    if (name in room_of)
        return room_of[name]
    for (at = name; at != ""; at = parent) {
        parent = folder(at)
        if (at in floor_of && (at == name || at == folder(name) || !(at in has_rooms)))
            return room_of[name] = at
        if (at != name && (parent "/*") in floor_of) {
            floor_of[at] = floor_of[parent "/*"]
            return room_of[name] = at
        }
    }
    return room_of[name] = ""
}

# Why a unit must not need another; "" where it may.
function against_floors(from, to,    a, b)
{
    a = room(from)
    b = room(to)
    if (from == to)
        return ""
    if (a == "" || b == "")
        return (a == "" ? from : to) " stands on no floor; its place is in tests/tools/floors.awk"
    if (a == b)
        return a in apart && index(from, to "_") != 1 && index(to, from "_") != 1 ? \
            "one unit knows another: " from " needs " to : ""
    if (floor_of[a] == floor_of[b])
        return from " knows " to ", but " a " and " b " do not know each other"
    return floor_of[b] < floor_of[a] ? "" : from " needs " to " of a floor above"
}
