#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# One float depth map in PFM, read by three programs of Debian 12. PFM stores the bottom row first, and the magnitude of
# the third header line is a scale factor. The programs disagree about both:
#
#   libvips 8.14.1   keeps the file's order, so the picture is upside down, and ignores the factor
#   pfstools 2.2.0   turns the picture upright and multiplies by the factor
#   netpbm 11.01.00  turns the picture upright and divides by the factor
#
# A depth map with a factor other than 1 therefore differs by the factor's square between two of them, and a map written
# by `vips copy` looks right only to libvips. Write PFM with the factor 1 (or -1), and look at the picture once.
#
# Output seen on 2026-12-01, for rows 0.4 0.8 (top) and 0.1 0.2 (bottom) with the factor 2:
#   vips:     top row 0.1 0.2
#   pfstools: top row 0.8 1.6
#   netpbm:   top row 0.2 0.4
# Exits 1 if any of it has changed. Needs a network, dpkg, apt-get and python3; installs nothing outside its folder.
set -eu
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
mkdir -p "$folder/lists/partial" "$folder/archives/partial" "$folder/root"
get() { apt-get -qq -o Debug::NoLocking=1 -o APT::Sandbox::User=root -o Dir::State::lists="$folder/lists" -o Dir::Cache="$folder" "$@"; }
get update
get install --download-only --reinstall --yes --no-install-recommends \
    libvips-tools=8.14.1-3+deb12u3 pfstools=2.2.0-5+b1 netpbm=2:11.01.00-2 >/dev/null
for package in "$folder"/archives/*.deb; do dpkg -x "$package" "$folder/root"; done
PATH=$folder/root/usr/bin:$PATH
LD_LIBRARY_PATH=$(echo "$folder"/root/usr/lib/*-linux-gnu)
export PATH LD_LIBRARY_PATH
cd "$folder"
python3 -c '
import struct
with open("depth.pfm", "wb") as f:
    f.write(b"Pf\n2 2\n-2.0\n" + struct.pack("<4f", 0.1, 0.2, 0.4, 0.8))'

vips=$(printf '%.1f %.1f' $(vips getpoint depth.pfm 0 0) $(vips getpoint depth.pfm 1 0))
# pfstools writes PFM with the factor 1, the bottom row first.
pfsin depth.pfm | pfsout out.pfm
pfs=$(python3 -c '
import struct
data = open("out.pfm", "rb").read()
print("%.1f %.1f" % struct.unpack("<4f", data[-16:])[2:])')
netpbm=$(pfmtopam depth.pfm | python3 -c '
import sys
data = sys.stdin.buffer.read()
print("%.1f %.1f" % tuple(v / 255 for v in data[-4:-2]))')
echo "vips:     top row $vips"
echo "pfstools: top row $pfs"
echo "netpbm:   top row $netpbm"
[ "$vips" = "0.1 0.2" ] && [ "$pfs" = "0.8 1.6" ] && [ "$netpbm" = "0.2 0.4" ]
