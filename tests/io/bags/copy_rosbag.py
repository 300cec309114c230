#!/usr/bin/python3
"""Copies a ROS 1 bag with ROS's own reader and writer: copy_rosbag.py FROM TO COMPRESSION."""
# SPDX-FileCopyrightText: 2026 The RaDiVe authors
# SPDX-License-Identifier: BSD-3-Clause

import sys

import rosbag

source, target, compression = sys.argv[1:4]
with rosbag.Bag(source) as read, rosbag.Bag(
    target, "w", compression=compression, chunk_threshold=1500
) as written:
    for topic, message, time in read.read_messages(raw=True):
        written.write(topic, message, time, raw=True)
