#!/usr/bin/python3
# SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
# SPDX-License-Identifier: Apache-2.0
"""VDO-SLAM on two folders of images: see vdo_slam.md. Runs in an empty folder, {out}."""
import os
import shutil
import subprocess
import sys

import cv2
import numpy as np

SETTINGS = {"ChooseData": 2, "DepthMapFactor": 256.0, "ThDepthBG": 40.0, "ThDepthOBJ": 25.0,
            "MaxTrackPointBG": 1200, "MaxTrackPointOBJ": 800, "SFDsThres": 0.3,
            "WINDOW_SIZE": 20, "OVERLAP_SIZE": 4, "UseSampleFeature": 0}


def mask_of(boxes, disparity):
    """Labels of the pixels of boxes that are as near as their middles; near ones hide far ones."""
    mask, found = np.zeros(disparity.shape, int), []
    for label, (left, top, right, bottom) in boxes:
        x, y = (right - left) / 4, (bottom - top) / 4
        middle = disparity[int(top + y):int(bottom - y) + 1, int(left + x):int(right - x) + 1]
        if (middle > 0).any():
            part = np.s_[max(int(top), 0):int(bottom) + 1, max(int(left), 0):int(right) + 1]
            found.append((np.median(middle[middle > 0]), label, part))
    for near, label, part in sorted(found, key=lambda one: one[:2]):
        mask[part][abs(disparity[part] - near) < 0.15 * near] = label
    return mask


def images_in(folder):
    """Reads the images one by one, and the last one twice: upstream leaves out a last frame."""
    names = sorted(os.listdir(folder))
    for name in names + names[-1:]:
        yield cv2.imread(os.path.join(folder, name), 0)


def write_images(left, right, boxes):
    """Writes disparity, masks and flow, each flow when the frame that it leads to is read."""
    sgbm = cv2.StereoSGBM_create(0, 128, 5, 200, 800, 1, 0, 10, 100, 2)
    dis = cv2.DISOpticalFlow_create(cv2.DISOPTICAL_FLOW_PRESET_MEDIUM)
    for folder in ("image_0", "depth", "semantic", "flow"):
        os.makedirs(os.path.join("input", folder))
    for k, (image, other) in enumerate(zip(left, right)):
        disparity = np.maximum(sgbm.compute(image, other) / 16.0, 0)
        labels = range(1 + k % 5 * 40, 41 + k % 5 * 40)  # not those of the frame before
        mask = mask_of(zip(labels, boxes[boxes[:, 0] == k, 1:]), disparity)
        cv2.imwrite(f"input/image_0/{k:06}.png", image)
        cv2.imwrite(f"input/depth/{k:06}.png", (256 * disparity).astype(np.uint16))
        np.savetxt(f"input/semantic/{k:06}.txt", mask, fmt="%d")
        if k > 0:
            cv2.writeOpticalFlow(f"input/flow/{k - 1:06}.flo", dis.calc(before, image, None))
        before = image


def write_truth(frames):
    """Writes made-up poses, in which saved motions are in the world: without, bodies are skipped."""
    bodies = [[k, i, 0, 0, 0, 0, 0, 0, 0, -np.pi / 2] for k in range(frames) for i in range(1, 201)]
    np.savetxt("input/pose_gt.txt", [[k, *np.eye(4).ravel()] for k in range(frames)], fmt="%d")
    np.savetxt("input/object_pose.txt", bodies, fmt="%.17g")
    np.savetxt("input/times.txt", np.zeros(frames), fmt="%d")  # it draws at other times


def write_results(times):
    np.savetxt("camera.txt", np.loadtxt("refined_stereo_new.txt")[:, 1:13])
    os.makedirs("objects")
    bodies = {}
    for motion, centre in zip(*(np.loadtxt(name, ndmin=2) for name in
                                ("obj_mot_stereo_rf_new.txt", "obj_centre.txt"))):
        frame, body = motion[:2].astype(int)
        start = np.block([[np.eye(3), centre[2:, None]], [0, 0, 0, 1]])
        poses = bodies.setdefault(body, {})
        poses[frame] = motion[2:].reshape(4, 4) @ poses.setdefault(frame - 1, start)
    for body, poses in bodies.items():
        rows = []
        for frame, pose in poses.items():
            turn = cv2.Rodrigues(pose[:3, :3])[0].ravel()
            half = np.linalg.norm(turn) / 2
            turn *= np.sinc(half / np.pi) / 2
            rows.append([times[frame], *pose[:3, 3], *turn, np.cos(half)])
        np.savetxt(f"objects/{body}.tum", rows, fmt="%.15g")


def main():
    program, left, right, times, settings, detections, speed = sys.argv[1:]
    times = np.loadtxt(times)
    boxes = np.loadtxt(detections, usecols=(0, 6, 7, 8, 9), ndmin=2)
    write_images(images_in(left), images_in(right), boxes)
    write_truth(len(times) + 1)
    SETTINGS["SFMgThres"] = float(speed) * (times[-1] - times[0]) / (len(times) - 1)
    with open(settings, encoding="utf-8") as given, open("all.yaml", "w", encoding="utf-8") as out:
        out.write(given.read() + "".join(f"{key}: {value}\n" for key, value in SETTINGS.items()))
    os.environ["QT_QPA_PLATFORM"] = "offscreen"
    subprocess.run([program, "all.yaml", "input"], check=True)
    write_results(times)
    shutil.rmtree("input")


main()
