#!/usr/bin/env bash
# Sets up, builds and runs every test. Further arguments go to ctest: ./test.sh -R Validator
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")"

./setup.sh
cmake --preset release >/dev/null
cmake --build --preset release
ctest --preset release --parallel "$(nproc)" "$@"
