"""What Blender makes of exported files, compared with what Ripstop says they hold.

blender --background --factory-startup --python blender_reads.py -- FOLDER

FOLDER/expected.json has "fps" and "frames": for each frame the places of the vertices of what has not
torn, in metres, y up; "corners" those of the panels at first. Every animation of the folder is opened, and
every mesh that is called moment. A line for some of its frames tells the largest distance between such a
place and the nearest vertex; panels that are gone may have vertices elsewhere. The last line is "all read".
"""

import json
import pathlib
import sys

import bpy
import mathutils
import numpy

if not hasattr(numpy, "bool"):
    numpy.bool = bool  # Debian's Blender 3.4 opens no glTF file with its numpy 1.24 otherwise


def expected_places(frame):
    """In Blender's axes, where z is up."""
    return [mathutils.Vector((x, -z, y)) for x, y, z in frame]


def places(objects):
    graph = bpy.context.evaluated_depsgraph_get()
    found = []
    for thing in objects:
        shape = thing.evaluated_get(graph)
        found += [thing.matrix_world @ vertex.co for vertex in shape.data.vertices]
    return found


def gap(expected, found):
    tree = mathutils.kdtree.KDTree(len(found))
    for number, place in enumerate(found):
        tree.insert(place, number)
    tree.balance()
    return max(tree.find(place)[2] for place in expected)


def meshes():
    return [thing for thing in bpy.data.objects if thing.type == "MESH"]


def fresh(open_file):
    bpy.ops.wm.read_factory_settings(use_empty=True)
    open_file()
    return meshes()


def add_cache(thing, file, kind, fps):
    cache = thing.modifiers.new("cache", "MESH_CACHE")
    cache.cache_format = kind
    cache.filepath = str(file)
    cache.frame_start = 0
    cache.time_mode = "FRAME" if kind == "PC2" else "TIME"
    bpy.context.scene.render.fps = fps


def moment_places(file):
    """In the axes of the file: only OBJ and Collada are turned, since the others do not say what is up."""
    operators = bpy.ops.import_mesh, bpy.ops.wm
    found = places(
        fresh(
            {
                ".ply": lambda: operators[0].ply(filepath=str(file)),
                ".stl": lambda: operators[0].stl(filepath=str(file)),
                ".dae": lambda: operators[1].collada_import(filepath=str(file)),
                ".obj": lambda: operators[1].obj_import(filepath=str(file)),
            }[file.suffix]
        )
    )
    if file.suffix in (".ply", ".stl"):
        return [mathutils.Vector((x, -z, y)) for x, y, z in found]
    return found


def report(name, frame, value):
    print(f"{name} frame {frame}: {value:.3g}")


def main(folder):
    data = json.loads((folder / "expected.json").read_text())
    fps = data["fps"]
    frames = [expected_places(frame) for frame in data["frames"]]
    probes = sorted({0, 1, len(frames) // 2, len(frames) - 1})

    for file in sorted(folder.iterdir()):
        name = str(file)
        if file.stem == "moment":
            report(file.name, 0, gap(expected_places(data["corners"]), moment_places(file)))
        elif file.suffix in (".glb", ".gltf"):
            bpy.ops.wm.read_factory_settings(use_empty=True)
            bpy.context.scene.render.fps = fps
            bpy.ops.import_scene.gltf(filepath=name)
            for frame in probes:
                bpy.context.scene.frame_set(frame)
                report(file.name, frame, gap(frames[frame], places(meshes())))
        elif file.suffix in (".pc2", ".mdd"):
            mesh = name.removesuffix(file.suffix) + ".obj"
            (thing,) = fresh(lambda: bpy.ops.wm.obj_import(filepath=mesh))
            add_cache(thing, file, file.suffix[1:].upper(), fps)
            for frame in probes:
                bpy.context.scene.frame_set(frame)
                report(file.name, frame, gap(frames[frame], places([thing])))
    print("all read")


main(pathlib.Path(sys.argv[sys.argv.index("--") + 1]))
