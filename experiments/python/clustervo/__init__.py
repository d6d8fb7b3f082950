# SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
# SPDX-License-Identifier: Apache-2.0
"""Stereo visual odometry that finds moving rigid bodies, and readers of its results."""

try:
    import numpy
    from . import _clustervo
except ImportError as error:
    raise ImportError(
        f"{error}: clustervo needs Python's headers, pybind11 and NumPy when it is built, and NumPy "
        "when it is used (Debian: python3-dev pybind11-dev python3-numpy), then `make program`"
    ) from error

from ._clustervo import (
    Box,
    Camera,
    Cluster,
    ClusterTrajectory,
    Error,
    Frame,
    StereoOdometry,
    __version__,
    options,
    variants,
)
from .results import Run, load, load_suite, matrices

__all__ = [
    "Box",
    "Camera",
    "Cluster",
    "ClusterTrajectory",
    "Error",
    "Frame",
    "Run",
    "StereoOdometry",
    "load",
    "load_suite",
    "matrices",
    "options",
    "variants",
]
