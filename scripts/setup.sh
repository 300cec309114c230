#!/usr/bin/env bash
# Installs the Debian packages that RaDiVe needs and that are missing. Says nothing when none is.
# Works as root, or through sudo. With --tests also those that single tests need, which skip without.
set -euo pipefail

packages=(
  build-essential cmake libceres-dev libeigen3-dev libsuitesparse-dev libgoogle-glog-dev libgflags-dev
  libyaml-cpp-dev libnanoflann-dev robin-map-dev nlohmann-json3-dev libgtest-dev libgmock-dev
  libbenchmark-dev libsqlite3-dev libbz2-dev liblz4-dev liblzf-dev libzstd-dev libhdf5-dev libxxhash-dev
  zlib1g-dev locales pkg-config python3 python3-numpy python3-matplotlib python3-rosbag
  python3-h5py
)
if [[ ${1:-} == --tests ]]; then packages+=(slurm-wlm munge chromium); fi

missing=()
for package in "${packages[@]}"; do
  status=$(dpkg-query --show --showformat '${db:Status-Status}' "$package" 2>/dev/null || true)
  [[ $status == installed ]] || missing+=("$package")
done
[[ ${#missing[@]} -gt 0 ]] || exit 0

sudo=()
if [[ $(id -u) -ne 0 ]]; then
  if ! command -v sudo >/dev/null; then
    echo "setup.sh: cannot install without root or sudo; missing: ${missing[*]}" >&2
    exit 1
  fi
  sudo=(sudo)
fi
export DEBIAN_FRONTEND=noninteractive
echo "+ apt-get install ${missing[*]}"
"${sudo[@]}" apt-get update -qq
"${sudo[@]}" env DEBIAN_FRONTEND=noninteractive \
  apt-get install -y -qq --no-install-recommends "${missing[@]}" >/dev/null
