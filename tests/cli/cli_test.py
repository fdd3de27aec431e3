#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs the real patina-cli: every command, every exit code. Usage: cli_test.py PROGRAM SAMPLES [unittest options]"""
import json
import os
import shutil
import signal
import struct
import subprocess
import sys
import tempfile
import time
import unittest
import zlib

PROGRAM, SAMPLES = sys.argv.pop(1), sys.argv.pop(1)
STUDIO = os.path.join(SAMPLES, "studio", "studio.patina")


def png(path, rows, bits=8, color_type=0):
    """A PNG of rows of integers (grey or interleaved)."""
    packed = b"".join(b"\0" + struct.pack(">%d%s" % (len(r), "H" if bits == 16 else "B"), *r) for r in rows)
    width = len(rows[0]) // (3 if color_type == 2 else 1)

    def chunk(kind, data):
        return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))

    with open(path, "wb") as file:
        file.write(b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", struct.pack(">IIBBBBB", width, len(rows), bits, color_type, 0, 0, 0))
                   + chunk(b"IDAT", zlib.compress(packed)) + chunk(b"IEND", b""))


def png_size(path):
    with open(path, "rb") as file:
        head = file.read(24)
    assert head[:8] == b"\x89PNG\r\n\x1a\n", path
    return struct.unpack(">II", head[16:24])


def pfm(path, width, height, values):
    with open(path, "wb") as file:
        file.write(b"Pf\n%d %d\n-1.0\n" % (width, height) + struct.pack("<%df" % len(values), *values))


class CliTest(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.mkdtemp(prefix="patina-cli-")
        self.addCleanup(shutil.rmtree, self.folder)

    def path(self, name):
        return os.path.join(self.folder, name)

    def run_cli(self, *args, code=0, env=None, stdout=subprocess.PIPE):
        result = subprocess.run([PROGRAM, *args], stdout=stdout, stderr=subprocess.PIPE, text=True, timeout=600,
                                env=dict(os.environ, **(env or {})))
        self.assertEqual(result.returncode, code, "%s\n%s" % (" ".join(args), result.stderr))
        return result

    def fails(self, code, parts, *args, **options):
        """The command fails with this exit code and a message with these parts, and prints nothing on stdout."""
        result = self.run_cli(*args, code=code, **options)
        for part in parts:
            self.assertIn(part, result.stderr)
        if result.stdout is not None:
            self.assertEqual(result.stdout, "")
        return result

    def small_project(self):
        """48x32: a near square of label 1 before a far wall of label 2."""
        width, height = 48, 32
        near = [[16 <= x < 32 and 8 <= y < 24 for x in range(width)] for y in range(height)]
        png(self.path("color.png"), [[v for x in range(width) for v in ((200, 120, 60) if near[y][x] else (90, 110, 130))]
                                     for y in range(height)], color_type=2)
        png(self.path("depth.png"), [[800 if near[y][x] else 1200 for x in range(width)] for y in range(height)], bits=16)
        png(self.path("labels.png"), [[1 if near[y][x] else 2 for x in range(width)] for y in range(height)])
        self.run_cli("create", "--color", self.path("color.png"), "--depth", self.path("depth.png"), "--segments",
                     self.path("labels.png"), "--glossy", "1", "--hfov", "60", "-o", self.path("p.patina"))
        return self.path("p.patina")


class UsageTest(CliTest):
    def test_help_and_version(self):
        text = self.run_cli("--help").stdout
        for command in ("create", "info", "segment", "export", "render", "devices", "bench"):
            self.assertIn(command, text)
            self.assertIn("Usage:", self.run_cli(command, "--help").stdout)
        self.assertRegex(self.run_cli("--version").stdout, r"^patina-cli \d+\.\d+")

    def test_wrong_usage(self):
        self.run_cli(code=2)
        self.run_cli("paint", code=2)
        self.run_cli("info", code=2)
        self.run_cli("info", STUDIO, "--jsno", code=2)
        self.run_cli("create", "--color", "a.png", code=2)
        self.run_cli("create", "--color", "a", "--depth-kind", "fuzzy", "-o", "b", code=2)
        self.run_cli("create", "--color", "a", "--hfov", "60", "--intrinsics", "1,1,1,1", "-o", "b", code=2)
        self.fails(2, ["--intrinsics", "1,2,3"], "create", "--color", "a", "--intrinsics", "1,2,3", "-o", "b")

    def test_labels_and_layers_that_do_not_exist(self):
        project = self.small_project()
        self.fails(2, ["\"9\"", "1, 2"], "create", "--color", self.path("color.png"), "--depth", self.path("depth.png"),
                   "--segments", self.path("labels.png"), "--glossy", "9", "-o", self.path("q.patina"))
        self.fails(2, ["nose"], "render", project, "--edit", 'nose={"brdf":"ggx"}', "-o", self.path("o.png"))
        self.fails(2, ["77"], "render", project, "--reflectance", "77=1,1,1", "-o", self.path("o.png"))
        self.fails(2, ["beauty", "normals"], "export", project, "--layer", "beauty", "-o", self.path("o.png"))
        self.fails(2, ["77"], "export", project, "--layer", "reflected:77", "-o", self.path("o.png"))
        self.fails(2, ["sleep", "march"], "bench", "sleep", "--project", project)
        self.fails(2, ["not glossy"], "export", project, "--layer", "incident:2", "-o", self.path("o.png"))

    def test_names_with_equals_signs_and_digits(self):
        project = self.small_project()
        with open(project, encoding="utf-8") as file:
            document = json.load(file)
        first, second = document["segments"][:2]
        first["name"], second["name"] = "cup=red", str(first["label"])
        with open(project, "w", encoding="utf-8") as file:
            json.dump(document, file)
        self.fails(2, ["ambiguous", "cup=red"], "render", project, "--edit", '%d={"brdf":"lambert"}' % first["label"], "-o",
                   self.path("o.png"))
        self.fails(2, ["ambiguous"], "render", project, "--reflectance", "%d=1,0.5,0.5" % first["label"], "-o",
                   self.path("o.png"))
        for arguments in (("--edit", 'cup=red={"brdf": "lambert", "albedo": [0, 1, 0]}'), ("--reflectance", "cup=red=1,0.5,0.5")):
            self.run_cli("render", project, "--samples", "1", *arguments, "-o", self.path("o.png"))

    def test_edits_that_are_wrong(self):
        project = self.small_project()
        for edit, parts in (('1', ["LABEL=VALUE"]), ('1={"brdf":', ["JSON", "damaged"]),
                            ('1={"brdf":"ggx","alpha":5}', ["alpha", "is 5", "[0.01, 1]"]),
                            ('1={"brdf":"ggx","shiny":1}', ["shiny", "unknown"]),
                            ('1={"brdf":"velvet"}', ["velvet", "phong"])):
            self.fails(2, parts, "render", project, "--edit", edit, "-o", self.path("o.png"))
        self.fails(2, ["-1"], "render", project, "--reflectance", "1=-1,1,1", "-o", self.path("o.png"))
        self.run_cli("render", project, "--samples", "0", "-o", self.path("o.png"), code=2)
        self.fails(2, [".bmp", ".exr"], "render", project, "-o", self.path("o.bmp"))

    def test_masks_that_do_not_fit(self):
        project = self.small_project()
        png(self.path("small.png"), [[0, 255]])
        png(self.path("mask.png"), [[255 if x < 24 else 0 for x in range(48)] for _ in range(32)])
        edit = '1={"brdf":"ggx","drives":[{"parameter":"alpha","mask":"%s","from":0.1,"to":0.5}]}'
        self.fails(3, ["small.png", "alpha", "2x1", "48x32"], "render", project, "--edit", edit % self.path("small.png"),
                   "-o", self.path("o.png"))
        self.fails(3, ["none.png", "does not exist"], "render", project, "--edit", edit % self.path("none.png"), "-o",
                   self.path("o.png"))
        self.fails(2, ["is an input"], "render", project, "--edit", edit % self.path("mask.png"), "-o",
                   self.path("mask.png"))

    def test_parameter_layers_show_the_drives(self):
        project = self.small_project()
        png(self.path("mask.png"), [[255 if x < 24 else 0 for x in range(48)] for _ in range(32)])
        with open(project) as file:
            document = json.load(file)
        document["segments"][0]["edit"] = {"brdf": "ggx", "drives": [
            {"parameter": "alpha", "mask": "mask.png", "from": 0.1, "to": 0.5}]}
        with open(project, "w") as file:
            json.dump(document, file)
        self.run_cli("export", project, "--layer", "parameter:1:alpha", "-o", self.path("alpha.png"))
        self.assertEqual(png_size(self.path("alpha.png")), (48, 32))
        self.fails(2, ["sheen", "alpha"], "export", project, "--layer", "parameter:1:sheen", "-o", self.path("o.png"))
        self.fails(2, ["not edited"], "export", project, "--layer", "parameter:2:alpha", "-o", self.path("o.png"))
        self.fails(2, ["parameter:LABEL:NAME"], "export", project, "--layer", "parameter:1", "-o", self.path("o.png"))

    def test_inputs_are_never_overwritten(self):
        project = self.small_project()
        with open(self.path("color.png"), "rb") as file:
            before = file.read()
        os.symlink(self.path("color.png"), self.path("link.png"))
        for name in ("color.png", "link.png", "labels.png"):
            self.fails(2, ["is an input"], "render", project, "-o", self.path(name))
            self.fails(2, ["is an input"], "export", project, "--layer", "color", "-o", self.path(name))
        with open(self.path("color.png"), "rb") as file:
            self.assertEqual(file.read(), before)


class SegmentTest(CliTest):
    """Selects the near square of small_project, 16 <= x < 32 and 8 <= y < 24."""

    def grey(self, path):
        """Rows of an 8-bit grey PNG."""
        with open(path, "rb") as file:
            data = file.read()
        width, height, bits, kind = struct.unpack(">IIBB", data[16:26])
        self.assertEqual((bits, kind), (8, 0))
        packed, at = b"", 8
        while at < len(data):
            length, name = struct.unpack(">I4s", data[at:at + 8])
            if name == b"IDAT":
                packed += data[at + 8:at + 8 + length]
            at += 12 + length
        raw, rows, above = zlib.decompress(packed), [], [0] * width
        for y in range(height):
            line = list(raw[y * (width + 1) + 1:(y + 1) * (width + 1)])
            for x in range(width):  # undo the filter of the row
                left, up, corner = (line[x - 1] if x else 0), above[x], (above[x - 1] if x else 0)
                paeth = min((left, up, corner), key=lambda value: abs(left + up - corner - value))
                line[x] = (line[x] + (0, left, up, (left + up) // 2, paeth)[raw[y * (width + 1)]]) & 255
            rows.append(line)
            above = line
        return rows

    def without_segments(self):
        self.small_project()
        self.run_cli("create", "--color", self.path("color.png"), "--depth", self.path("depth.png"), "--hfov", "60", "-o",
                     self.path("s.patina"))
        return self.path("s.patina")

    def square(self, selected, other=0):
        return [[selected if 16 <= x < 32 and 8 <= y < 24 else other for x in range(48)] for y in range(32)]

    def test_one_point_selects_an_object(self):
        project = self.without_segments()
        with open(project) as file:
            before = file.read()
        self.assertEqual(self.run_cli("segment", project, "--add", "24,16", "-o", self.path("m.png")).stdout, "")
        self.assertEqual(self.grey(self.path("m.png")), self.square(255))
        self.run_cli("segment", project, "--add", "2,2", "--add", "24,16", "--remove=24,17", "-o", self.path("m.png"))
        rows = self.grey(self.path("m.png"))
        self.assertEqual((rows[2][2], rows[16][24], rows[17][24]), (255, 255, 0))
        with open(project) as file:
            self.assertEqual(file.read(), before)

    def test_points_count_in_the_order_given(self):
        project, mask = self.without_segments(), self.path("m.png")
        for first, last, value in (("--remove", "--add", 255), ("--add", "--remove", 0)):
            self.run_cli("segment", project, "--add", "20,12", first, "24,16", last, "24,16", "-o", mask)
            self.assertEqual(self.grey(mask)[16][24], value, last)

    def test_into_makes_a_segment_and_keeps_the_edits(self):
        project = self.without_segments()
        self.run_cli("segment", project, "--add", "24,16", "--into", "box", "-o", self.path("m.png"))
        with open(project) as file:
            document = json.load(file)
        self.assertEqual([(s["label"], s["name"]) for s in document["segments"]], [(1, "box")])
        labels = os.path.join(self.folder, document["photo"]["segments"])
        self.assertEqual(self.grey(labels), self.square(1))
        document["segments"][0]["edit"] = {"brdf": "ggx", "alpha": 0.3}
        with open(project, "w") as file:
            json.dump(document, file)
        self.run_cli("segment", project, "--add", "2,2", "--into", "7", "-o", self.path("w.png"))
        with open(project) as file:
            document = json.load(file)
        self.assertEqual([s["label"] for s in document["segments"]], [1, 7])
        self.assertEqual(document["segments"][0]["edit"]["alpha"], 0.3)
        self.assertTrue(os.path.exists(labels), "the label map that was written first")
        self.assertEqual(self.grey(os.path.join(self.folder, document["photo"]["segments"])), self.square(1, 7))
        self.fails(2, ["box", "edited"], "segment", project, "--add", "24,16", "--into", "lid", "-o", self.path("m.png"))

    def test_proposals_are_a_label_map(self):
        project = self.small_project()
        self.run_cli("segment", project, "--propose", "-o", self.path("all.png"))
        self.assertEqual(self.grey(self.path("all.png")), self.square(1))

    def test_what_is_refused(self):
        project = self.without_segments()
        out = ["-o", self.path("m.png")]
        self.fails(2, ["--add"], "segment", project, *out)
        self.fails(2, ["--propose"], "segment", project, "--propose", "--add", "1,1", *out)
        for point in ("48,3", "3,32", "-1,3", "1e30,3"):
            self.fails(2, ["outside", "48x32"], "segment", project, "--add=" + point, *out)
        self.fails(2, ["--add", "later --remove"], "segment", project, "--add", "24,16", "--remove", "24.5,16.5", *out)
        self.fails(2, ["--add", "2 numbers"], "segment", project, "--add", "24", *out)
        self.fails(2, ["65536"], "segment", project, "--add", "24,16", "--into", "65536", *out)
        self.assertFalse(os.path.exists(self.path("m.png")))
        self.fails(2, ["is an input"], "segment", project, "--add", "24,16", "-o", self.path("color.png"))
        self.fails(2, ["is an input"], "segment", project, "--add", "24,16", "-o", project)
        self.fails(5, ["no/such"], "segment", project, "--add", "24,16", "-o", self.path("no/such/m.png"))
        self.fails(3, ["none.patina"], "segment", self.path("none.patina"), "--add", "1,1", *out)


class InputTest(CliTest):
    def test_unusable_inputs(self):
        project = self.small_project()
        create = ["create", "--depth", self.path("depth.png"), "-o", self.path("q.patina"), "--color"]
        self.fails(3, ["none.png", "does not exist"], *create, self.path("none.png"))
        self.fails(3, ["none.patina", "does not exist"], "info", self.path("none.patina"))
        png(self.path("small.png"), [[1] * 10] * 10, bits=16)
        self.fails(3, ["Depth image size (10x10) differs in shape from colour image size (48x32)"], "create", "--color",
                   self.path("color.png"), "--depth", self.path("small.png"), "-o", self.path("q.patina"))
        exr = os.path.join(SAMPLES, "studio", "color.exr")
        with open(exr, "rb") as file:
            whole = file.read()
        with open(self.path("cut.exr"), "wb") as file:
            file.write(whole[:len(whole) // 2])
        self.fails(3, ["cut.exr"], *create, self.path("cut.exr"))
        pfm(self.path("nan.pfm"), 48, 32, [float("nan")] * (48 * 32))
        self.fails(3, ["nan.pfm", "no valid pixel"], "create", "--color", self.path("color.png"), "--depth",
                   self.path("nan.pfm"), "-o", self.path("q.patina"))
        with open(project) as file:
            document = json.load(file)
        for change, parts in (({"colour": 1}, ["colour", "unknown"]), ({"version": 99}, ["version 99"])):
            with open(self.path("bad.patina"), "w") as file:
                json.dump({**document, **change}, file)
            self.fails(3, ["bad.patina", *parts], "info", self.path("bad.patina"))
        self.fails(3, ["none.exr"], "render", project, "--environment", self.path("none.exr"), "-o", self.path("o.png"))
        self.fails(3, ["labels.png", "twice as wide"], "render", project, "--environment", self.path("labels.png"), "-o",
                   self.path("o.png"))
        self.fails(3, ["small.png", "Back depth"], "render", project, "--back-depth", self.path("small.png"), "-o",
                   self.path("o.png"))
        self.assertFalse(os.path.exists(self.path("q.patina")))

    def test_targets_that_cannot_be_written(self):
        project = self.small_project()
        missing = self.path("no/such/o.png")
        self.fails(5, [missing, "does not exist"], "render", project, "-o", missing)
        self.fails(5, [missing], "export", project, "--layer", "color", "-o", missing)
        os.mkdir(self.path("dir.png"))
        self.fails(5, ["is a folder"], "render", project, "-o", self.path("dir.png"))
        self.fails(5, ["/proc/o.png"], "export", project, "--layer", "color", "-o", "/proc/o.png")
        self.fails(5, ["no/such"], "create", "--color", self.path("color.png"), "--depth", self.path("depth.png"), "-o",
                   self.path("no/such/p.patina"))
        with open("/dev/full", "w") as full:
            self.fails(5, ["standard output"], "info", project, "--json", stdout=full)

    def test_no_device(self):
        project = self.small_project()
        self.fails(4, ["no such device"], "render", project, "--device", "no such device", "-o", self.path("o.png"))
        self.fails(4, ["no such device"], "--device", "no such device", "render", project, "-o", self.path("o.png"))
        self.fails(4, ["patina-cli:"], "render", project, "-o", self.path("o.png"),
                   env={"VK_ICD_FILENAMES": self.path("none.json"), "VK_DRIVER_FILES": self.path("none.json"),
                        "PATINA_VALIDATION": "0"})
        self.assertFalse(os.path.exists(self.path("o.png")))


class WorkTest(CliTest):
    def test_photograph_that_carries_its_depth(self):
        width, height, focal = 24, 16, 30
        with open(self.path("cloud.pcd"), "w") as file:
            file.write("VERSION 0.7\nFIELDS x y z rgba\nSIZE 4 4 4 4\nTYPE F F F U\nCOUNT 1 1 1 1\nWIDTH %d\nHEIGHT %d\n"
                       "DATA ascii\n" % (width, height))
            for y in range(height):
                for x in range(width):
                    z = 2 + 0.01 * x
                    file.write("%.9g %.9g %.9g %d\n" % ((x + 0.5 - 12) / focal * z, (y + 0.5 - 8) / focal * z, z, 0x8090A0))
        result = self.run_cli("create", "--color", self.path("cloud.pcd"), "-o", self.path("c.patina"))
        self.assertIn("intrinsics are taken from", result.stderr)
        info = json.loads(self.run_cli("info", self.path("c.patina"), "--json").stdout)
        self.assertIn("PCD", info["depth"]["inside"])
        self.assertEqual((info["width"], info["height"]), (width, height))
        self.assertAlmostEqual(info["intrinsics"]["fx"], focal, places=3)
        self.assertAlmostEqual(info["depth"]["max"], 2.23, places=5)
        self.assertIn("PCD", self.run_cli("info", self.path("c.patina")).stdout)
        self.assertIn("HEIC", self.run_cli("create", "--help").stdout)

    def test_brdfs_keep_to_their_rules(self):
        """Those of the list, an example of those by the user; and one that does not."""
        velvet = os.path.join(os.path.dirname(SAMPLES.rstrip("/")), "brdf", "velvet.brdf.glsl")
        names = ["ggx", "ward", velvet]
        document = json.loads(self.run_cli("brdf", "check", "--json", *names).stdout)
        self.assertEqual([entry["brdf"] for entry in document["brdfs"]], names)
        for case in (case for entry in document["brdfs"] for case in entry["cases"]):
            self.assertEqual(case["problem"], "")
            self.assertLessEqual(case["chi_square_deviation"], 6)
            self.assertLessEqual(case["density"], 1.01)
            self.assertLessEqual(case["albedo"], 1.01)
            self.assertLessEqual(case["asymmetry"], 1e-4)
        self.fails(2, ["no BRDF \"granite\"", "lambert"], "brdf", "check", "granite")
        self.assertIn("chi", self.run_cli("brdf", "check", "--help").stdout)
        with open(velvet) as file:
            text = file.read()
        bad = self.path("bright.brdf.glsl")
        with open(bad, "w") as file:
            file.write(text.replace("return albedo * kInvPi", "return 2.0 * albedo * kInvPi"))
        result = self.run_cli("brdf", "check", bad, code=3)
        self.assertIn("FAILS", result.stdout)
        self.assertRegex(result.stderr, r"bright\.brdf\.glsl:\d+: It reflects")
        project = self.small_project()
        self.fails(3, ["bright.brdf.glsl:", "It reflects", "1"], "render", project, "--edit",
                   '1={"brdf": "file:%s"}' % bad, "-o", self.path("o.png"))
        self.run_cli("render", project, "--edit", '1={"brdf": "file:%s", "sheen": 0.9}' % velvet, "--samples", "1",
                     "-o", self.path("o.png"))

    def test_create_and_info(self):
        project = self.small_project()
        result = self.run_cli("info", project, "--json")
        info = json.loads(result.stdout)
        self.assertEqual((info["width"], info["height"]), (48, 32))
        self.assertAlmostEqual(info["hfov_degrees"], 60, places=3)
        self.assertEqual(info["depth"]["valid_fraction"], 1)
        self.assertAlmostEqual(info["depth"]["min"], 0.8, places=6)
        self.assertEqual([(s["label"], s["glossy"], s["pixels"]) for s in info["segments"]],
                         [(1, True, 256), (2, False, 48 * 32 - 256)])
        self.assertNotIn("back_side", result.stdout)
        self.assertIn("48x32", self.run_cli("info", project).stdout)
        assumed = self.run_cli("create", "--color", self.path("color.png"), "--depth", self.path("depth.png"), "-o",
                               self.path("q.patina"))
        self.assertIn("60 degrees", assumed.stderr)
        self.assertEqual(assumed.stdout, "")

    def test_a_photograph_without_depth(self):
        """It can be segmented; every command works or says what it lacks, and an edit changes nothing."""
        self.small_project()
        project = self.path("flat.patina")
        result = self.run_cli("create", "--color", self.path("color.png"), "--segments", self.path("labels.png"),
                              "--glossy", "1", "-o", project)
        self.assertIn("contains no depth map", result.stderr)
        self.assertIn("materials cannot be changed", result.stderr)
        info = json.loads(self.run_cli("info", project, "--json", "--back-sides").stdout)
        self.assertEqual(info["depth"]["valid_fraction"], 0)
        self.assertNotIn("median", info["depth"])
        self.assertIn("depth        none", self.run_cli("info", project).stdout)
        self.run_cli("segment", project, "--add", "20,12", "-o", self.path("mask.png"))
        self.run_cli("segment", project, "--propose", "-o", self.path("proposals.png"))
        plain = self.run_cli("render", project, "--samples", "1", "-o", self.path("plain.png"))
        edit = '1={"brdf": "lambert", "albedo": [0, 1, 0]}'
        edited = self.run_cli("render", project, "--samples", "1", "--edit", edit, "-o", self.path("edited.png"))
        for each in (plain, edited):
            self.assertIn("has no pixel with depth, so it cannot be edited", each.stderr)
        with open(self.path("plain.png"), "rb") as a, open(self.path("edited.png"), "rb") as b:
            self.assertEqual(a.read(), b.read())
        for layer in ("depth", "normals", "environment", "back-depth"):
            self.run_cli("export", project, "--layer", layer, "-o", self.path("layer.exr"))

    def test_info_says_how_back_sides_were_made(self):
        project = self.small_project()
        info = json.loads(self.run_cli("info", project, "--json", "--back-sides").stdout)
        near, wall = (segment["back_side"] for segment in info["segments"])
        self.assertIn(near["method"], ("offset", "parallel_mirror", "pca_mirror", "spanned_mirror", "flat_faces"))
        self.assertTrue(0 <= near["penalty"] <= 1)
        self.assertGreaterEqual(near["thickness"], 0.0019)
        self.assertEqual((wall["method"], wall["penalty"]), ("offset", 0))
        self.assertAlmostEqual(wall["thickness"], 0.05, places=5)
        self.assertIn("table or a wall", wall["note"])
        self.assertIn("back: offset", self.run_cli("info", project, "--back-sides").stdout)

    def test_export_every_layer(self):
        project = self.small_project()
        for layer in ("color", "depth", "normals", "segments", "back-depth", "back-normals"):
            output = self.path("out_" + layer + ".png")
            self.assertEqual(self.run_cli("export", project, "--layer", layer, "-o", output).stdout, "")
            self.assertEqual(png_size(output), (48, 32), layer)
        for layer in ("positions", "area"):
            self.run_cli("export", project, "--layer", layer, "-o", self.path(layer + ".exr"))
            self.fails(2, [".exr or .tif"], "export", project, "--layer", layer, "-o", self.path(layer + ".png"))
        for layer in ("reflected:1", "incident:segment 1", "environment", "coverage"):
            output = self.path("map.png")
            self.run_cli("export", project, "--layer", layer, "-o", output)
            width, height = png_size(output)
            self.assertEqual(width, 2 * height, layer)
        self.run_cli("export", project, "--layer", "cryptomatte", "-o", self.path("c.exr"))
        with open(self.path("c.exr"), "rb") as file:
            content = file.read()
        for text in (b"CryptoObject00.r", b"MurmurHash3_32", b"segment 1"):
            self.assertIn(text, content)
        self.fails(2, [".exr"], "export", project, "--layer", "cryptomatte", "-o", self.path("c.png"))

    def test_render_is_repeatable_and_the_edit_shows(self):
        project = self.small_project()

        def picture(name, *args):
            self.assertEqual(self.run_cli("render", project, "--samples", "4", *args, "-o", self.path(name)).stdout, "")
            with open(self.path(name), "rb") as file:
                return file.read()

        edit = ("--edit", '1={"brdf": "lambert", "albedo": [0.9, 0.1, 0.1]}')
        first = picture("a.exr", *edit)
        self.assertEqual(first, picture("b.exr", *edit))
        self.assertNotEqual(first, picture("c.exr"))
        self.assertNotEqual(first, picture("d.exr", *edit, "--seed", "2"))
        self.assertNotEqual(first, picture("e.exr", *edit, "--reflectance", "1=0.5,0.5,0.5", "--bounces", "1"))
        self.assertEqual(png_size_of(picture, edit, self.path("f.png")), (48, 32))

    def test_a_time_limit_says_how_far_it_came(self):
        project = self.small_project()
        out = self.path("limited.exr")
        result = self.run_cli("render", project, "--edit", '1={"brdf": "ggx", "alpha": 0.5}', "--samples", "1000000",
                              "--time-limit", "0.5", "-o", out)
        self.assertRegex(result.stderr, r"time limit ended rendering after [1-9]\d* of 1000000 samples")
        self.assertTrue(os.path.exists(out))
        self.run_cli("render", project, "--time-limit", "-1", "-o", out, code=2)

    def test_devices(self):
        listed = json.loads(self.run_cli("devices", "--json").stdout)["devices"]
        self.assertGreaterEqual(len(listed), 1)
        self.assertEqual(listed[0]["index"], 0)
        self.assertIn(listed[0]["name"], self.run_cli("devices").stdout)

    def test_bench(self):
        project = self.small_project()
        document = json.loads(self.run_cli("bench", "march", "--json", "--project", project).stdout)
        self.assertGreaterEqual(document["threads"], 1)
        self.assertTrue(document["device"])
        metrics = {(r["name"], r["metric"]): r for r in document["results"]}
        self.assertGreater(metrics["march", "rays_per_second.pyramid"]["value"], 0)
        self.assertEqual(metrics["march", "rays_per_second.pyramid"]["unit"], "1/s")
        self.assertEqual({name for name, _ in metrics}, {"march"})

    def test_analysis_on_the_device_and_on_the_cpu(self):
        project = self.small_project()
        pictures = {}
        for who in ("auto", "cpu", "gpu"):
            pictures[who] = self.path(who + ".exr")
            self.run_cli("export", project, "--layer", "normals", "-o", pictures[who], "--analysis", who)
            self.run_cli("export", project, "--layer", "environment", "-o", self.path("e.exr"),
                         env={"PATINA_ANALYSIS": who})
        with open(pictures["auto"], "rb") as auto, open(pictures["cpu"], "rb") as cpu:
            self.assertEqual(auto.read(), cpu.read())  # the tests' device is a software one
        export = ["export", project, "--layer", "normals", "-o", self.path("n.exr")]
        self.fails(2, ["--analysis", "fast", "auto, cpu or gpu"], *export, "--analysis", "fast")
        self.fails(2, ["PATINA_ANALYSIS", "fast"], *export, env={"PATINA_ANALYSIS": "fast"})
        self.fails(4, ["no such device"], *export, "--analysis", "gpu", "--device", "no such device")
        document = json.loads(self.run_cli("bench", "analyse", "--json", "--project", project).stdout)
        seconds = {r["metric"]: r["value"] for r in document["results"]}
        for stage in ("filter", "geometry", "backside", "reflectance", "environment", "total"):
            self.assertEqual(seconds["seconds." + stage], seconds["cpu_seconds." + stage])
            self.assertGreaterEqual(seconds["gpu_seconds." + stage], 0)
        self.assertGreater(seconds["gpu_seconds.total"], 0)

    def test_interrupt(self):
        process = subprocess.Popen([PROGRAM, "render", STUDIO, "--samples", "100000", "--edit", 'vase={"brdf":"ggx"}',
                                    "-o", self.path("o.png")], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
        first = process.stderr.readline()  # the device is open and the work has begun
        self.assertIn("Rendering on", first)
        time.sleep(1)
        process.send_signal(signal.SIGINT)
        _, messages = process.communicate(timeout=120)
        self.assertEqual(process.returncode, 130, messages)
        self.assertIn("cancelled", messages)
        self.assertEqual(os.listdir(self.folder), [])


def png_size_of(picture, edit, path):
    picture(os.path.basename(path), *edit)
    return png_size(path)


if __name__ == "__main__":
    unittest.main(verbosity=2)
