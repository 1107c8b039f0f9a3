#!/usr/bin/env bash
# Installs the Debian 12 packages that MRPPSim is built, tested and run with. Quick when all are there.
set -euo pipefail

packages=(
    g++ cmake ninja-build ccache pkg-config git
    libboost-graph-dev libboost-iostreams-dev libboost-filesystem-dev libboost-system-dev libcgal-dev
    graphviz gnuplot-nox libgnuplot-iostream-dev
    libpugixml-dev libyaml-cpp-dev libsqlite3-dev libcairo2-dev libpango1.0-dev libqpdf-dev zlib1g-dev
    libcli11-dev nlohmann-json3-dev libfmt-dev libssl-dev fonts-dejavu-core
    libgtest-dev libgmock-dev libbenchmark-dev librapidcheck-dev qpdf poppler-utils sqlite3 doxygen python3
    clang-format clang-tidy
)

# Only some tests need these, and are skipped without them: Slurm on two nodes of this machine, and the browsers in
# which the explorer's tests run, where Node.js builds the explorer.
optional=(slurmctld slurmd slurm-client munge)
if command -v node >/dev/null && command -v npm >/dev/null; then optional+=(chromium firefox-esr); fi

is_missing() { [ "$(dpkg-query -W -f='${db:Status-Status}' "$1" 2>/dev/null)" != installed ]; }
missing=()
for package in "${packages[@]}"; do
    if is_missing "$package"; then missing+=("$package"); fi
done
wanted=()
for package in "${optional[@]}"; do
    if is_missing "$package"; then wanted+=("$package"); fi
done
[ ${#missing[@]} -eq 0 ] && [ ${#wanted[@]} -eq 0 ] && exit 0

as_root=()
if [ "$(id -u)" -ne 0 ]; then
    if ! command -v sudo >/dev/null; then
        [ ${#missing[@]} -eq 0 ] && exit 0
        echo "setup.sh: run it as root, or install sudo: it installs ${missing[*]}" >&2
        exit 1
    fi
    as_root=(sudo)
fi
install() {
    "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get install -y -qq --no-install-recommends "$@" >/dev/null
}
echo "Installing $((${#missing[@]} + ${#wanted[@]})) packages: ${missing[*]} ${wanted[*]}"
"${as_root[@]}" apt-get update -qq || [ ${#missing[@]} -eq 0 ]
if [ ${#missing[@]} -gt 0 ]; then install "${missing[@]}"; fi
if [ ${#wanted[@]} -gt 0 ]; then
    install "${wanted[@]}" || for package in "${wanted[@]}"; do
        install "$package" || echo "setup.sh: $package could not be installed; the tests that need it are skipped" >&2
    done
fi
