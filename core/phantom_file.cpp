#include "core/phantom_file.hpp"

namespace braidzone {

namespace {

PhantomSegment read_segment(const TomlTable& table)
{
    PhantomSegment segment;
    segment.length = table.quantity("length", Dimension::length);
    segment.angle = table.quantity_or("angle", Dimension::angle, segment.angle);
    segment.plane_angle = table.quantity_or("plane_angle", Dimension::angle, segment.plane_angle);
    return segment;
}

PhantomSac read_sac(const TomlTable& table)
{
    PhantomSac sac;
    if (table.has("position")) sac.position = table.quantity("position", Dimension::length);
    sac.direction = table.quantity_or("direction", Dimension::angle, sac.direction);
    sac.diameter = table.quantity("diameter", Dimension::length);
    sac.height = table.quantity_or("height", Dimension::length, sac.diameter);
    sac.neck = table.quantity("neck", Dimension::length);
    sac.edge_length = table.quantity_or("edge_length", Dimension::length, sac.edge_length);
    return sac;
}

PhantomBranch read_branch(const TomlTable& table)
{
    PhantomBranch branch;
    branch.position = table.quantity("position", Dimension::length);
    branch.direction = table.quantity_or("direction", Dimension::angle, branch.direction);
    branch.tilt = table.quantity_or("tilt", Dimension::angle, branch.tilt);
    branch.radius = table.quantity("radius", Dimension::length);
    branch.length = table.quantity("length", Dimension::length);
    return branch;
}

PhantomBifurcation read_bifurcation(const TomlTable& table)
{
    PhantomBifurcation bifurcation;
    bifurcation.radius = table.quantity("radius", Dimension::length);
    bifurcation.length = table.quantity("length", Dimension::length);
    bifurcation.half_angle =
        table.quantity_or("half_angle", Dimension::angle, bifurcation.half_angle);
    return bifurcation;
}

/// From a perforating branch to the aorta; what the parts demand of each other is checked when the
/// phantom is made.
const KeyRanges& phantom_key_ranges()
{
    static const KeyRanges ranges = {{"vessel.proximal_radius", "0 mm", "30 mm"},
                                     {"vessel.distal_radius", "0 mm", "30 mm"},
                                     {"vessel.ovality", "0", "1"},
                                     {"vessel.oval_direction", "-360 deg", "360 deg"},
                                     {"vessel.edge_length", "0 mm", "30 mm"},
                                     {"vessel.blend_radius", "0 mm", "30 mm"},
                                     {"segment.length", "0 mm", "2 m"},
                                     {"segment.angle", "0 deg", "360 deg"},
                                     {"segment.plane_angle", "-360 deg", "360 deg"},
                                     {"sac.position", "0 mm", "10 m"},
                                     {"sac.direction", "-360 deg", "360 deg"},
                                     {"sac.diameter", "0 mm", "100 mm"},
                                     {"sac.height", "0 mm", "100 mm"},
                                     {"sac.neck", "0 mm", "100 mm"},
                                     {"sac.edge_length", "0 mm", "30 mm"},
                                     {"branch.position", "0 mm", "10 m"},
                                     {"branch.direction", "-360 deg", "360 deg"},
                                     {"branch.tilt", "0 deg", "180 deg"},
                                     {"branch.radius", "0 mm", "30 mm"},
                                     {"branch.length", "0 mm", "2 m"},
                                     {"bifurcation.radius", "0 mm", "30 mm"},
                                     {"bifurcation.length", "0 mm", "2 m"},
                                     {"bifurcation.half_angle", "0 deg", "90 deg"}};
    return ranges;
}

}  // namespace

Phantom read_phantom(const TomlTable& file)
{
    Phantom phantom;
    const TomlTable vessel = file.table("vessel");
    phantom.proximal_radius = vessel.quantity("proximal_radius", Dimension::length);
    phantom.distal_radius =
        vessel.quantity_or("distal_radius", Dimension::length, phantom.proximal_radius);
    phantom.ovality = vessel.number_or("ovality", phantom.ovality);
    phantom.oval_direction =
        vessel.quantity_or("oval_direction", Dimension::angle, phantom.oval_direction);
    phantom.edge_length = vessel.quantity_or("edge_length", Dimension::length, phantom.edge_length);
    phantom.blend_radius =
        vessel.quantity_or("blend_radius", Dimension::length, phantom.blend_radius);
    for (const TomlTable& table : file.tables("segment")) {
        phantom.segments.push_back(read_segment(table));
    }
    for (const TomlTable& table : file.tables("sac"))
        phantom.sacs.push_back(read_sac(table));
    for (const TomlTable& table : file.tables("branch")) {
        phantom.branches.push_back(read_branch(table));
    }
    if (file.has("bifurcation")) phantom.bifurcation = read_bifurcation(file.table("bifurcation"));
    file.finish();
    file.require_ranges(phantom_key_ranges());
    return phantom;
}

}  // namespace braidzone
