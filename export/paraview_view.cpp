#include "export/paraview_view.hpp"

#include "export/text_file.hpp"

#include <fmt/format.h>

#include <string>

namespace braidzone {

namespace {

constexpr const char* before_settings =
    R"py("""The standard view of this run in ParaView 5.10 or later.

    cd here && paraview --script=view.py
    pvpython view.py picture.png

Left: the vessel and the device, coloured by its metal coverage. Right: a slice along the device with the
Darcy coefficient of the voxels. Without a display: xvfb-run -a pvpython view.py picture.png
"""
import os
import sys

from paraview.simple import *

# ParaView's --script tells a script nothing of its place: then it is the folder ParaView was started in.
FOLDER = os.path.dirname(os.path.abspath(__file__)) if "__file__" in globals() else os.getcwd()
)py";

constexpr const char* after_settings = R"py(

def reader(name):
    path = os.path.join(FOLDER, name)
    if not os.path.exists(path):
        raise RuntimeError(f"{path} is missing: start ParaView in the folder of view.py")
    kind = XMLImageDataReader if name.endswith(".vti") else XMLPolyDataReader
    source = kind(registrationName=name, FileName=[path])
    source.UpdatePipeline()
    return source


def show_vessel(source, view):
    display = Show(source, view)
    ColorBy(display, None)
    display.Opacity = 0.15
    display.AmbientColor = display.DiffuseColor = [0.8, 0.3, 0.25]


def colour(display, view, array, title, preset):
    ColorBy(display, ("CELLS", array))
    display.Ambient, display.Diffuse = 0.5, 0.5
    table = GetColorTransferFunction(array)
    table.ApplyPreset(preset, True)
    display.RescaleTransferFunctionToDataRange(False)
    display.SetScalarBarVisibility(view, True)
    bar = GetScalarBar(table, view)
    bar.Title, bar.ComponentTitle = title, ""
    bar.TitleColor = bar.LabelColor = [0, 0, 0]
    bar.AutomaticLabelFormat, bar.LabelFormat, bar.RangeLabelFormat = 0, "%.3g", "%.3g"
    bar.Orientation, bar.WindowLocation = "Horizontal", "Lower Center"


def look(view):
    view.UseColorPaletteForBackground = 0
    view.Background = [1, 1, 1]
    view.CameraFocalPoint = CENTRE
    view.CameraPosition = [c + 2 * SIZE * n for c, n in zip(CENTRE, NORMAL)]
    view.CameraViewUp = UP
    view.CameraParallelProjection = 1
    view.CameraParallelScale = 0.55 * SIZE
    return view


paraview.simple._DisableFirstRenderCameraReset()
vessel = reader("vessel.vtp")
left = look(GetActiveViewOrCreate("RenderView"))
layout = GetLayout(left)
if layout is None:  # without a window
    layout = CreateLayout("Braidzone")
    AssignViewToLayout(view=left, layout=layout, hint=0)
show_vessel(vessel, left)
for name in DEVICES:
    colour(Show(reader(name), left), left, "metal_coverage", "Metal coverage", "Viridis (matplotlib)")

if FIELD:
    place = layout.SplitHorizontal(0, 0.5) + 1
    right = look(CreateView("RenderView"))
    if GetLayout(right) is None:
        AssignViewToLayout(view=right, layout=layout, hint=place)
    show_vessel(vessel, right)
    plane = Slice(registrationName="slice", Input=reader(FIELD), SliceType="Plane")
    plane.SliceType.Origin, plane.SliceType.Normal = CENTRE, NORMAL
    lumen = Threshold(registrationName="slice of the lumen", Input=plane)
    lumen.Scalars = ["CELLS", "cell_type"]
    lumen.ThresholdMethod = "Above Upper Threshold"
    lumen.UpperThreshold = 1
    colour(Show(lumen, right), right, "darcy_normal", "Darcy coefficient, 1/m^2", "Cool to Warm")

RenderAllViews()
if len(sys.argv) > 1 and sys.argv[-1].endswith(".png"):
    SaveScreenshot(sys.argv[-1], layout, ImageResolution=[1600 if FIELD else 800, 800])
)py";

std::string as_python(const Vec3& v)
{
    return fmt::format("[{:.9g}, {:.9g}, {:.9g}]", v.x(), v.y(), v.z());
}

}  // namespace

void write_paraview_view(const std::filesystem::path& path, const StandardView& view,
                         const LengthUnit& unit)
{
    const Vec3 normal = view.along.cross(view.towards).normalized();
    const Vec3 up = normal.cross(view.along);
    std::string text = before_settings;
    text += fmt::format("DEVICES = [\"device.vtp\"{}]\n",
                        view.has_second ? ", \"second_device.vtp\"" : "");
    text += fmt::format("FIELD = {}\n", view.has_field ? "\"field.vti\"" : "None");
    text += fmt::format("# In {}, as the files' coordinates.\n", unit.name);
    text += fmt::format("CENTRE, SIZE = {}, {:.9g}\n", as_python(view.centre / unit.metres),
                        view.size / unit.metres);
    text += fmt::format("NORMAL, UP = {}, {}\n", as_python(normal), as_python(up));
    write_text_file(path, text + after_settings);
}

}  // namespace braidzone
