#!/bin/sh
# Units of which one line is another, and what is then seen:
#
#   break_it.sh page PROGRAM FOLDER PAGE    writes the sheet for people
#   break_it.sh test PROGRAM FOLDER         each draws another picture than PROGRAM does, as TAP
#
# FOLDER has a program for each scenes/lessons/break/NAME.patch, which the Makefile makes. A patch begins
# with what the page says of it: Title, Scene, Size, Seen, Why, Fast, each with a colon behind; lines that
# begin with a blank go on. All is drawn by the reference executor, whose units these are.
what=$1 program=$2 folder=$3 page=$4
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
. tests/tools/tap.sh

# field PATCH NAME
field() {
    awk -v name="$2:" '/^--- / { exit }
        $1 == name { on = 1; sub(/^[^ ]* */, ""); printf "%s", $0; next }
        on && /^ / { sub(/^ */, ""); printf " %s", $0; next }
        { on = 0 }' "$1"
}

# Draws before.png, after.png and difference.png; status 1 where the pictures differ, as they should
draw() {
    scene=$(field "$1" Scene) size=$(field "$1" Size)
    for one in before:$program "after:$folder/$(basename "$1" .patch)"; do
        "${one#*:}" render "$scene" --size "$size" --executor reference -q -o "$scratch/${one%%:*}.png" \
            >/dev/null || return 2
    done
    "$program" compare "$scratch/before.png" "$scratch/after.png" -q -o "$scratch/difference.png" >/dev/null
}

escaped() {
    sed -e 's/&/\&amp;/g' -e 's/</\&lt;/g' -e 's/>/\&gt;/g'
}

picture() { # NAME CAPTION
    printf '<figure><img alt="%s" src="data:image/png;base64,%s"><figcaption>%s</figcaption></figure>\n' "$2" \
        "$(base64 -w 0 "$scratch/$1.png")" "$2"
}

# The lines of the change, with a sign and a colour each.
change() {
    sed '1,/^+++ /d' "$1" | grep -v '^@@' | escaped | awk '
        /^-/ { print "<del>" $0 "</del>"; next }
        /^\+/ { print "<ins>" $0 "</ins>"; next }
        { print "<span>" $0 "</span>" }' | tr -d '\n'
}

entry() {
    unit=$(sed -n 's,^+++ b/,,p' "$1")
    title=$(field "$1" Title | escaped)
    printf '<section><h2>%s</h2>\n<p class="note"><code>%s</code></p>\n<pre tabindex="0" aria-label="The change">%s</pre>\n' \
        "$title" "$unit" "$(change "$1")"
    printf '<div class="pictures">\n'
    picture before "as it is"
    picture after "broken"
    picture difference "the difference"
    printf '</div>\n<p><b>Seen.</b> %s</p>\n<p><b>Why.</b> %s</p>\n' "$(field "$1" Seen | escaped)" \
        "$(field "$1" Why | escaped)"
    printf '<p class="note">Drawn of <code>%s</code> at %s by <code>--executor reference</code>. The fast executor: %s.</p></section>\n' \
        "$scene" "$size" "$(field "$1" Fast | escaped)"
}

write_page() {
    cat tests/tools/break_it.html
    for patch in scenes/lessons/break/*.patch; do
        draw "$patch"
        [ $? = 1 ] || { echo "$patch: draws the same picture, or none" >&2 && return 1; }
        entry "$patch"
    done
    printf '</main>\n</body>\n</html>\n'
}

if [ "$what" = page ]; then
    write_page >"$page.part" && mv "$page.part" "$page" || { rm -f "$page.part" && exit 1; }
    exit
fi
for patch in scenes/lessons/break/*.patch; do
    draw "$patch" 2>"$scratch/said"
    case $? in
    1) result ok "$patch draws another picture" ;;
    *) tried 1 "$patch draws another picture" "$scratch/said" ;;
    esac
    for name in Title Scene Size Seen Why Fast; do
        [ -n "$(field "$patch" $name)" ] || result "not ok" "$patch: no $name"
    done
    [ "$(sed '1,/^+++ /d' "$patch" | grep -c '^[-+]')" = 2 ] || result "not ok" "$patch: changes more than a line"
done
echo "1..$count"
exit "$failed"
