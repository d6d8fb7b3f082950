# SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
# SPDX-License-Identifier: Apache-2.0
"""Stereo visual odometry that finds moving rigid bodies, and readers of its results."""

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
from .results import Run, load, matrices

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
    "matrices",
    "options",
    "variants",
]
