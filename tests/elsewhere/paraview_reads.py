"""What ParaView makes of an exported series, compared with what Ripstop says it holds.

pvbatch paraview_reads.py FOLDER

FOLDER has series.pvd, and expected.json with "times" in seconds and "frames": for each the places of all
particles in metres. Prints the largest distance for some frames and the arrays with their ranges;
the last line is "all read".
"""

import json
import pathlib
import sys

from paraview import servermanager
from paraview.simple import PVDReader


def main(folder):
    data = json.loads((folder / "expected.json").read_text())
    reader = PVDReader(FileName=str(folder / "series.pvd"))
    times = list(reader.TimestepValues)
    assert len(times) == len(data["times"]), (len(times), len(data["times"]))
    for frame in sorted({0, 1, len(times) // 2, len(times) - 1}):
        assert abs(times[frame] - data["times"][frame]) < 1e-9, (times[frame], data["times"][frame])
        reader.UpdatePipeline(times[frame])
        surface = servermanager.Fetch(reader)
        expected = data["frames"][frame]
        assert surface.GetNumberOfPoints() == len(expected), "number of points"
        gap = max(
            abs(a - b)
            for i, place in enumerate(expected)
            for a, b in zip(surface.GetPoint(i), place)
        )
        print(f"series.pvd frame {frame}: {gap:.3g}")
    for arrays in (surface.GetPointData(), surface.GetCellData()):
        for i in range(arrays.GetNumberOfArrays()):
            array = arrays.GetArray(i)
            low, high = array.GetRange(-1)
            print(f"array {array.GetName()}: {low:.4g} to {high:.4g}")
    print("all read")


main(pathlib.Path(sys.argv[1]))
