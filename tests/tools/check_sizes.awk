# Checks the size of files and folders: awk -v reasons="PATH WHY..." -f check_sizes.awk FILE...
#
# A file has at most 500 lines, unless a line of `reasons` begins with it, or with its folder and a
# slash: then 800. A folder has at most 25 units (.h and .c of one name are one). Comments that stand
# alone have lines of at most 100 columns, which clang-format leaves to us. What turns clang-format off
# turns it on again.

BEGIN {
    MOST_LINES = 500
    MOST_WITH_REASON = 800
    MOST_UNITS = 25
    MOST_COLUMNS = 100
    n = split(reasons, lines, "\n")
    for (i = 1; i <= n; i++)
        if (split(lines[i], words, " ") > 1)
            has_reason[words[1]] = 1
    failed = 0
}

function complain(file, text)
{
    print file ": " text
    failed = 1
}

function end_file()
{
    if (file != "" && count > most(file))
        complain(file, count " lines, at most " most(file))
    if (is_off)
        complain(file, "clang-format off is never turned on again")
}

function most(file,    at)
{
    for (at = file; at != ""; sub(/[^\/]*\/?$/, "", at))
        if (at in has_reason)
            return MOST_WITH_REASON
    return MOST_LINES
}

FNR == 1 {
    end_file()
    file = FILENAME
    is_off = 0
    name = file
    sub(/\.[a-z]+$/, "", name)
    parent = name
    sub(/\/[^\/]*$/, "", parent)
    if (!(name in seen) && ++units[parent] == MOST_UNITS + 1)
        complain(parent, "more than " MOST_UNITS " units")
    seen[name] = 1
}

{ count = FNR }
length($0) > MOST_COLUMNS && !is_off && /^ *(\/\*|\*)/ {
    complain(file, "a comment is wider than " MOST_COLUMNS " columns in line " FNR)
}
/clang-format off/ { is_off = 1 }
/clang-format on/ { is_off = 0 }

END {
    end_file()
    exit failed
}
