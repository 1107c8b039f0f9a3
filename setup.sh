#!/usr/bin/env bash
# Installs the Debian 12 packages that MRPPSim is built, tested and run with. Quick when all are there.
set -euo pipefail

packages=(
    g++ cmake ninja-build ccache pkg-config git
    libboost-graph-dev libboost-iostreams-dev libboost-filesystem-dev libboost-system-dev libcgal-dev
    libgraphviz-dev graphviz gnuplot-nox libgnuplot-iostream-dev
    libpugixml-dev libyaml-cpp-dev libsqlite3-dev libcairo2-dev libpango1.0-dev libqpdf-dev
    libcli11-dev nlohmann-json3-dev libfmt-dev libssl-dev fonts-dejavu-core
    libgtest-dev libgmock-dev libbenchmark-dev librapidcheck-dev qpdf poppler-utils sqlite3 doxygen
    clang-format clang-tidy
)

missing=()
for package in "${packages[@]}"; do
    [ "$(dpkg-query -W -f='${db:Status-Status}' "$package" 2>/dev/null)" = installed ] || missing+=("$package")
done
[ ${#missing[@]} -eq 0 ] && exit 0

as_root=()
if [ "$(id -u)" -ne 0 ]; then
    command -v sudo >/dev/null || { echo "setup.sh: run it as root, or install sudo: it installs ${missing[*]}" >&2; exit 1; }
    as_root=(sudo)
fi
echo "Installing ${#missing[@]} packages: ${missing[*]}"
"${as_root[@]}" apt-get update -qq
"${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get install -y -qq --no-install-recommends "${missing[@]}" >/dev/null
