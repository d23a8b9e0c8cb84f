#!/usr/bin/env python3
"""Writes bend.gltf: a strip on two bones whose second one turns, under nodes that are moved, turned and scaled."""
import base64
import json
import math
import struct
from pathlib import Path

positions, joints, weights = [], [], []
for i in range(5):
    for x in (-0.2, 0.2):
        positions += [x, i * 0.5, 0.0]
        joints += [0, 1, 0, 0]
        w = min(1.0, max(0.0, (i - 1) / 2))
        weights += [1 - w, w, 0, 0]
indices = []
for i in range(4):
    a = 2 * i
    indices += [a, a + 1, a + 3, a, a + 3, a + 2]
root = [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1]
tip = [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, -1, 0, 1]
times = [0.0, 1.0]
s = math.sin(math.pi / 4)
rotations = [0, 0, 0, 1, 0, 0, s, s]

blob, views, accessors = b"", [], []


def add(data, fmt, component, kind, width, extra=None):
    global blob
    raw = struct.pack(f"<{len(data)}{fmt}", *data)
    views.append({"buffer": 0, "byteOffset": len(blob), "byteLength": len(raw)})
    accessors.append({"bufferView": len(views) - 1, "componentType": component, "count": len(data) // width,
                      "type": kind, **(extra or {})})
    blob += raw + b"\0" * (-len(raw) % 4)
    return len(accessors) - 1


p = add(positions, "f", 5126, "VEC3", 3, {"min": [-0.2, 0, 0], "max": [0.2, 2, 0]})
j = add(joints, "H", 5123, "VEC4", 4)
w = add(weights, "f", 5126, "VEC4", 4)
i = add(indices, "H", 5123, "SCALAR", 1)
m = add(root + tip, "f", 5126, "MAT4", 16)
t = add(times, "f", 5126, "SCALAR", 1, {"min": [0], "max": [1]})
r = add(rotations, "f", 5126, "VEC4", 4)
gltf = {
    "asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}],
    "nodes": [{"name": "top", "translation": [1, 2, 3], "rotation": [0, s, 0, s], "scale": [2, 2, 2], "children": [1, 2]},
              {"name": "strip", "mesh": 0, "skin": 0},
              {"name": "root", "children": [3]}, {"name": "tip", "translation": [0, 1, 0]}],
    "meshes": [{"primitives": [{"attributes": {"POSITION": p, "JOINTS_0": j, "WEIGHTS_0": w}, "indices": i}]}],
    "skins": [{"joints": [2, 3], "inverseBindMatrices": m}],
    "animations": [{"name": "bend", "samplers": [{"input": t, "output": r}],
                    "channels": [{"sampler": 0, "target": {"node": 3, "path": "rotation"}}]}],
    "accessors": accessors, "bufferViews": views,
    "buffers": [{"byteLength": len(blob),
                 "uri": "data:application/octet-stream;base64," + base64.b64encode(blob).decode()}],
}
(Path(__file__).resolve().parent / "bend.gltf").write_text(json.dumps(gltf, indent=1) + "\n")
