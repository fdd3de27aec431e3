#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# OpenEXR's DWA compression, as written by OpenImageIO 2.4.7 (Debian 12), decides by the NAME of a channel whether a 32-bit
# float channel keeps its values. The same depth beside the same half RGB is kept to the bit as "Z" or "depth.V", and
# changed by up to 12 mm at 1.7 m as "Y" or "depth.Y", which is the name that programs give to the single channel of a
# grey picture. If the depth is alone in the file, oiiotool writes ZIP although DWA was asked for, without saying so,
# and nothing is lost; so a test with a depth map alone shows none of this.
#
# Output seen on 2026-12-01:
#   Z        dwaa  largest error 0.0000
#   depth.V  dwaa  largest error 0.0000
#   Y        dwaa  largest error 0.0121
#   depth.Y  dwaa  largest error 0.0121
#   alone    zip   largest error 0.0000
# Exits 1 if any of it has changed. Needs a network, dpkg, apt-get and python3; installs nothing outside its folder.
set -eu
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
mkdir -p "$folder/lists/partial" "$folder/archives/partial" "$folder/root"
get() { apt-get -qq -o Debug::NoLocking=1 -o APT::Sandbox::User=root -o Dir::State::lists="$folder/lists" -o Dir::Cache="$folder" "$@"; }
get update
get install --download-only --reinstall --yes --no-install-recommends \
    openimageio-tools=2.4.7.1+dfsg-2 openexr=3.1.5-5 >/dev/null
for package in "$folder"/archives/*.deb; do dpkg -x "$package" "$folder/root"; done
PATH=$folder/root/usr/bin:$PATH
LD_LIBRARY_PATH=$(echo "$folder"/root/usr/lib/*-linux-gnu)
export PATH LD_LIBRARY_PATH
cd "$folder"
python3 -c '
import math, struct
size = 64
depth = [1 + 0.5 * math.sin(x / 7) + 0.3 * math.cos(y / 5) + (1.2 if x > 30 else 0) for y in range(size) for x in range(size)]
with open("depth.pfm", "wb") as f:
    f.write(b"Pf\n%d %d\n-1.0\n" % (size, size) + struct.pack("<%df" % len(depth), *depth))'
oiiotool depth.pfm --ch 0,0,0 --chnames R,G,B -d half -o colour.exr

describe() { # NAME FILE CHANNEL
    case $(exrheader "$2" | grep '^compression') in *dwa*) kind=dwaa ;; *zip*) kind=zip ;; *) kind=other ;; esac
    oiiotool "$2" --ch "$3" -o channel.exr
    error=$(oiiotool depth.pfm channel.exr --diff 2>&1 | sed -n 's/.*Max error *= *\([^ ]*\).*/\1/p')
    printf '%-8s %-5s largest error %.4f\n' "$1" $kind "${error:-0}"
}
for name in Z depth.V Y depth.Y; do
    oiiotool colour.exr depth.pfm --chnames $name --chappend -d half -d $name=float --compression dwaa:45 -o both.exr
    describe $name both.exr $name
done >output
oiiotool depth.pfm --chnames Y -d float --compression dwaa:45 -o alone.exr
describe alone alone.exr Y >>output
cat output
cat >expected <<TXT
Z        dwaa  largest error 0.0000
depth.V  dwaa  largest error 0.0000
Y        dwaa  largest error 0.0121
depth.Y  dwaa  largest error 0.0121
alone    zip   largest error 0.0000
TXT
cmp output expected
