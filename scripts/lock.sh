#!/bin/sh
# Updates all lock files: pins every Python dependency with hashes, for all platforms and Python 3.11 and later.
#
# requirements-dev.lock: everything for development
# requirements.lock: the program, in the versions of requirements-dev.lock, so that one environment can have both
# requirements-node.lock: Node.js
# requirements-bench.lock: libraries that benchmarks compare with
# requirements-bench-alone.lock: such libraries that are installed without their dependencies
# requirements-ros.lock: rclpy for tests
# requirements-models.lock: the wheel with the hand networks, without its dependencies
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
