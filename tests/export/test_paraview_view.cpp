#include "export/paraview_view.hpp"
#include "support/python.hpp"
#include "support/temporary_folder.hpp"

#include <gtest/gtest.h>

namespace braidzone {
namespace {

/// Reads the script's constants without ParaView.
constexpr auto read_constants = R"(import ast
tree = ast.parse(open('view.py').read())
constants = {}
for node in tree.body:
    if isinstance(node, ast.Assign):
        try:
            value = ast.literal_eval(node.value)
        except ValueError:
            continue
        target = node.targets[0]
        names = [n.id for n in target.elts] if isinstance(target, ast.Tuple) else [target.id]
        constants.update(zip(names, value if isinstance(target, ast.Tuple) else [value]))
for name in ('DEVICES', 'FIELD', 'CENTRE', 'SIZE', 'NORMAL', 'UP'):
    print(name, constants[name])
)";

// Looking from the side that the right-handed frame (along, towards, normal) gives, in the vessel's
// unit; `towards` need not be square to the device.
TEST(ParaviewView, IsAScriptThatLooksAcrossTheDevice)
{
    const test::TemporaryFolder folder;
    StandardView view;
    view.centre = Vec3(1e-3, 2e-3, 3e-3);
    view.along = Vec3::UnitX();
    view.towards = Vec3(0.5, 2.0, 0.0);
    view.size = 24e-3;
    view.has_field = true;
    write_paraview_view(folder.path() / "view.py", view, LengthUnit{"mm", 1e-3});
    EXPECT_EQ(test::printed_by_python(folder.path(), read_constants),
              "DEVICES ['device.vtp']\n"
              "FIELD field.vti\n"
              "CENTRE [1, 2, 3]\n"
              "SIZE 24\n"
              "NORMAL [0, 0, 1]\n"
              "UP [0, 1, 0]\n");
}

TEST(ParaviewView, NamesTheFilesThatAreThere)
{
    const test::TemporaryFolder folder;
    StandardView view;
    view.size = 1.0;
    view.has_second = true;
    write_paraview_view(folder.path() / "view.py", view, LengthUnit{"m", 1.0});
    const std::string printed = test::printed_by_python(folder.path(), read_constants);
    EXPECT_TRUE(printed.starts_with("DEVICES ['device.vtp', 'second_device.vtp']\nFIELD None\n"))
        << printed;
}

}  // namespace
}  // namespace braidzone
