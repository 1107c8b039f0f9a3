#!/usr/bin/env bash
# Sets up, builds, runs a plan (the quick start where none is given) and says where its report is.
#   ./run.sh [PLAN.yaml] [options of `mrppsim run`]
set -euo pipefail
here="$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)"

"$here/setup.sh"
(
    cd "$here"
    [ -f build/release/build.ninja ] || cmake --preset release >/dev/null
    cmake --build --preset release --target mrppsim
)
[ $# -gt 0 ] || set -- "$here/yaml/plans/quickstart.yaml" -o "$here/results/quickstart"
exec "$here/build/release/bin/mrppsim" run "$@"
