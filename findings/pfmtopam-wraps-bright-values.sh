#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# netpbm 11.01.00 (Debian 12): pfmtopam turns a float picture into integers. Values above 1 (a highlight, a metre of depth
# and more) are not clipped to white as one would expect: they wrap around, so that 1.5 becomes darker than 0.75, and
# -0.5 becomes a mid grey. Nothing is printed, and the exit status is 0.
#
# Output seen on 2026-12-01, for 0.25 0.75 1 1.25 1.5 2 -0.5:
#   64 191 255 63 127 254 129
# Exits 1 if that has changed. Needs a network, dpkg, apt-get and python3; installs nothing outside its folder.
set -eu
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
mkdir -p "$folder/lists/partial" "$folder/archives/partial" "$folder/root"
get() { apt-get -qq -o Debug::NoLocking=1 -o APT::Sandbox::User=root -o Dir::State::lists="$folder/lists" -o Dir::Cache="$folder" "$@"; }
get update
get install --download-only --reinstall --yes --no-install-recommends netpbm=2:11.01.00-2 >/dev/null
for package in "$folder"/archives/*.deb; do dpkg -x "$package" "$folder/root"; done
PATH=$folder/root/usr/bin:$PATH
LD_LIBRARY_PATH=$(echo "$folder"/root/usr/lib/*-linux-gnu)
export PATH LD_LIBRARY_PATH
cd "$folder"
python3 -c '
import struct
values = [0.25, 0.75, 1, 1.25, 1.5, 2, -0.5]
with open("light.pfm", "wb") as f:
    f.write(b"Pf\n7 1\n-1.0\n" + struct.pack("<7f", *values))'
samples=$(pfmtopam light.pfm 2>messages | python3 -c 'import sys; print(*sys.stdin.buffer.read()[-7:])')
echo "$samples"
cat messages
[ "$samples" = "64 191 255 63 127 254 129" ] && [ ! -s messages ]
