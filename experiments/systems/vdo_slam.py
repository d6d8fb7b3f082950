#!/usr/bin/python3
# SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
# SPDX-License-Identifier: Apache-2.0
"""VDO-SLAM on two folders of images: see vdo_slam.md. Runs in an empty folder, {out}."""
import os
import subprocess
import sys

import cv2
import numpy as np

SETTINGS = {"ChooseData": 2, "DepthMapFactor": 256.0, "ThDepthBG": 40.0, "ThDepthOBJ": 25.0,
            "MaxTrackPointBG": 1200, "MaxTrackPointOBJ": 800, "SFDsThres": 0.3,
            "WINDOW_SIZE": 20, "OVERLAP_SIZE": 4, "UseSampleFeature": 0}


def read_boxes(path):
    boxes = {}
    with open(path, encoding="utf-8") as rows:
        for row in map(str.split, rows):
            boxes.setdefault(int(row[0]), []).append([float(edge) for edge in row[6:10]])
    return boxes


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
    return [cv2.imread(os.path.join(folder, name), 0) for name in sorted(os.listdir(folder))]


def write_input(left, right, boxes):
    """Writes disparity, masks and flow, with a copy of the last frame, which is not read."""
    sgbm = cv2.StereoSGBM_create(0, 128, 5, 200, 800, 1, 0, 10, 100, 2)
    dis = cv2.DISOpticalFlow_create(cv2.DISOPTICAL_FLOW_PRESET_MEDIUM)
    for folder in ("image_0", "depth", "semantic", "flow"):
        os.makedirs(folder)
    for k in range(len(left) + 1):
        frame = min(k, len(left) - 1)
        disparity = np.maximum(sgbm.compute(left[frame], right[frame]) / 16.0, 0)
        labels = range(1 + k % 5 * 40, 41 + k % 5 * 40)  # not those of the frame before
        cv2.imwrite(f"image_0/{k:06}.png", left[frame])
        cv2.imwrite(f"depth/{k:06}.png", (256 * disparity).astype(np.uint16))
        mask = mask_of(zip(labels, boxes.get(frame, [])), disparity)
        np.savetxt(f"semantic/{k:06}.txt", mask, fmt="%d")
        flow = dis.calc(left[frame], left[min(k + 1, len(left) - 1)], None)
        cv2.writeOpticalFlow(f"flow/{k:06}.flo", flow)
        # A body without a true pose is skipped: each has a made-up one, in which the saved motions
        # are those in the world. It enters nothing but the program's own error figures.
        with open("pose_gt.txt", "a", encoding="utf-8") as truth, \
                open("object_pose.txt", "a", encoding="utf-8") as bodies:
            truth.write(f"{k} 1 0 0 0 0 1 0 0 0 0 1 0 0 0 0 1\n")
            bodies.writelines(f"{k} {i} 0 0 0 0 0 0 0 {-np.pi / 2}\n" for i in range(1, 201))


def write_results(times):
    np.savetxt("camera.txt", np.loadtxt("refined_stereo_new.txt")[:, 1:13])
    os.makedirs("objects")
    bodies = {}
    for motion, centre in zip(*(np.loadtxt(name, ndmin=2) for name in
                                ("obj_mot_stereo_rf_new.txt", "obj_centre.txt"))):
        frame, body = motion[:2].astype(int)
        start = np.block([[np.eye(3), centre[2:, None]], [0, 0, 0, 1]])
        poses = bodies.setdefault(body, {frame - 1: start})
        poses[frame] = motion[2:].reshape(4, 4) @ poses[max(poses)]
    for body, poses in bodies.items():
        with open(f"objects/{body}.tum", "w", encoding="utf-8") as out:
            for frame, pose in poses.items():
                turn = cv2.Rodrigues(pose[:3, :3])[0].ravel()
                angle = np.linalg.norm(turn)
                row = [times[frame], *pose[:3, 3], *np.sinc(angle / 2 / np.pi) / 2 * turn]
                print(*row, np.cos(angle / 2), file=out)


def main():
    program, left, right, times, settings, detections, speed = sys.argv[1:]
    times = np.loadtxt(times)
    write_input(images_in(left), images_in(right), read_boxes(detections))
    np.savetxt("times.txt", np.zeros(len(times) + 1), fmt="%d")  # it draws at other times
    SETTINGS["SFMgThres"] = float(speed) * (times[-1] - times[0]) / (len(times) - 1)
    with open(settings, encoding="utf-8") as given, open("all.yaml", "w", encoding="utf-8") as out:
        out.write(given.read() + "".join(f"{key}: {value}\n" for key, value in SETTINGS.items()))
    os.environ["QT_QPA_PLATFORM"] = "offscreen"
    subprocess.run([program, "all.yaml", "."], check=True)
    write_results(times)
    subprocess.run(["rm", "-r", "image_0", "depth", "semantic", "flow"], check=True)


main()
