# Sourced by the set-up scripts: prints texts in the language of the PC.

# say ENGLISH PORTUGUESE SPANISH
say() {
    case "${LC_ALL:-${LC_MESSAGES:-${LANG:-}}}" in
        pt*) printf '%s\n' "$2" ;;
        es*) printf '%s\n' "$3" ;;
        *) printf '%s\n' "$1" ;;
    esac
}
