#!/bin/sh
# Makes .venv and installs one lock file and this tree into it.
#
#   sh scripts/venv.sh requirements.lock|requirements-dev.lock
#
# The window's bindings (python3-gi) come from the system and work with the system's Python only.
# So the environment is made from that Python with its system packages.
set -eu
. "$(dirname "$0")/words.sh"
lock=$1

new_enough() {
    "$1" -c 'import sys; sys.exit(sys.version_info < (3, 11))' 2>/dev/null
}

find_python() {
    for candidate in /usr/bin/python3 python3.13 python3.12 python3.11 python3; do
        if command -v "$candidate" >/dev/null && new_enough "$candidate"; then
            command -v "$candidate"
            return 0
        fi
    done
    return 1
}

explain() {
    say "PINEL needs Python 3.11 or newer; this PC has $(/usr/bin/python3 --version 2>&1 || echo none). \
Debian 12, Ubuntu 24.04 and newer bring it." \
        "O PINEL precisa do Python 3.11 ou mais novo; este PC tem $(/usr/bin/python3 --version 2>&1 || echo nenhum). \
Debian 12, Ubuntu 24.04 e mais novos já o trazem." \
        "PINEL necesita Python 3.11 o más nuevo; este PC tiene $(/usr/bin/python3 --version 2>&1 || echo ninguno). \
Debian 12, Ubuntu 24.04 y más nuevos lo traen."
}

python=$(find_python) || {
    explain >&2
    exit 1
}
if [ "$python" != /usr/bin/python3 ]; then
    say "The system's Python is too old for the window: PINEL will open in the browser." \
        "O Python do sistema é antigo demais para a janela: o PINEL abrirá no navegador." \
        "El Python del sistema es demasiado antiguo para la ventana: PINEL se abrirá en el navegador."
fi
# Replace .venv if its Python was removed by an upgrade, or if it was moved: its scripts call the old path.
if ! .venv/bin/python -c 'import pip' 2>/dev/null || ! grep -qF "$PWD/.venv" .venv/pyvenv.cfg; then
    say "Preparing Python…" "Preparando o Python…" "Preparando Python…"
    "$python" -m venv --clear --system-site-packages .venv
fi
say "Installing Python libraries (about 1 minute)…" "Instalando bibliotecas Python (cerca de 1 minuto)…" \
    "Instalando bibliotecas de Python (cerca de 1 minuto)…"
.venv/bin/python -m pip install -qq --disable-pip-version-check --require-hashes -r "$lock"
.venv/bin/python -m pip install -qq --disable-pip-version-check --no-deps --no-build-isolation --editable .
