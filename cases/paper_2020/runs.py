"""Runs Braidzone on case files and reads what it writes."""

import json
import os
import subprocess
import sys
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

HERE = Path(__file__).resolve().parent
PROGRAM = os.environ.get("BRAIDZONE", str(HERE.parent.parent / "braidzone"))


def braidzone(*words):
    """Runs the program with these arguments; what it says goes with the error if it fails."""
    command = [PROGRAM, *map(str, words)]
    ran = subprocess.run(command, capture_output=True, text=True)
    if ran.returncode != 0:
        sys.exit(f"{' '.join(command)}\nended with status {ran.returncode}: {ran.stderr.strip()}")


def settings(keys):
    return [word for key, value in keys.items() for word in ("--set", f"{key}={value}")]


def phantom(parameters, folder, **keys):
    """Makes a vessel: vessel.stl and centerline.vtp in the folder."""
    folder.mkdir(parents=True, exist_ok=True)
    braidzone("phantom", parameters, "--output", folder, "--force", "--quiet", *settings(keys))


def deploy(case, output, keys={}, frames=0):
    """Deploys a case into the output folder and returns it with its figures."""
    more = ["--frames", frames] if frames else []
    braidzone("deploy", case, "--output", output, "--force", "--quiet", *settings(keys), *more)
    return Run(output)


def all_at_once(function, jobs):
    """function(*job) for each job, as many at a time as there are processors; in order."""
    braidzone("--version")  # builds the program, if it must be, before several want it
    with ThreadPoolExecutor(os.cpu_count()) as threads:
        return list(threads.map(lambda job: function(*job), jobs))


class Run:
    """An output folder: figures by name in SI units, and the device's surface."""

    def __init__(self, folder):
        self.folder = Path(folder)
        self.summary = json.loads((self.folder / "summary.json").read_text())

    def __getitem__(self, name):
        quantity = self.summary["quantities"][name]
        return float("nan") if quantity is None else quantity["value"]

    def surface(self, file="device.vtp"):
        return Surface(self.folder / file)


class Surface:
    """A VTK surface as numpy arrays: points, polygons of equal size, fields by name."""

    def __init__(self, file):
        from vtkmodules.util.numpy_support import vtk_to_numpy
        from vtkmodules.vtkIOXML import vtkXMLPolyDataReader

        reader = vtkXMLPolyDataReader()
        reader.SetFileName(str(file))
        reader.Update()
        data = reader.GetOutput()
        if data.GetNumberOfPoints() == 0:
            sys.exit(f"{file}: cannot be read, or has no points")
        self.points = vtk_to_numpy(data.GetPoints().GetData())
        connectivity = vtk_to_numpy(data.GetPolys().GetConnectivityArray())
        self.polygons = connectivity.reshape(data.GetNumberOfPolys(), -1)
        self.at_points = self._fields(data.GetPointData(), vtk_to_numpy)
        self.at_polygons = self._fields(data.GetCellData(), vtk_to_numpy)

    @staticmethod
    def _fields(data, to_numpy):
        arrays = [data.GetArray(i) for i in range(data.GetNumberOfArrays())]
        return {array.GetName(): to_numpy(array) for array in arrays}

    def polygon_means(self, name):
        """A field of the points, averaged over each polygon's corners."""
        return self.at_points[name][self.polygons].mean(axis=1)


def read_stl(file):
    """Corners of the triangles of a binary or ASCII STL: triangles x 3 x 3."""
    import numpy
    from vtkmodules.util.numpy_support import vtk_to_numpy
    from vtkmodules.vtkIOGeometry import vtkSTLReader

    reader = vtkSTLReader()
    reader.SetFileName(str(file))
    reader.Update()
    data = reader.GetOutput()
    points = vtk_to_numpy(data.GetPoints().GetData())
    return numpy.asarray(points[vtk_to_numpy(data.GetPolys().GetConnectivityArray())]).reshape(-1, 3, 3)
