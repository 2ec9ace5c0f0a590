# Finds calls that go up the floors, and circles of files and of folders by call and by include:
#
#   { nm -A -P OBJECT...; grep -E '#include ("|<glasspipe/)' SOURCE... /dev/null; } |
#       awk -v objects=BUILD/obj/ -f floors.awk -f check_circles.awk
#
# A file calls another when its object leaves undefined what the other's defines; the variants of a
# source for each lane width are one. Weak references are left out: the variants of a shader refer to
# each other so, and any may be missing.
# Says each fault with what makes it; exit status 1 if there is any, or if there was nothing to read.

BEGIN { failed = 0 }

# out/obj/apps/main.o: glass T 0 1f
/^[^ ]*\.o: / {
    from = unit(substr($1, 1, length($1) - 1))
    if ($3 ~ /^[TDBRC]$/)
        defined_in[$2] = from
    else if ($3 == "U")
        wanted[from, $2] = 1
    if (!(from in known))
        known[from] = ++files
    next
}

# apps/main.c:#include "apps/base/text.h"
/^[^ ]*: *# *include *"/ {
    split($0, quoted, "\"")
    sub(/:.*/, "", quoted[1])
    need("include", quoted[1], quoted[2], "")
    next
}

# apps/main.c:#include <glasspipe/glasspipe.h>
/^[^ ]*: *# *include *<glasspipe\// {
    split($0, angled, /[<>]/)
    sub(/:.*/, "", angled[1])
    need("include", angled[1], "pipeline/" angled[2], "")
    next
}

{ say("not understood: " $0) }

function say(fault)
{
    print fault
    failed = 1
}

function need(how, from, to, what)
{
    if (from == to || (how, from, to) in reason)
        return
    reason[how, from, to] = what
    add_edge(how, from, to)
    add_edge("folder", place("folder", from), place("folder", to))
    if (how == "call" && (fault = against_floors(from, to)) != "")
        say(fault ": " what)
}

function add_edge(kind, from, to)
{
    if (from == to || (kind, from, to) in edges)
        return
    edges[kind, from, to] = 1
    next_of[kind, from, ++degree[kind, from]] = to
    nodes[kind, from] = nodes[kind, to] = 1
}

# Tarjan, "Depth-first search and linear graph algorithms", SIAM Journal on Computing 1, 1972.
function visit(kind, node,    i, other, members, count)
{
    order[kind, node] = lowest[kind, node] = ++visited
    stack[++height] = node
    on_stack[kind, node] = 1
    for (i = 1; i <= degree[kind, node]; i++) {
        other = next_of[kind, node, i]
        if (!((kind, other) in order))
            visit(kind, other)
        if (on_stack[kind, other] && lowest[kind, other] < lowest[kind, node])
            lowest[kind, node] = lowest[kind, other]
    }
    if (lowest[kind, node] != order[kind, node])
        return
    delete circle
    count = 0
    do {
        other = stack[height--]
        on_stack[kind, other] = 0
        circle[other] = 1
        members = members " " other
        count++
    } while (other != node)
    if (count > 1)
        tell(kind, count, members)
}

function tell(kind, count, members,    edge, ends, from, to)
{
    say("circle of " count (kind == "folder" ? " folders:" : " files by " kind ":") members)
    for (edge in reason) {
        split(edge, ends, SUBSEP)
        from = place(kind, ends[2])
        to = place(kind, ends[3])
        if ((kind != "folder" && kind != ends[1]) || from == to || !(from in circle) || \
            !(to in circle) || told[kind, from, to]++)
            continue
        print "    " ends[2] " " ends[1] "s " ends[3] (reason[edge] ? ": " reason[edge] : "") | "sort"
    }
    close("sort")
}

# Where a file counts: as itself, or as its folder. A room of one unit is a place of its own.
function place(kind, file,    name)
{
    name = unit(file)
    return kind != "folder" ? file : room(name) == name ? name : folder(name)
}

END {
    for (pair in wanted) {
        split(pair, ends, SUBSEP)
        if (ends[2] in defined_in)
            need("call", ends[1], defined_in[ends[2]], ends[2])
    }
    for (node in nodes) {
        split(node, ends, SUBSEP)
        if (!(node in order))
            visit(ends[1], ends[2])
    }
    print files + 0 " objects, " floors " floors, " (failed ? "faults" : "no circle")
    exit failed || !files
}
