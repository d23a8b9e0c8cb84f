"""Times Blender's Cycles on a scene that `prizma-render bench frame --export SCENE.obj` wrote.

    blender -b --python-exit-code 1 --python tests/bench/cycles.py -- SCENE.obj [repeats]

Prints, as JSON, the milliseconds of a sample a pixel of direct light and of paths of four bounces on the processor, each as
an eighth of the difference between pictures of nine samples and of one. No adaptive sampling, no denoising, box filter, a
point light of zero radius, constant background.
"""

import json
import math
import statistics
import sys
import time

import bpy
from mathutils import Matrix, Vector


def look_at(camera):
    position, target, up = (Vector(camera[key]) for key in ("position", "target", "up"))
    backward = (position - target).normalized()
    right = up.cross(backward).normalized()
    matrix = Matrix((right, backward.cross(right), backward)).transposed().to_4x4()
    matrix.translation = position
    return matrix


def build(obj_file, setup):
    bpy.ops.wm.read_factory_settings(use_empty=True)
    bpy.ops.wm.obj_import(filepath=obj_file, forward_axis="Y", up_axis="Z")
    material = bpy.data.materials.new("surface")  # Prizma's plain material: specular 1 there is 0.5 here
    material.use_nodes = True
    shader = material.node_tree.nodes["Principled BSDF"]
    shader.inputs["Base Color"].default_value = (0.8, 0.8, 0.8, 1.0)
    shader.inputs["Roughness"].default_value = 0.5
    shader.inputs["Specular"].default_value = 0.5
    for thing in list(bpy.data.objects):
        thing.data.materials.clear()
        thing.data.materials.append(material)

    scene = bpy.context.scene
    camera = bpy.data.cameras.new("camera")
    camera.sensor_fit = "VERTICAL"
    camera.angle_y = math.radians(setup["camera"]["fovY"])
    camera.clip_start, camera.clip_end = 1e-3, 1e6
    scene.camera = bpy.data.objects.new("camera", camera)
    scene.camera.matrix_world = look_at(setup["camera"])
    scene.collection.objects.link(scene.camera)

    light = bpy.data.lights.new("light", "POINT")
    light.shadow_soft_size = 0.0
    light.energy = setup["light"]["intensity"] * 4.0 * math.pi * math.pi
    placed = bpy.data.objects.new("light", light)
    placed.location = setup["light"]["position"]
    scene.collection.objects.link(placed)

    scene.world = bpy.data.worlds.new("world")
    scene.world.use_nodes = True
    background = scene.world.node_tree.nodes["Background"]
    background.inputs["Color"].default_value = (*setup["background"], 1.0)
    scene.world.cycles.sampling_method = "NONE"
    return scene


def configure(scene):
    scene.render.engine = "CYCLES"
    scene.render.resolution_x, scene.render.resolution_y = 1280, 720
    scene.render.resolution_percentage = 100
    scene.render.use_persistent_data = False  # kept data keeps pictures as well when only the sample count changes
    cycles = scene.cycles
    cycles.device = "CPU"
    cycles.use_adaptive_sampling = False
    cycles.use_denoising = False
    cycles.use_auto_tile = False
    cycles.pixel_filter_type = "BOX"
    cycles.light_sampling_threshold = 0.0


def limit_bounces(scene, bounces):
    cycles = scene.cycles
    cycles.max_bounces = bounces
    cycles.diffuse_bounces = cycles.glossy_bounces = cycles.transmission_bounces = bounces
    cycles.transparent_max_bounces = bounces


def render_seconds(scene, samples):
    scene.cycles.samples = samples
    start = time.perf_counter()
    bpy.ops.render.render()
    return time.perf_counter() - start


def sample_milliseconds(scene, bounces, repeats):
    limit_bounces(scene, bounces)
    times = []
    for _ in range(repeats):
        one = render_seconds(scene, 1)
        times.append((render_seconds(scene, 9) - one) / 8.0 * 1000.0)
    return statistics.median(times)


def main():
    arguments = sys.argv[sys.argv.index("--") + 1 :]
    with open(arguments[0] + ".json", encoding="utf-8") as file:
        setup = json.load(file)
    repeats = int(arguments[1]) if len(arguments) > 1 else 1
    scene = build(arguments[0], setup)
    configure(scene)
    triangles = sum(len(thing.data.loop_triangles) or len(thing.data.polygons)
                    for thing in bpy.data.objects if thing.type == "MESH")
    result = {"renderer": "Cycles, Blender " + bpy.app.version_string, "polygons": triangles,
              "direct": sample_milliseconds(scene, 0, repeats), "fourBounces": sample_milliseconds(scene, 4, repeats)}
    print("CYCLES " + json.dumps(result))


main()
