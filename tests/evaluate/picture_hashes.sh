#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# usage: picture_hashes.sh CLI OUT [EXPECTED]
# Renders a fixed list of pictures with the patina-cli CLI into the folder OUT and prints their SHA-256, so that anyone can
# check that a change leaves pictures as they were. With EXPECTED, the output of an earlier run, fails where they differ.
# Hashes compare on one machine and driver only. PATINA_REFERENCE_DATA in the environment adds the path-traced scenes and
# two photographs of the reference data.
set -euo pipefail
resources=$(cd "$(dirname "$0")/../../resources" && pwd)
cli=$(realpath "$1")
mkdir -p "$2"
out=$(cd "$2" && pwd)
expected=${3:+$(realpath "$3")}
samples=4
cd "$out"
rm -rf -- ./*.exr ./*.log ./*.patina ./*.png studio hashes.txt
cp -r "$resources/samples/studio" studio

failed=0
run() { # NAME ARG...: runs the command line; its messages go to NAME.log
    local name=$1
    shift
    "$cli" "$@" >"$name.log" 2>&1 || { echo "Failed: $name ($out/$name.log)" >&2; failed=1; }
}
render() { # NAME PROJECT ARG...
    local name=$1 project=$2
    shift 2
    run "$name" render "$project" --samples "$samples" "$@" -o "$name.exr"
}
layers() { # NAME PROJECT LAYER...
    local name=$1 project=$2 layer
    shift 2
    for layer in "$@"; do run "${name}_$layer" export "$project" --layer "$layer" -o "${name}_$layer.exr"; done
}

# The bundled sample: every BRDF, a conductor, translucency, a drive, a BRDF written by a user, and noisy depth.
sample=studio/studio.patina
for brdf in none lambert oren_nayar phong blinn_phong ward ggx coated artist; do
    render "studio_$brdf" "$sample" --edit "vase={\"brdf\": \"$brdf\"}"
done
render studio_gold "$sample" --no-filter --edit \
    'bag={"brdf": "ggx", "alpha": 0.2, "fresnel": "conductor", "eta": [0.18, 0.42, 1.37], "k": [3.42, 2.35, 1.77]}'
render studio_wax "$sample" --edit 'figurine={"brdf": "phong", "translucency": {"preset": "skin1", "scale": 2}}'
render studio_drive "$sample" --edit \
    'vase={"brdf": "ggx", "alpha": 0.3, "drives": [{"parameter": "alpha", "source": "luminance"}]}'
render studio_user "$sample" --edit "vase={\"brdf\": \"file:$resources/brdf/velvet.brdf.glsl\"}"
run millimetres create --color studio/color.jpg --depth studio/depth_mm.png --depth-unit 0.001 \
    --segments studio/segments.png --glossy 2 --hfov 40 -o millimetres.patina
render millimetres millimetres.patina --edit '2={"brdf": "ggx", "alpha": 0.3}' --edit '3={"brdf": "lambert"}'
layers studio "$sample" environment normals back-depth

label_map() { # FILE WIDTH HEIGHT CONDITION: an 8-bit PNG, 1 where the Python expression in x and y holds
    python3 - "$@" <<'PYTHON'
import struct, sys, zlib
path, width, height = sys.argv[1], int(sys.argv[2]), int(sys.argv[3])
inside = eval("lambda x, y: " + sys.argv[4])
rows = b"".join(b"\0" + bytes(int(inside(x, y)) for x in range(width)) for y in range(height))
chunk = lambda kind, data: struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))
with open(path, "wb") as file:
    file.write(b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", struct.pack(">IIBBBBB", width, height, 8, 0, 0, 0, 0)) +
               chunk(b"IDAT", zlib.compress(rows)) + chunk(b"IEND", b""))
PYTHON
}

scene_options() { # SCENE.JSON: camera and glossy labels as options of `create`
    python3 - "$1" <<'PYTHON'
import json, sys
scene = json.load(open(sys.argv[1]))
glossy = ",".join(str(segment["label"]) for segment in scene["segments"] if segment.get("glossy"))
print("--intrinsics", ",".join(repr(scene[key]) for key in ("fx", "fy", "cx", "cy")), *(["--glossy", glossy] if glossy else []))
PYTHON
}

if [[ -n ${PATINA_REFERENCE_DATA:-} ]]; then
    for scene in "$PATINA_REFERENCE_DATA"/synthetic/*/scene.json; do
        folder=$(dirname "$scene")
        name=$(basename "$folder")
        read -ra options < <(scene_options "$scene")
        run "${name}_create" create --color "$folder/color.exr" --depth "$folder/depth.exr" \
            --segments "$folder/segments.png" "${options[@]}" -o "$name.patina"
        render "${name}_ggx" "$name.patina" --edit '2={"brdf": "ggx", "alpha": 0.3}'
        render "${name}_marble" "$name.patina" --edit \
            '2={"brdf": "lambert", "albedo": [0.6, 0.3, 0.2], "translucency": {"preset": "marble"}}'
        layers "$name" "$name.patina" environment normals back-depth
    done
    photos=$PATINA_REFERENCE_DATA/rgbd
    label_map desk.png 640 480 '((x - 320) / 60) ** 2 + ((y - 260) / 80) ** 2 < 1'
    run desk_create create --color "$photos/png16_tum_fr2_desk/color.png" --depth "$photos/png16_tum_fr2_desk/depth.png" \
        --depth-unit 0.0002 --hfov 60 --segments desk.png --glossy 1 -o desk.patina
    render desk desk.patina --edit '1={"brdf": "ggx", "alpha": 0.2}'
    layers desk desk.patina normals environment
    label_map vase.png 756 1008 '((x - 400) / 130) ** 2 + ((y - 520) / 200) ** 2 < 1'
    run vase_create create --color "$photos/jpeg_mpf_iphonex_vase/image-with-depth.jpg" --segments vase.png --glossy 1 \
        -o vase.patina
    render vase vase.patina --edit '1={"brdf": "ggx", "alpha": 0.2}'
fi

sha256sum ./*.exr | sort -k2 | tee hashes.txt
[[ $failed -eq 0 ]] || exit 1
[[ -z $expected ]] || { diff "$expected" hashes.txt && echo "All $(wc -l <hashes.txt) pictures are the same."; }
