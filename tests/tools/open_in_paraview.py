"""Opens a run directory in ParaView and checks what it sees; prints a line per frame.

usage: pvpython tests/tools/open_in_paraview.py RUN     (on a machine without a display: xvfb-run -a pvpython ...)

Every listed frame must open at its time, every cell must have positive volume and faces that look outward (pyramids,
wedges and tetrahedra included: an order of nodes that VTK does not share shows here), and the fields of
docs/results.md must be there. Exit status 1 otherwise.
"""
import sys

from paraview.simple import CellSize, OpenDataFile, servermanager

CELL_FIELDS = {"stress": 6, "effective_plastic_strain": 1, "pressure": 1, "von_mises": 1, "part_id": 1, "element_id": 1}
POINT_FIELDS = {"displacement": 3, "velocity": 3, "acceleration": 3, "node_id": 1}


def fetch(proxy):
    data = servermanager.Fetch(proxy)
    return data.GetBlock(0) if hasattr(data, "GetNumberOfBlocks") else data


def cross(a, b):
    return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]


def inward_faces(grid, limit=2000):
    """Faces among the first cells whose normal points into their cell."""
    count = 0
    for number in range(min(limit, grid.GetNumberOfCells())):
        cell = grid.GetCell(number)
        points = [grid.GetPoint(cell.GetPointId(i)) for i in range(cell.GetNumberOfPoints())]
        middle = [sum(p[k] for p in points) / len(points) for k in range(3)]
        for face_number in range(cell.GetNumberOfFaces()):
            face = cell.GetFace(face_number)
            a, b, c = (grid.GetPoint(face.GetPointId(i)) for i in range(3))
            normal = cross([b[k] - a[k] for k in range(3)], [c[k] - a[k] for k in range(3)])
            count += sum(normal[k] * (a[k] - middle[k]) for k in range(3)) < 0.0
    return count


def missing(data, wanted):
    return [name for name, size in wanted.items()
            if not data.GetArray(name) or data.GetArray(name).GetNumberOfComponents() != size]


def check(run):
    reader = OpenDataFile(f"{run}/result.pvd")
    good = True
    for time in reader.TimestepValues:
        reader.UpdatePipeline(time)
        grid = fetch(reader)
        sizes = CellSize(reader)
        sizes.UpdatePipeline(time)
        volumes = fetch(sizes).GetCellData().GetArray("Volume")
        least = volumes.GetRange()[0]
        wrong = missing(grid.GetCellData(), CELL_FIELDS) + missing(grid.GetPointData(), POINT_FIELDS)
        inward = inward_faces(grid)
        stamp = grid.GetFieldData().GetArray("TimeValue").GetValue(0)
        fine = least > 0.0 and not wrong and inward == 0 and stamp == time
        good = good and fine
        print("ok  " if fine else "FAIL", f"time {time:g}: {grid.GetNumberOfPoints()} points, "
              f"{grid.GetNumberOfCells()} cells, least volume {least:g}, {inward} faces inward, missing {wrong}")
    return good and len(reader.TimestepValues) > 0


if __name__ == "__main__":
    sys.exit(0 if check(sys.argv[1]) else 1)
