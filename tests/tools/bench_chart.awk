# The chart of a comparison: awk -f bench_json.awk -f bench_chart.awk peers.json >peers.svg
#
# A bar for each case: how many times faster than llvmpipe, on a logarithmic axis that begins where
# both are equally fast; slower cases reach to the left. A black mark is the case's target.

function escape(text)
{
    gsub(/&/, "\\&amp;", text)
    gsub(/</, "\\&lt;", text)
    gsub(/>/, "\\&gt;", text)
    return text
}

function text(x, y, class, words)
{
    printf "<text x=\"%.1f\" y=\"%.1f\" class=\"%s\">%s</text>\n", x, y, class, escape(words)
}

function line(x1, y1, x2, y2, class)
{
    printf "<line x1=\"%.1f\" y1=\"%.1f\" x2=\"%.1f\" y2=\"%.1f\" class=\"%s\"/>\n", x1, y1, x2,
           y2, class
}

function bar(x, y, width, height, class)
{
    printf "<rect x=\"%.1f\" y=\"%.1f\" width=\"%.1f\" height=\"%.1f\" class=\"%s\"/>\n", x, y,
           width, height, class
}

# Where a ratio is on the axis.
function place(ratio)
{
    return left + (log(ratio) - log(low)) / (log(high) - log(low)) * (right - left)
}

# The axis covers all bars and targets, and always 1/2 to 16.
function choose_axis(    i)
{
    low = 0.5
    high = 16
    for (i = 1; i <= rows; i++) {
        while (ratio[i] < low * 1.05 || (target[i] && target[i] < low * 1.05))
            low /= 2
        while (ratio[i] > high / 1.05 || (target[i] && target[i] > high / 1.05))
            high *= 2
    }
}

function write_head(    style)
{
    style = "text { font: 13px sans-serif; fill: #222 } .title { font-size: 20px; " \
            "font-weight: bold } .small { font-size: 12px; fill: #666 } .name { " \
            "text-anchor: end } .axis { text-anchor: middle; font-size: 12px; fill: #666 } " \
            ".grid { stroke: #ddd } .one { stroke: #666; stroke-width: 1.5 } .target { " \
            "stroke: #000; stroke-width: 2.5 } .met { fill: #2a9d8f } .missed { fill: " \
            "#e76f51 } .free { fill: #9aa5b1 } .strong { font-weight: bold }"
    printf "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"%d\" height=\"%d\" " \
           "viewBox=\"0 0 %d %d\">\n<style>%s</style>\n", width, height, width, height, style
    print "<rect width=\"100%\" height=\"100%\" fill=\"#fff\"/>"
    text(24, 36, "title", "glasspipe against llvmpipe: how many times faster it draws a frame")
    text(24, 60, "small", machine ", " threads " threads each, " date)
    text(24, 78, "small", peer "; " version "; medians of " rounds \
         " rounds, both drawn in turn")
}

function write_legend(    y)
{
    y = 98
    bar(24, y - 10, 14, 12, "met")
    text(44, y, "small", "target met")
    bar(124, y - 10, 14, 12, "missed")
    text(144, y, "small", "target missed")
    bar(244, y - 10, 14, 12, "free")
    text(264, y, "small", "no target")
    line(345, y - 11, 345, y + 3, "target")
    text(354, y, "small", "target: at least so many times as fast")
}

function write_axis(    value, bottom)
{
    bottom = top + rows * pitch + gap
    for (value = low; value <= high * 1.001; value *= 2) {
        line(place(value), top - 6, place(value), bottom, value == 1 ? "one" : "grid")
        text(place(value), top - 12, "axis", value < 1 ? "1/" 1 / value : value "x")
    }
    text(left, bottom + 22, "small", "Left of the line at 1x llvmpipe is faster. On the right: " \
         "milliseconds a frame, llvmpipe / glasspipe.")
}

function write_row(i,    y, from, to, class, strong)
{
    strong = name[i] == "mean" ? " strong" : ""
    y = top + (i - 1) * pitch + (strong ? gap / 2 : 0)
    from = place(1)
    to = place(ratio[i])
    class = met[i] == "null" ? "free" : met[i] == "true" ? "met" : "missed"
    bar(to > from ? from : to, y + 4, to > from ? to - from : from - to, pitch - 8, class)
    if (target[i])
        line(place(target[i]), y + 2, place(target[i]), y + pitch - 2, "target")
    text(left - 12, y + pitch - 8, "name" strong, strong ? "geometric mean" : name[i])
    text(24, y + pitch - 8, "small", strong ? "" : about[i])
    text(right + 14, y + pitch - 8, strong, short(ratio[i]) "x")
    if (!strong)
        text(right + 70, y + pitch - 8, "small", short(theirs[i]) " / " short(ours[i]))
}

/"date":/ { date = field($0, "date") }
/"machine":/ { machine = field($0, "machine") }
/"threads":/ { threads = field($0, "threads") }
/"rounds":/ { rounds = field($0, "rounds") }
/^  "llvmpipe":/ { peer = field($0, "llvmpipe") }
/^  "glasspipe":/ { version = field($0, "glasspipe") }

/"case":/ {
    name[++rows] = field($0, "case")
    ratio[rows] = field($0, "ratio") + 0
    target[rows] = field($0, "target") + 0 # null: 0
    met[rows] = field($0, "met")
    about[rows] = field($0, "about")
}
/^ +"llvmpipe": .*"ms":/ { theirs[rows] = field($0, "ms") + 0 }
/^ +"glasspipe": .*"ms":/ { ours[rows] = field($0, "ms") + 0 }

END {
    pitch = 24
    gap = 16
    top = 140
    left = 520
    right = 1040
    width = 1200
    height = top + rows * pitch + gap + 40
    choose_axis()
    write_head()
    write_legend()
    write_axis()
    for (i = 1; i <= rows; i++)
        write_row(i)
    print "</svg>"
}
