# Every target makes what it needs; what is made already is not made again.
# Stamps lie inside what they speak of (.venv, ui/node_modules): delete the folder and it is made anew.

SHELL := /bin/sh
.DEFAULT_GOAL := help
.DELETE_ON_ERROR:
.NOTPARALLEL:
MAKEFLAGS += --no-print-directory

PYTHON := .venv/bin/python
VENV_RUN := .venv/.ready-run
VENV_DEV := .venv/.ready-dev
NODE_MODULES := ui/node_modules/.package-lock.json
PEERS := build/peers/.ready
PEERS_PIP := build/peers/bin/python -m pip install -qq --disable-pip-version-check
DETECTOR := build/peers/.ready-detector
ROS := build/ros/.ready
PAGE := pinel_desktop/web/static/index.html
PAGE_TYPES := ui/src/api/types.ts
HANDS := pinel_desktop/gestures/weights/hand.onnx
PACKAGE := dist/pinel-desktop/pinel

# Pages of docs/ that the page shows.
MANUALS := $(wildcard docs/*.pt-BR.md)
# The folders of ui/src are named too, so that a deleted file is noticed.
PAGE_SOURCES := $(shell find ui/src ui/public pinel_desktop/messages/catalogue -not -path ui/src/api/types.ts \
	-not -path ui/src/i18n/catalogue_types.ts 2>/dev/null) \
	$(shell find ui -maxdepth 1 -type f) $(MANUALS) $(MANUALS:.pt-BR.md=.md) $(wildcard docs/images/*.png) $(NODE_MODULES)
PROGRAM_SOURCES := $(shell find pinel_desktop sim storage packaging LICENSE -name __pycache__ -prune -o -path pinel_desktop/web/static \
	-prune -o -type f -print) pyproject.toml
NPM = PATH="$$(sh scripts/node.sh):$$PATH" && cd ui && npm
WITH_SCREEN := $(if $(DISPLAY)$(WAYLAND_DISPLAY),run,serve)

# An environment whose Python is gone (system upgraded) or that was moved or copied is mended.
ifneq ($(shell $(PYTHON) -c 'import pip' 2>/dev/null && cat $(VENV_RUN) 2>/dev/null),$(CURDIR))
$(shell rm -f $(VENV_RUN) $(VENV_DEV))
endif

.PHONY: help setup run test nightly lint format figures api bench package smoke deb portable stick wheel lock clean system-run system-test

help:  ## this list
	@sed -n 's/^\([a-z]*\):.*## /\1|/p' $(MAKEFILE_LIST) | awk -F'|' '{ printf "  make %-9s %s\n", $$1, $$2 }'

run: system-run $(VENV_RUN) $(PAGE) $(HANDS)  ## open PINEL (on a PC without a screen: serve its page and print the address)
	@$(PYTHON) -m pinel_desktop

setup: system-test $(VENV_DEV) $(NODE_MODULES) $(PAGE) $(PAGE_TYPES) $(HANDS)  ## everything that developing and testing need

test: setup $(ROS)  ## lint, types, unit and end-to-end tests, wheel, package and smoke test
	@$(PYTHON) scripts/run_tests.py

nightly: setup $(ROS) $(DETECTOR) deb portable  ## the long tests, the package in other systems and the benchmarks too
	@sh scripts/system-packages.sh nightly
	@$(PYTHON) scripts/run_tests.py --nightly

lint: $(VENV_DEV) $(NODE_MODULES)  ## style, types, import rules, sizes of folders
	@$(PYTHON) scripts/run_tests.py --only lint

format: $(VENV_DEV) $(NODE_MODULES)  ## bring the code into its form
	@$(PYTHON) -m ruff check --fix --quiet . && $(PYTHON) -m ruff format .
	@$(NPM) run --silent format

figures: $(VENV_DEV) $(NODE_MODULES)  ## what the structure of the code is judged by, counted
	@$(PYTHON) scripts/figures.py

api: $(VENV_DEV)  ## the HTTP interface as a page (docs/http-api.md)
	@$(PYTHON) scripts/http_api.py

bench: setup $(PEERS) $(DETECTOR)  ## benchmarks: absolute figures printed, ratios asserted
	@$(PYTHON) -m pytest -o python_files='bench_*.py' --timeout=900 -s -q tests/benchmarks

package: setup $(PACKAGE)  ## the program as a folder that needs no Python (dist/pinel-desktop)

smoke: package  ## try the package as an ordinary user in a bare environment
	@$(PYTHON) packaging/smoke.py

deb: package  ## the package for Debian and Ubuntu (dist/*.deb)
	@$(PYTHON) packaging/deb.py

portable: package  ## the program with a folder for the work beside it (dist/*.tar.xz)
	@$(PYTHON) packaging/portable.py

stick: deb portable  ## the folder for a USB stick, with all that a PC without internet needs (dist/stick; as root)
	@sh scripts/system-packages.sh nightly
	@if [ "$$(id -u)" -eq 0 ]; then $(PYTHON) packaging/stick.py; else sudo $(PYTHON) packaging/stick.py; fi

wheel: $(VENV_DEV) $(PAGE) $(HANDS)  ## the Python wheel, page included (dist/*.whl)
	@mkdir -p build && $(PYTHON) -m build --no-isolation --outdir dist >build/wheel.log 2>&1 || { cat build/wheel.log; exit 1; }
	@ls dist/*.whl

lock: $(VENV_DEV)  ## pin the Python dependencies anew (OPTIONS=--upgrade: newest versions)
	@sh scripts/lock.sh $(OPTIONS)

clean:  ## delete everything that was built or installed here
	rm -rf .venv build dist ui/node_modules pinel_desktop/web/static tests/artifacts
	rm -f pinel_desktop/gestures/weights/*.onnx pinel_desktop/gestures/weights/*-LICENSE.txt
	rm -rf .pytest_cache .mypy_cache .ruff_cache .import_linter_cache .hypothesis
	find . -name __pycache__ -type d -prune -exec rm -rf {} +

system-run:
	@sh scripts/system-packages.sh $(WITH_SCREEN)

system-test:
	@sh scripts/system-packages.sh test

# One environment: what runs the program, or that and the tools. The dev lock holds all of the other.
$(VENV_RUN): requirements.lock pyproject.toml scripts/venv.sh | system-run
	@test -e $(VENV_DEV) || sh scripts/venv.sh requirements.lock
	@test ! -e $(VENV_DEV) || $(MAKE) $(VENV_DEV)
	@echo '$(CURDIR)' >$@

$(VENV_DEV): requirements-dev.lock pyproject.toml scripts/venv.sh | system-test
	@sh scripts/venv.sh requirements-dev.lock
	@echo '$(CURDIR)' | tee $(VENV_RUN) >$@

# What benchmarks compare with needs much that the program does not: an environment of its own.
$(PEERS): requirements-bench.lock | $(VENV_DEV)
	@. scripts/words.sh; say "Installing the simulators to compare with (about 1 minute)…" \
		"Instalando os simuladores para comparar (cerca de 1 minuto)…" "Instalando los simuladores para comparar (cerca de 1 minuto)…"
	@$(PYTHON) -m venv --clear build/peers
	@$(PEERS_PIP) --require-hashes -r requirements-bench.lock
	@touch $@

# PyTorch has a build for each kind of PC, chosen by pip's settings (for NVIDIA's cards it takes gigabytes): its version is pinned,
# its hash cannot be. Without it one benchmark is skipped, and says so; the next `make bench` tries again.
$(DETECTOR): requirements-bench-alone.lock | $(PEERS)
	@. scripts/words.sh; say "Installing the detector to compare with (about 1 minute, 200 MB or more)…" \
		"Instalando o detector para comparar (cerca de 1 minuto, 200 MB ou mais)…" \
		"Instalando el detector para comparar (cerca de 1 minuto, 200 MB o más)…"
	@$(PEERS_PIP) torch==2.13.0 && $(PEERS_PIP) --require-hashes --no-deps -r requirements-bench-alone.lock && touch $@ || { \
		. scripts/words.sh; say "It could not be installed: its benchmark is skipped." "Não foi possível: esse teste fica de fora." \
		"No se pudo: esa prueba se omite."; } >&2

# A real rclpy for tests (60 MB to load, 250 MB on the disk); its wheels are for Linux on x86-64 only. Without it these tests are
# skipped, and say so; the next `make test` tries again.
$(ROS): requirements-ros.lock | $(VENV_DEV)
	@. scripts/words.sh; say "Installing ROS 2 for the tests (about 1 minute)…" "Instalando o ROS 2 para os testes (cerca de 1 minuto)…" \
		"Instalando ROS 2 para las pruebas (cerca de 1 minuto)…"
	@$(PYTHON) -m venv --clear build/ros
	@build/ros/bin/python -m pip install -qq --disable-pip-version-check --require-hashes -r requirements-ros.lock && touch $@ || { \
		. scripts/words.sh; say "It could not be installed: the tests that need it are skipped." \
		"Não foi possível: os testes que precisam dele ficam de fora." "No se pudo: las pruebas que lo necesitan se omiten."; } >&2

$(NODE_MODULES): ui/package.json ui/package-lock.json | $(VENV_RUN)
	@. scripts/words.sh; say "Installing the page's libraries (about 1 minute)…" \
		"Instalando as bibliotecas da página (cerca de 1 minuto)…" "Instalando las bibliotecas de la página (cerca de 1 minuto)…"
	@$(NPM) ci --loglevel=error --no-fund --no-audit >/dev/null
	@touch $@

$(PAGE): $(PAGE_SOURCES)
	@. scripts/words.sh; say "Building the page (a few seconds)…" "Montando a página (alguns segundos)…" \
		"Construyendo la página (unos segundos)…"
	@$(NPM) run --silent build -- --logLevel warn
	@touch $@

# The page's types of the HTTP interface: neither its build nor its tests need them, `npm run check` makes them anew.
$(PAGE_TYPES): $(VENV_DEV) $(NODE_MODULES)
	@$(NPM) run --silent types

# Written after the other network: while it is there, so are both. They are made anew when what makes them changes.
$(HANDS): requirements-models.lock $(wildcard scripts/hand_models/*.py) pinel_desktop/gestures/networks.py | $(VENV_RUN)
	@. scripts/words.sh; say "Preparing the hand recognition (about 10 seconds)…" \
		"Preparando o reconhecimento de mãos (cerca de 10 segundos)…" "Preparando el reconocimiento de manos (unos 10 segundos)…"
	@$(PYTHON) -m scripts.hand_models || { . scripts/words.sh; say "It needs the internet once: connect this PC and try again." \
		"É preciso internet uma vez: conecte este computador e tente de novo." \
		"Hace falta internet una vez: conecte esta computadora e intente de nuevo."; exit 1; } >&2

$(PACKAGE): $(PROGRAM_SOURCES) $(PAGE) $(HANDS) $(VENV_DEV)
	@sh scripts/system-packages.sh package
	@$(PYTHON) packaging/freeze.py
