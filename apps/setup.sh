# Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
# Installs the Debian packages that are missing. Sourced by apps/run.sh and, with $more_packages, by tests/run.sh.

packages="g++ cmake ninja-build lld
  libdeal.ii-dev libgmsh-dev libeigen3-dev libsuitesparse-dev libopenblas0-pthread libopenblas-dev libboost-dev libgmp-dev
  libtbb-dev libjemalloc-dev
  libvtk9-dev libtomlplusplus-dev libcli11-dev nlohmann-json3-dev libfmt-dev libgtest-dev libbenchmark-dev
  openmpi-bin pkgconf
  gnuplot-nox pybind11-dev python3-dev python3-numpy ${more_packages:-}"

missing=
for package in $packages; do
  status=$(dpkg-query -W -f '${db:Status-Status}' "$package" 2>/dev/null) || status=absent
  [ "$status" = installed ] || missing="$missing $package"
done

if [ -n "$missing" ]; then
  echo "Installing:$missing" >&2
  as_root=
  [ "$(id -u)" -eq 0 ] || as_root=sudo
  $as_root apt-get update >&2
  # shellcheck disable=SC2086  # a list of words
  $as_root env DEBIAN_FRONTEND=noninteractive apt-get install -y --no-install-recommends $missing >&2
fi
