# What is read of JSON by the scripts around it: lines that hold one object each.

# The value of a field, the first of that name; "" where there is none. Strings come without their
# quotes, and may hold no others.
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
