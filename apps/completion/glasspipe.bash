# Bash completion of glasspipe. Commands and options come from the program's own --help, and the names
# that an option takes from what it says of another, so that they cannot disagree with it.

# What an option's value is called in the help: "FILE", "N"; empty where it takes none. The command is
# a word, or two.
_glasspipe_value()
{
    "$1" $2 --help 2>/dev/null | sed -nE "s/^ *(-., )?$3=([^ ]*).*/\2/p; s/^ *$3, --[a-z-]+=([^ ]*).*/\1/p"
}

# The names that an option takes: "--fit: expected light, casters, eye or adaptive, not '?'".
_glasspipe_names()
{
    "$1" $2 "$3" '?' 2>&1 | sed -nE "1{/expected an? |number|such as/d; s/, not '\?'//; s/ or / /; s/,//g; \
        s/.*: expected (one of )?//p}"
}

_glasspipe()
{
    local program=${COMP_WORDS[0]} command=${COMP_WORDS[1]} word=${COMP_WORDS[COMP_CWORD]}
    local before=${COMP_WORDS[COMP_CWORD-1]} words=
    if [ "$command" = chart ] && [ "$COMP_CWORD" -gt 2 ] && [ "${COMP_WORDS[2]:0:1}" != - ]; then
        command="chart ${COMP_WORDS[2]}" # whose settings are options too
    elif [[ "$command ${COMP_WORDS[2]}" =~ ^warp\ (capture|walk)$ ]] && [ "$COMP_CWORD" -gt 2 ]; then
        command="warp ${COMP_WORDS[2]}"
    fi
    if [ "$COMP_CWORD" -eq 1 ] || [ "$before" = help ]; then
        words="--help --version $("$program" --help 2>/dev/null |
            sed -n '/^Commands:/,/^$/s/^  \([a-z]*\) .*/\1/p')"
    elif [ "${word:0:1}" = - ]; then
        words=$("$program" $command --help 2>/dev/null | grep -oE -- '--[a-z-]+')
    else
        case ${before:0:1}$(_glasspipe_value "$program" "$command" "$before") in
            -*FILE | -*DIR | -*PATH | -*MESH | - | [!-]*)
                compopt -o filenames 2>/dev/null
                mapfile -t COMPREPLY < <(compgen -f -- "$word")
                return ;;
            *) words=$(_glasspipe_names "$program" "$command" "$before") ;;
        esac
    fi
    mapfile -t COMPREPLY < <(compgen -W "$words" -- "$word")
}

complete -F _glasspipe glasspipe
