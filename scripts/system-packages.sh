#!/bin/sh
# Lists the Debian or Ubuntu packages that this PC lacks for a purpose, then installs them.
#
#   sh scripts/system-packages.sh [--dry-run] serve|run|test|package|nightly
#
# serve: Python.  run: also the native window.  test: also browser and virtual screen.
# package: the library that PyInstaller needs, for the Python of .venv.  nightly: makes other systems for tests, and Wine.
# --dry-run lists the missing packages and installs nothing; if any is missing, exits with 1.
set -eu
. "$(dirname "$0")/words.sh"

# PACKAGE|ENGLISH|PORTUGUESE|SPANISH
PYTHON_PACKAGES='python3|runs the program|executa o programa|ejecuta el programa
python3-venv|keeps our Python libraries apart|guarda as bibliotecas Python à parte|guarda aparte las bibliotecas de Python
ca-certificates|secure downloads|downloads seguros|descargas seguras'
WINDOW_PACKAGES='python3-gi|opens the window from Python|abre a janela pelo Python|abre la ventana desde Python
gir1.2-gtk-3.0|the window itself|a própria janela|la propia ventana
gir1.2-webkit2-4.1|shows the page in the window|mostra a página na janela|muestra la página en la ventana'
TEST_PACKAGES='xvfb|virtual screen for tests|tela virtual para os testes|pantalla virtual para las pruebas
openbox|places windows on the virtual screen|posiciona janelas na tela virtual|coloca ventanas en la pantalla virtual
xdotool|types and clicks in tests|digita e clica nos testes|escribe y pulsa en las pruebas
binutils|takes programs apart for the package|desmonta programas para o pacote|desmonta programas para el paquete
xz-utils|packs the package|comprime o pacote|comprime el paquete
nsis|makes the installer for Windows|cria o instalador para Windows|crea el instalador para Windows'
BROWSER='|browser for tests|navegador para os testes|navegador para las pruebas'
DDS_PACKAGES='g++|builds a robot for tests|compila um robô para os testes|compila un robot para las pruebas
libfastrtps-dev|the network of that robot|a rede desse robô|la red de ese robot'
NIGHTLY_PACKAGES='dpkg-dev|lists the packages of the stick|lista os pacotes do pendrive|lista los paquetes de la memoria USB
debootstrap|makes other systems to try the package in|cria outros sistemas para testar o pacote|crea otros sistemas para probar el paquete
strace|records where the program sends to|registra para onde o programa envia|registra adónde envía el programa
wine|runs the installer for Windows|executa o instalador para Windows|ejecuta el instalador para Windows
locales|languages for that test|idiomas para esse teste|idiomas para esa prueba'

wanted() {
    case "$1" in
        serve) printf '%s\n' "$PYTHON_PACKAGES" ;;
        run) printf '%s\n' "$PYTHON_PACKAGES" "$WINDOW_PACKAGES" ;;
        test)
            printf '%s\n' "$PYTHON_PACKAGES" "$WINDOW_PACKAGES" "$TEST_PACKAGES"
            command -v chromium-headless-shell >/dev/null || command -v chromium >/dev/null || printf '%s\n' "$(browser_package)$BROWSER"
            ! has_fast_dds || printf '%s\n' "$DDS_PACKAGES"
            ;;
        package)
            # Debian's python3 is not linked with its shared library, but PyInstaller ships that library.
            printf '%s\n' "libpython$(.venv/bin/python -c 'import sys; print("%d.%d" % sys.version_info[:2])')|Python inside the package|Python dentro do pacote|Python dentro del paquete"
            ;;
        nightly) printf '%s\n' "$NIGHTLY_PACKAGES" ;;
    esac
}

# Debian has a headless Chromium, which is enough for tests; Ubuntu's chromium-browser installs the snap.
browser_package() {
    for package in chromium-headless-shell chromium chromium-browser; do
        if apt-cache show "$package" >/dev/null 2>&1; then
            echo "$package"
            return
        fi
    done
    echo chromium
}

# True for Fast DDS 2. Systems with another version lack a package of this name; there its tests are skipped.
has_fast_dds() {
    apt-cache show libfastrtps-dev >/dev/null 2>&1 ||
        { [ -z "$(package_lists)" ] && grep -q '^VERSION_CODENAME=bookworm$' "${PINEL_OS_RELEASE:-/etc/os-release}"; }
}

# Prints names of installed packages and of the packages that they provide (Ubuntu's libpython3.12t64 provides libpython3.12).
installed() {
    dpkg-query -W -f '${db:Status-Status} ${Package}, ${Provides}\n' |
        sed -n 's/^installed //p' | sed 's/([^)]*)//g' | tr ', ' '\n\n' | sort -u
}

missing() {
    present=$(installed)
    wanted "$1" | while IFS= read -r line; do
        printf '%s\n' "$present" | grep -qxF -e "${line%%|*}" || printf '%s\n' "$line"
    done
}

show() {
    say "This PC lacks these system packages:" "Faltam neste PC estes pacotes do sistema:" \
        "A este PC le faltan estos paquetes del sistema:"
    printf '%s\n' "$1" | while IFS='|' read -r package en pt es; do
        printf '  %-20s %s\n' "$package" "$(say "$en" "$pt" "$es")"
    done
}

# Prints one of apt's package lists that match these conditions of `find`.
package_lists() {
    find "${PINEL_APT_LISTS:-/var/lib/apt/lists}" -name '*Packages*' "$@" 2>/dev/null | head -n 1
}

# With missing lists, or lists older than a week, apt may get "404 Not Found" for the newest versions.
lists_are_old() {
    [ -z "$(package_lists -mtime -7)" ]
}

# Runs apt-get; shows only its errors and the name of each installed package.
apt() {
    failed=$(mktemp)
    {
        $AS_ROOT env DEBIAN_FRONTEND=noninteractive apt-get -q -o DPkg::Lock::Timeout=300 "$@" </dev/null ||
            echo "$?" >"$failed"
    } | sed -n 's/^Setting up \([^ ]*\) .*/  \1/p'
    status=$(cat "$failed")
    rm -f "$failed"
    return "${status:-0}"
}

# Sets AS_ROOT to the prefix that runs a command as root; returns 1 if there is none.
find_root() {
    AS_ROOT=
    [ "$(id -u)" -ne 0 ] || return 0
    command -v sudo >/dev/null || return 1
    AS_ROOT=sudo
    if [ -t 0 ]; then
        say "sudo may ask for your password." "O sudo pode pedir sua senha." "sudo puede pedir su contraseña."
    else
        AS_ROOT="sudo -n"
    fi
}

ask_for_help() {
    say "They could not be installed from here. Ask whoever looks after this PC to run, as root:" \
        "Não foi possível instalá-los daqui. Peça a quem cuida deste PC para executar, como root:" \
        "No se pudieron instalar desde aquí. Pida a quien cuida este PC que ejecute, como root:"
    echo "  apt-get update && apt-get install --no-install-recommends $1"
    say "Then give the same command again." "Depois repita o mesmo comando." "Después repita la misma orden."
}

install() {
    find_root || return 1
    say "Installing them (a few minutes)…" "Instalando (alguns minutos)…" "Instalando (unos minutos)…"
    if lists_are_old; then
        # One unreachable source must not stop the installation, which fails by itself if it needs that source.
        apt update || true
    fi
    # shellcheck disable=SC2086 # names of packages: one word each
    apt install -y --no-install-recommends $1 || { apt update && apt install -y --no-install-recommends $1; }
}

main() {
    dry_run=
    if [ "${1:-}" = --dry-run ]; then
        dry_run=1
        shift
    fi
    case "${1:-}" in
        serve | run | test | package | nightly) ;;
        *)
            echo "usage: system-packages.sh [--dry-run] serve|run|test|package|nightly" >&2
            exit 2
            ;;
    esac
    if ! command -v dpkg-query >/dev/null || ! command -v apt-get >/dev/null; then
        [ ! -x .venv/bin/python ] || exit 0
        say "This is not Debian or Ubuntu: please install what corresponds to these packages yourself:" \
            "Este sistema não é Debian nem Ubuntu: instale você mesmo o equivalente a estes pacotes:" \
            "Este sistema no es Debian ni Ubuntu: instale usted el equivalente de estos paquetes:"
        wanted "${1:-}" | cut -d'|' -f1 | sed 's/^/  /'
        exit 0
    fi
    list=$(missing "${1:-}")
    [ -n "$list" ] || exit 0
    show "$list"
    [ -z "$dry_run" ] || exit 1
    names=$(printf '%s\n' "$list" | cut -d'|' -f1 | tr '\n' ' ')
    install "$names" || {
        ask_for_help "$names"
        exit 1
    }
}

main "$@"
