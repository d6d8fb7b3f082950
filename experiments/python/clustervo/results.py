# SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
# SPDX-License-Identifier: Apache-2.0
"""What `clustervo run` wrote, as NumPy arrays with named columns."""

import csv
import json
from dataclasses import dataclass
from decimal import Decimal
from pathlib import Path
from typing import Optional

import numpy as np

_SCHEMA_VERSION = 3  # of result.json
# Columns by type; all others are numbers. An empty field is "", -1 or NaN.
_TEXT = {"category", "status", "refined_status"}
_INTEGER = {
    "frame", "timestamp_ns", "id", "observed_landmarks", "detection", "cluster", "inferred",
    "confidence", "truth_body",
}
_POSE = ("x", "y", "z", "qx", "qy", "qz", "qw")


@dataclass(frozen=True)
class Run:
    """One run. Lengths in m, pixels in px, times in ns; world = left camera of the first frame."""

    camera: np.ndarray  # camera.tum: timestamp_ns, x, y, z, qx, qy, qz, qw
    objects: np.ndarray  # objects.csv: a row per frame and cluster
    landmarks: Optional[np.ndarray]  # landmarks.csv; None where it was not written
    metrics: dict  # value by name; what each means is in result["metrics"]
    result: dict  # all of result.json


def load(folder):
    """Reads the folder of a run; only landmarks.csv may be missing.

    Raises ValueError for a result.json of a schema version that is not read, and warns of one that
    is not the present one.
    """
    folder = Path(folder)
    result = _read_result(folder / "result.json")
    landmarks = folder / "landmarks.csv"
    return Run(
        camera=_read_tum(folder / "camera.tum"),
        objects=_read_csv(folder / "objects.csv"),
        landmarks=_read_csv(landmarks) if landmarks.exists() else None,
        metrics={metric["name"]: metric["value"] for metric in result["metrics"]},
        result=result,
    )


def load_suite(folder):
    """Reads the folder of a suite as a table: a row per run that has a result.

    Columns: job (its files are in jobs/<job>, which `load` reads), sequence, detections, variant
    (or system), seed, oracle, the paths that the suite varies, and a column per metric, NaN where
    a run lacks it.
    """
    folder = Path(folder)
    plan = json.loads((folder / "plan.json").read_text(encoding="utf-8"))
    rows = []
    for job in plan["jobs"]:
        result = folder / "jobs" / job["job"] / "result.json"
        if not job["job"] or not result.exists():
            continue
        row = {name: job[name] for name in ("job", "sequence", "detections", "seed")}
        row["variant"] = job["variant"] or job["system"]
        row["oracle"] = "+".join(job["oracle"])
        values = {path: value if isinstance(value, (int, float)) else json.dumps(value)
                  for path, value in job["parameters"].items()}
        metrics = {metric["name"]: metric["value"] for metric in _read_result(result)["metrics"]}
        rows.append({**row, **values, **metrics})
    names = list(dict.fromkeys(name for row in rows for name in row))
    columns = [np.array([row.get(name, np.nan) for row in rows]) for name in names]
    table = np.empty(len(rows), [(name, column.dtype) for name, column in zip(names, columns)])
    for name, column in zip(names, columns):
        table[name] = column
    return table


def matrices(rows, prefix=""):
    """Poses of rows with columns x ... qw as N x 4 x 4; prefix "refined_" takes those columns."""
    x, y, z, qx, qy, qz, qw = (rows[prefix + name] for name in _POSE)
    poses = np.zeros((len(rows), 4, 4))
    poses[:, 0, :] = np.stack(
        [1 - 2 * (qy * qy + qz * qz), 2 * (qx * qy - qz * qw), 2 * (qx * qz + qy * qw), x], -1)
    poses[:, 1, :] = np.stack(
        [2 * (qx * qy + qz * qw), 1 - 2 * (qx * qx + qz * qz), 2 * (qy * qz - qx * qw), y], -1)
    poses[:, 2, :] = np.stack(
        [2 * (qx * qz - qy * qw), 2 * (qy * qz + qx * qw), 1 - 2 * (qx * qx + qy * qy), z], -1)
    poses[:, 3, 3] = 1
    return poses


def _read_result(path):
    result = json.loads(path.read_text(encoding="utf-8"))
    for field, expected in (("kind", "run"), ("schema_version", _SCHEMA_VERSION)):
        if result.get(field) != expected:
            raise ValueError(
                f"{path}: found {field} {result.get(field)!r}, expected {expected!r}")
    return result


def _read_tum(path):
    rows = [line.split() for line in path.read_text().splitlines() if not line.startswith("#")]
    table = np.zeros(len(rows), [("timestamp_ns", np.int64)] + [(name, float) for name in _POSE])
    table["timestamp_ns"] = [int(Decimal(row[0]) * 10**9) for row in rows]
    for column, name in enumerate(_POSE, start=1):
        table[name] = [float(row[column]) for row in rows]
    return table


def _read_csv(path):
    with open(path, newline="", encoding="utf-8") as file:
        reader = csv.reader(file)
        names = next(reader)
        columns = list(zip(*reader)) or [()] * len(names)
    arrays = [_column(name, values) for name, values in zip(names, columns)]
    table = np.empty(len(columns[0]), [(name, a.dtype) for name, a in zip(names, arrays)])
    for name, array in zip(names, arrays):
        table[name] = array
    return table


def _column(name, values):
    if name in _TEXT:
        return np.array(values, dtype=str)
    if name in _INTEGER:
        return np.array([int(value) if value else -1 for value in values], dtype=np.int64)
    return np.array([float(value) if value else np.nan for value in values], dtype=float)
