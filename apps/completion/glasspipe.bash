# Bash completion of glasspipe. Options come from the commands' own --help, so that they cannot
# disagree with it.

_glasspipe()
{
    local word=${COMP_WORDS[COMP_CWORD]} before=${COMP_WORDS[COMP_CWORD-1]} program=${COMP_WORDS[0]}
    local command=${COMP_WORDS[1]}
    COMPREPLY=()
    if [ "$COMP_CWORD" -eq 1 ]; then
        mapfile -t COMPREPLY < <(compgen -W 'render voxelize shadow compare explain pixel bench chart help --help --version' \
            -- "$word")
        return
    fi
    case $before in
        --isa) mapfile -t COMPREPLY < <(compgen -W 'auto sse2 avx2 avx512 neon' -- "$word") ;;
        --executor) mapfile -t COMPREPLY < <(compgen -W 'reference fast' -- "$word") ;;
        help) mapfile -t COMPREPLY < <(compgen -W 'render voxelize shadow compare explain pixel bench chart' -- "$word") ;;
        --table) mapfile -t COMPREPLY < <(compgen -W '2.1 2.2 4.1 4.2' -- "$word") ;;
        --kind) mapfile -t COMPREPLY < <(compgen -W 'surface solid' -- "$word") ;;
        --value) mapfile -t COMPREPLY < <(compgen -W 'density normal color' -- "$word") ;;
        --combine) mapfile -t COMPREPLY < <(compgen -W 'union intersection difference collide' -- "$word") ;;
        --look) mapfile -t COMPREPLY < <(compgen -W 'opaque transparent' -- "$word") ;;
        --shading) mapfile -t COMPREPLY < <(compgen -W 'smooth cubes' -- "$word") ;;
        --up) mapfile -t COMPREPLY < <(compgen -W 'y z x -y -z' -- "$word") ;;
        --blend) mapfile -t COMPREPLY < <(compgen -W 'add or' -- "$word") ;;
        -n | --size | --threads | -t | --time | --dump | --pass | --scale | --fail | --failpercent | --hardfail | \
            --warn | --warnpercent | --hardwarn | --method | --filter | --map | --depth | --bias | --slope | \
            --normal-offset | --casters | --fit | --facing | --outside | --error | \
            --bits | --axes | --xform | --twist | --move | --picture | --from | --zoom) ;;
        *)
            if [ "${word:0:1}" = - ]; then
                local options
                options=$("$program" "$command" --help 2>/dev/null | grep -oE -- '--[a-z-]+')
                mapfile -t COMPREPLY < <(compgen -W "$options" -- "$word")
            else
                compopt -o filenames
                mapfile -t COMPREPLY < <(compgen -f -- "$word")
            fi
            ;;
    esac
}

complete -F _glasspipe glasspipe
