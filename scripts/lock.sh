#!/bin/sh
# Pins every Python dependency anew, with hashes, for all platforms and Python 3.11 and later.
#
# requirements-dev.lock: everything; requirements.lock: what runs the program; requirements-node.lock: Node.js;
# requirements-bench.lock and requirements-bench-alone.lock: what benchmarks compare with, the second without what it
# needs to run; requirements-ros.lock: rclpy for tests; requirements-models.lock: the wheel that holds the hand networks, without what it needs to run.
# The second keeps the versions of the first, so that one environment can hold both.
set -eu
python=.venv/bin/python
"$python" -c 'import uv' 2>/dev/null || "$python" -m pip install --quiet uv

compile() {
    output=$1
    shift
    "$python" -m uv pip compile --quiet --universal --python-version 3.11 --generate-hashes --no-annotate --no-header \
        --no-emit-index-url --no-emit-find-links --output-file "$output" "$@"
}

compile requirements-dev.lock pyproject.toml --group dev "$@"
compile requirements.lock pyproject.toml --group setup --constraint requirements-dev.lock "$@"
compile requirements-node.lock --group node "$@"
compile requirements-bench.lock --group bench "$@"
compile requirements-bench-alone.lock --group bench-alone --no-deps "$@"
compile requirements-ros.lock --group ros "$@"
compile requirements-models.lock --group models --no-deps "$@"
