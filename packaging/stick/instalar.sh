#!/bin/sh
# Installs PINEL Desktop on this PC without internet, from the folder of this script.
#
#   sudo sh instalar.sh            PINEL
#   sudo sh instalar.sh --kiosk    PINEL, and the session that runs nothing else (docs/kiosk.md)
#
# apt reads only this folder, so the PC's own sources stay as they are. Exits with apt's status.
set -eu

say() {
    case "${LC_ALL:-${LANG:-pt}}" in
        en*) echo "$2" ;;
        es*) echo "$3" ;;
        fr*) echo "$4" ;;
        *) echo "$1" ;;
    esac
}

packages=pinel-desktop
[ "${1:-}" != --kiosk ] || packages="$packages cage xwayland udiskie"

fail() {
    say "$@" >&2
    exit 1
}

# Prints a path as an address for apt: each byte but the slash as %XX, because a path may have spaces and accents.
address() {
    printf %s "$1" | od -An -v -tx1 | tr -d ' \n' | sed 's/../%&/g; s|%2f|/|g'
}

[ "$(id -u)" -eq 0 ] || fail \
    "Para instalar é preciso ser administrador. Digite: sudo sh \"$0\"" \
    "Installing needs the administrator. Type: sudo sh \"$0\"" \
    "Para instalar hace falta ser administrador. Escriba: sudo sh \"$0\"" \
    "Il faut être administrateur pour installer. Tapez : sudo sh \"$0\""
command -v apt-get >/dev/null || fail \
    "Este sistema não tem o apt-get (Debian, Ubuntu). Use a versão portátil, o arquivo .tar.xz." \
    "This system has no apt-get (Debian, Ubuntu). Use the portable version, the file .tar.xz." \
    "Este sistema no tiene apt-get (Debian, Ubuntu). Use la versión portátil, el archivo .tar.xz." \
    "Ce système n'a pas apt-get (Debian, Ubuntu). Utilisez la version portable, le fichier .tar.xz."

folder=$(CDPATH='' cd -- "$(dirname -- "$0")" && pwd)
if ! (cd "$folder" && sha256sum --quiet -c SHA256SUMS); then
    fail "Um arquivo do pendrive está danificado ou falta. Copie a pasta de novo." \
        "A file on the stick is damaged or missing. Copy the folder again." \
        "Un archivo de la memoria USB está dañado o falta. Copie la carpeta de nuevo." \
        "Un fichier de la clé est abîmé ou manque. Copiez le dossier à nouveau."
fi

# Derived systems, such as Linux Mint, name the Debian or Ubuntu release that they build on.
codename=$(. /etc/os-release && echo "${DEBIAN_CODENAME:-${UBUNTU_CODENAME:-${VERSION_CODENAME:-}}}")
private=$(mktemp -d)
trap 'rm -rf "$private"' EXIT
mkdir -p "$private/lists/partial"
chmod -R a+rX "$private"
echo "deb [trusted=yes] file:$(address "$folder") ./" >"$private/sources.list"
if [ -n "$codename" ] && [ -d "$folder/$codename" ]; then
    echo "deb [trusted=yes] file:$(address "$folder/$codename") ./" >>"$private/sources.list"
else
    say "O pendrive não tem pacotes para este sistema ($codename): uso só o que já está no computador." \
        "The stick has no packages for this system ($codename): only what is on the PC is used." \
        "La memoria USB no tiene paquetes para este sistema ($codename): uso solo lo que ya está en la computadora." \
        "La clé n'a pas de paquets pour ce système ($codename) : seul ce qui est déjà sur l'ordinateur sert."
fi

apt() {
    DEBIAN_FRONTEND=noninteractive apt-get -q --no-install-recommends -o Dpkg::Use-Pty=0 \
        -o DPkg::Lock::Timeout=120 -o APT::Sandbox::User=root -o Dir::Etc::SourceList="$private/sources.list" \
        -o Dir::Etc::SourceParts=/dev/null -o Dir::State::Lists="$private/lists" "$@"
}

# Prints how many kB the new files take: what apt says, or in an update the new program beside the old one.
needed() {
    program=$(sed -n '/^Package: pinel-desktop$/,/^$/s/^Installed-Size: //p' "$folder/Packages")
    # --assume-no would not do: where nothing else changes, apt-get updates a package that was named without a question
    # shellcheck disable=SC2086 # one argument for each package
    (export LC_ALL=C && apt -y --print-uris --fix-broken install $packages || true) | awk -v program="${program:-0}" '
        BEGIN { size["kB"] = 1; size["MB"] = 1000; size["GB"] = 1000000 }
        /^After this operation/ {
            gsub(",", "", $4)
            more = /will be used/ ? int($4 * size[$5]) : 0
            print (more > program + 0) ? more : program
        }'
}

apt update
# what a power cut in the middle of an installation left
DEBIAN_FRONTEND=noninteractive dpkg --configure -a >/dev/null 2>&1 || true
needed_kb=$(needed)
needed_mb=$((${needed_kb:-0} / 1000 + 50))
free_mb=$(df -Pk /usr/lib | awk 'NR == 2 { print int($4 / 1000) }')
[ "$free_mb" -ge "$needed_mb" ] || fail \
    "O disco não tem espaço: são precisos $needed_mb MB, e há $free_mb MB livres. Libere espaço e repita; nada foi mudado." \
    "The disk has no room: $needed_mb MB are needed, and $free_mb MB are free. Free some and repeat; nothing was changed." \
    "El disco no tiene lugar: hacen falta $needed_mb MB, y hay $free_mb MB libres. Libere espacio y repita; nada cambió." \
    "Le disque n'a pas de place : il faut $needed_mb Mo, et $free_mb Mo sont libres. Libérez de la place et recommencez ; rien n'a changé."
# shellcheck disable=SC2086 # one argument for each package
apt -y --fix-broken --no-remove install $packages || fail \
    "A instalação não terminou. As linhas acima dizem por quê; nada dos grupos foi mexido." \
    "The installation did not finish. The lines above say why; nothing of the groups was touched." \
    "La instalación no terminó. Las líneas de arriba dicen por qué; nada de los grupos se tocó." \
    "L'installation n'est pas terminée. Les lignes au-dessus disent pourquoi ; rien des groupes n'a été touché."
if [ -f "$folder/pinel.toml" ]; then
    pinel setup --system "$folder/pinel.toml" >/dev/null || fail \
        "O PINEL está instalado, mas o arquivo pinel.toml tem os erros acima. Corrija-o e repita." \
        "PINEL is installed, but the file pinel.toml has the errors above. Correct it and repeat." \
        "PINEL está instalado, pero el archivo pinel.toml tiene los errores de arriba. Corríjalo y repita." \
        "PINEL est installé, mais le fichier pinel.toml a les erreurs ci-dessus. Corrigez-le et recommencez."
fi
say "Pronto. O PINEL está no menu, em Educação." "Done. PINEL is in the menu, under Education." \
    "Listo. PINEL está en el menú, en Educación." "C'est fait. PINEL est dans le menu, sous Éducation."
