#!/usr/bin/env bash
# Makes a virtual environment with the pinned CasADi under target/ and the peers' shared libraries in target/casadi.
set -euo pipefail
cd "$(dirname "$0")/../.."
environment=target/python-bench
if [ ! -x "$environment/bin/python" ]; then
    python3 -m venv "$environment"
    "$environment/bin/python" -m pip install --quiet -r tests/reference/requirements.txt
fi
"$environment/bin/python" benches/casadi/generate.py target/casadi
