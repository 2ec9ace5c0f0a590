# Runs of two renderers into a table and a file:
#
#   awk -f bench_peers.awk -v ... cases.txt llvmpipe.jsonl glasspipe.jsonl
#
# Variables: json, the file to write; date, machine, peer, version, threads, rounds, which go into
# it. Prints the table. A case counts with the median of its runs, of those only that other
# processes did not disturb, if there are such. Exit status 1 when a picture changes from run to run
# or the renderers draw different sizes.

# The value of a field of a line that holds one object, the first of that name; "" where there is
# none. Strings come without their quotes, and may hold no others.
function field(line, name,    at, value)
{
    at = index(line, "\"" name "\":")
    if (!at)
        return ""
    value = substr(line, at + length(name) + 3)
    sub(/^ */, "", value)
    if (substr(value, 1, 1) == "\"") {
        value = substr(value, 2)
        return substr(value, 1, index(value, "\"") - 1)
    }
    return match(value, /^[-+.0-9a-zA-Z]+/) ? substr(value, 1, RLENGTH) : ""
}

# Three digits, as a number is read.
function short(x)
{
    return sprintf(x >= 100 ? "%.0f" : x >= 10 ? "%.1f" : "%.2f", x)
}

function remember(who, what,    run)
{
    if (field($0, "ms") == "")
        return
    run = ++runs[who, what]
    ms[who, what, run] = field($0, "ms") + 0
    min_ms[who, what, run] = field($0, "min_ms") + 0
    cpu_ms[who, what, run] = field($0, "cpu_ms") + 0
    first_ms[who, what, run] = field($0, "first_ms") + 0
    if (match($0, /"floor":/))
        floor[what] = field(substr($0, RSTART), "ms") + 0
    quiet[who, what, run] = field($0, "others") + 0 <= 0.15
    quiet_runs[who, what] += quiet[who, what, run]
    size = field($0, "width") "x" field($0, "height")
    if (run > 1 && (hash[who, what] != field($0, "hash") || sizes[who, what] != size))
        complain(what ": the pictures of " who " differ from run to run")
    if (field($0, "threads") + 0 != threads)
        fewer[who] = field($0, "threads")
    if (field($0, "executor") != "")
        engine = ", " field($0, "executor") " executor, " field($0, "isa")
    hash[who, what] = field($0, "hash")
    sizes[who, what] = size
}

function complain(message)
{
    print message >"/dev/stderr"
    bad = 1
}

# Of the runs that count.
function median(values, who, what,    n, i, j, x, sorted)
{
    n = 0
    for (i = 1; i <= runs[who, what]; i++) {
        if (quiet_runs[who, what] && !quiet[who, what, i])
            continue
        x = values[who, what, i]
        for (j = n++; j > 0 && sorted[j] > x; j--)
            sorted[j + 1] = sorted[j]
        sorted[j + 1] = x
    }
    return (sorted[int((n + 1) / 2)] + sorted[int(n / 2) + 1]) / 2
}

function least(values, who, what,    i, x)
{
    x = values[who, what, 1]
    for (i = 2; i <= runs[who, what]; i++)
        x = values[who, what, i] < x ? values[who, what, i] : x
    return x
}

function times(who, what)
{
    return sprintf("{ \"ms\": %.3f, \"min_ms\": %.3f, \"cpu_ms\": %.3f, \"first_ms\": %.3f, " \
                   "\"hash\": \"%s\", \"runs\": %d, \"undisturbed\": %d }",
                   median(ms, who, what), least(min_ms, who, what), median(cpu_ms, who, what),
                   median(first_ms, who, what), hash[who, what], runs[who, what],
                   quiet_runs[who, what])
}

function verdict(ratio, target)
{
    return target == "-" ? "" : ratio >= target ? "met" : "missed"
}

# A target and what became of it, for the file.
function outcome(ratio, target)
{
    return target == "-" ? "\"target\": null, \"met\": null" \
        : "\"target\": " target + 0 ", \"met\": " (ratio >= target ? "true" : "false")
}

function write_header()
{
    printf "{\n  \"date\": \"%s\",\n  \"machine\": \"%s\",\n", date, machine >json
    printf "  \"glasspipe\": \"%s\",\n  \"llvmpipe\": \"%s\",\n", version engine, peer >json
    printf "  \"threads\": %d,\n  \"rounds\": %d,\n  \"cases\": [", threads, rounds >json
}

# One line of the table and one of the file.
function report(what,    ours, theirs, ratio, result, note, separator, above)
{
    theirs = median(ms, "llvmpipe", what)
    ours = median(ms, "glasspipe", what)
    ratio = theirs / ours
    result = verdict(ratio, target[what])
    met += result == "met"
    missed += result == "missed"
    logs += log(ratio)
    counted++
    note = !quiet_runs["llvmpipe", what] || !quiet_runs["glasspipe", what] ? "disturbed" : ""
    disturbed += note != ""
    above = floor[what] ? short(ours / floor[what]) : ""
    printf "%-18s%10s%10s%9s%8s  %-7s%9s %s\n", what, short(theirs), short(ours), short(ratio),
           target[what], result, above, note
    separator = counted > 1 ? "," : ""
    printf "%s\n    { \"case\": \"%s\", \"ratio\": %.3f, %s, \"about\": \"%s\",\n" \
           "      \"floor_ms\": %s,\n      \"llvmpipe\": %s,\n      \"glasspipe\": %s }",
           separator, what, ratio, outcome(ratio, target[what]), about[what],
           floor[what] ? sprintf("%.3f", floor[what]) : "null", times("llvmpipe", what),
           times("glasspipe", what) >json
}

function report_mean(    mean)
{
    mean = exp(logs / counted)
    printf "%-38s%9s%8s  %s\n\n", "geometric mean of " counted, short(mean), target["mean"],
           verdict(mean, target["mean"])
    printf "%d targets met, %d missed\n", met, missed
    if (disturbed)
        printf "disturbed: other processes worked during all runs of %d cases\n", disturbed
    printf "\n  ],\n  \"mean\": { \"case\": \"mean\", \"ratio\": %.3f, %s, " \
           "\"about\": \"%s\" }\n}\n", mean, outcome(mean, target["mean"]), about["mean"] >json
}

FILENAME ~ /cases\.txt$/ {
    if (NF && !/^#/) {
        order[++cases] = $1
        target[$1] = $2
        about[$1] = $0
        sub(/^[^ ]+ +[^ ]+ +/, "", about[$1])
    }
    next
}

{ remember(FILENAME ~ /llvmpipe\.jsonl$/ ? "llvmpipe" : "glasspipe", field($0, "case")) }

END {
    print machine ", " threads " threads, medians of " rounds " rounds, " date
    print "against " peer ": " version engine
    for (who in fewer)
        print who " used " fewer[who] " threads, not " threads
    print ""
    printf "%-18s%10s%10s%9s%8s  %-7s%9s\n", "ms a frame", "llvmpipe", "glasspipe", "ratio",
           "target", "", "of floor"
    write_header()
    for (i = 1; i <= cases; i++) {
        what = order[i]
        if (!runs["llvmpipe", what] || !runs["glasspipe", what])
            continue
        if (sizes["llvmpipe", what] != sizes["glasspipe", what])
            complain(what ": the pictures differ in size")
        else
            report(what)
    }
    if (counted)
        report_mean()
    else
        complain("no case has figures of both")
    exit bad
}
