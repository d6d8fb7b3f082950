# SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
# SPDX-License-Identifier: Apache-2.0
"""The package clustervo, in a folder with the scene `tiny` and its results `run`.

Usage: package_test.py README.md
"""

import csv
import json
import re
import shutil
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

import clustervo
import numpy as np

README = Path(sys.argv.pop())


def blocks(text):
    """The Python blocks of a page, each on the lines where the page has it."""
    for match in re.finditer(r"^```python\n(.*?)^```$", text, re.MULTILINE | re.DOTALL):
        yield "\n" * text.count("\n", 0, match.start(1)) + match.group(1)


class Suite(unittest.TestCase):
    def test_is_a_table_of_its_runs(self):
        jobs = [{"job": job, "sequence": "tiny", "detections": "good", "variant": "full",
                 "system": "", "seed": seed, "oracle": [], "parameters": {"unary.eta": eta}}
                for job, seed, eta in (("a", 1, 0.5), ("b", 2, 0.9), ("", 3, 0.9))]
        with tempfile.TemporaryDirectory() as folder:
            Path(folder, "plan.json").write_text(json.dumps({"jobs": jobs}))
            Path(folder, "jobs", "a").mkdir(parents=True)
            shutil.copy("run/result.json", Path(folder, "jobs", "a"))
            table = clustervo.load_suite(folder)
        run = clustervo.load("run")
        self.assertEqual(table["job"].tolist(), ["a"])  # the others have not run
        self.assertEqual(table["unary.eta"][0], 0.5)
        for name, value in run.metrics.items():
            self.assertEqual(table[name][0], value)


class Page(unittest.TestCase):
    """What the page shows, run as it stands."""

    @classmethod
    def setUpClass(cls):
        cls.names = {}
        for block in blocks(README.read_text(encoding="utf-8")):
            exec(compile(block, str(README), "exec"), cls.names)

    def test_finds_what_the_program_found(self):
        odometry, run = self.names["odometry"], self.names["run"]
        self.assertEqual(len(odometry.clusters()), 3)
        for cluster in odometry.clusters():
            rows = run.objects[run.objects["id"] == cluster.id]
            for name in ("x", "y", "z", "qx", "qy", "qz", "qw", "vx", "vy", "vz"):
                found = cluster.poses[np.isin(cluster.poses["frame"], rows["frame"])]
                np.testing.assert_array_equal(found[name], rows["refined_" + name])

    def test_a_frame_holds_bodies_and_landmarks(self):
        frame, run = self.names["frame"], self.names["run"]
        rows = run.objects[run.objects["frame"] == 5]
        self.assertEqual([body.id for body in frame.clusters], rows["id"].tolist())
        self.assertEqual([body.status for body in frame.clusters], rows["status"].tolist())
        self.assertEqual([body.detection for body in frame.clusters], rows["detection"].tolist())
        body = frame.clusters[0]
        np.testing.assert_array_equal(body.velocity_m_s, [rows[0][v] for v in ("vx", "vy", "vz")])
        np.testing.assert_allclose(body.world_from_object, clustervo.matrices(rows)[0], atol=1e-12)
        np.testing.assert_array_equal(body.box_size_m,
                                      [rows[0][s] for s in ("length_m", "height_m", "width_m")])
        np.testing.assert_allclose(body.object_from_box, clustervo.matrices(rows, "box_")[0],
                                   atol=1e-12)
        landmarks = run.landmarks[run.landmarks["frame"] == 5]
        for name in ("id", "cluster"):
            np.testing.assert_array_equal(frame.landmarks[name], landmarks[name])
        for name, decimals in (("u_px", 2), ("u_right_px", 2), ("x", 3), ("z", 3)):
            error = np.abs(frame.landmarks[name] - landmarks[name])
            self.assertLess(error.max(), 0.6 * 10**-decimals)


class Readers(unittest.TestCase):
    def test_columns_are_those_of_the_file(self):
        objects = clustervo.load("run").objects
        with open("run/objects.csv", encoding="utf-8") as file:
            rows = list(csv.DictReader(file))
        self.assertEqual(list(objects.dtype.names), list(rows[0]))
        self.assertEqual(len(objects), len(rows))
        self.assertEqual(objects["category"].tolist(), [row["category"] for row in rows])
        # Empty before a cluster was confirmed.
        expected = [float(row["z"] or "nan") for row in rows]
        np.testing.assert_array_equal(objects["z"], expected)
        self.assertTrue(np.isnan(expected).any())
        self.assertEqual(objects["timestamp_ns"].dtype, np.int64)

    def test_times_are_exact(self):
        run = clustervo.load("run")
        times = [frame["timestamp_ns"] for frame in run.result["frames"]]
        self.assertEqual(run.camera["timestamp_ns"].tolist(), times)

    def test_a_folder_without_a_run_is_an_error(self):
        with self.assertRaises(FileNotFoundError):
            clustervo.load("tiny")

    def test_another_schema_version_is_an_error(self):
        with tempfile.TemporaryDirectory() as folder:
            (Path(folder) / "result.json").write_text('{"schema_version": 99, "kind": "run"}')
            with self.assertRaisesRegex(ValueError, "found schema_version 99, expected"):
                clustervo.load(folder)


class BadInput(unittest.TestCase):
    def setUp(self):
        self.camera = clustervo.Camera(fx=450, fy=450, cx=80, cy=60, baseline_m=0.1, width_px=160,
                                       height_px=120)
        self.image = np.zeros((120, 160), np.uint8)

    def assert_error(self, pattern, call, *arguments, **options):
        with self.assertRaisesRegex(clustervo.Error, pattern):
            call(*arguments, **options)

    def test_is_named(self):
        make = clustervo.StereoOdometry
        self.assert_error('variant: found "fast"', make, self.camera, variant="fast")
        self.assert_error('options: found "orb.corners"', make, self.camera,
                          options={"orb.corners": 1})
        self.assert_error("option orb.features: found 'many'", make, self.camera,
                          options={"orb.features": "many"})
        self.assert_error("option orb.features: found -1", make, self.camera,
                          options={"orb.features": -1})
        odometry = make(self.camera)
        colour = np.zeros((120, 160, 3), np.uint8)
        self.assert_error("left image: found 3 dimensions", odometry.process, colour, colour, 0)
        self.assert_error("left image: found float64, expected uint8", odometry.process,
                          self.image.astype(float), self.image, 0)

    def test_times_must_increase(self):
        odometry = clustervo.StereoOdometry(self.camera, variant="static")
        self.assertEqual(odometry.process(self.image, self.image, 5).status, "lost")
        self.assertEqual(odometry.skip(6).status, "skipped")
        self.assert_error("timestamps must increase", odometry.skip, 6)


class Missing(unittest.TestCase):
    def test_names_the_packages(self):
        with tempfile.TemporaryDirectory() as folder:
            package = Path(folder) / "clustervo"
            package.mkdir()
            for name in ("__init__.py", "results.py"):
                shutil.copy(Path(clustervo.__file__).with_name(name), package)
            run = subprocess.run([sys.executable, "-c", "import clustervo"], cwd=folder,
                                 env={"PYTHONPATH": folder}, capture_output=True, text=True)
        self.assertNotEqual(run.returncode, 0)
        self.assertIn("python3-dev pybind11-dev python3-numpy", run.stderr)


if __name__ == "__main__":
    unittest.main()
