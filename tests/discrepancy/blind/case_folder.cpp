#include "discrepancy/blind/case_folder.hpp"

#include "core/error.hpp"
#include "core/phantom_file.hpp"
#include "discrepancy/measured_surface.hpp"
#include "support/devices_of_any_size.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <fstream>
#include <numbers>

namespace braidzone::blind {
namespace {

using Json = nlohmann::ordered_json;

std::ofstream opened(const fs::path& file)
{
    std::ofstream out(file);
    if (!out) throw IoError(fmt::format("{} cannot be written", file.string()));
    return out;
}

std::string millimetres(double value)
{
    return fmt::format("\"{:.6f} mm\"", 1e3 * value);
}

std::string degrees(double value)
{
    return fmt::format("\"{:.6f} deg\"", value * 180.0 / std::numbers::pi);
}

/// Of the parameters that `random_belief` sets.
std::string phantom_text(const Phantom& phantom)
{
    std::string text = fmt::format(
        "[vessel]\nproximal_radius = {}\ndistal_radius = {}\nblend_radius = {}\nedge_length = {}\n",
        millimetres(phantom.proximal_radius), millimetres(phantom.distal_radius),
        millimetres(phantom.blend_radius), millimetres(phantom.edge_length));
    for (const PhantomSegment& segment : phantom.segments) {
        text += fmt::format("\n[[segment]]\nlength = {}\nangle = {}\nplane_angle = {}\n",
                            millimetres(segment.length), degrees(segment.angle),
                            degrees(segment.plane_angle));
    }
    for (const PhantomSac& sac : phantom.sacs) {
        text += fmt::format(
            "\n[[sac]]\nposition = {}\ndirection = {}\ndiameter = {}\nheight = {}\nneck = {}\n",
            millimetres(sac.position.value()), degrees(sac.direction), millimetres(sac.diameter),
            millimetres(sac.height), millimetres(sac.neck));
    }
    return text;
}

hidden::Belief read_belief(const fs::path& folder)
{
    const TomlTable device = TomlTable::read_file(folder / "device.toml");
    hidden::Belief belief;
    belief.phantom = read_phantom(TomlTable::read_file(folder / "phantom.toml"));
    belief.device = test::pipeline(device.quantity("diameter", Dimension::length),
                                   device.quantity("length", Dimension::length));
    belief.device.force_scale = device.number("force_scale");
    belief.landing = device.quantity("landing_distal", Dimension::length);
    device.finish();
    return belief;
}

}  // namespace

Lumen believed_lumen(const Phantom& phantom)
{
    PhantomVessel made = make_phantom(phantom);
    Vessel vessel = make_vessel(made.wall, LengthUnit{});
    WallTree wall(vessel);
    return {std::move(vessel), std::move(wall), resample(made.centerline)};
}

Model believed_model(const hidden::Belief& belief)
{
    Model model;
    model.device = belief.device;
    model.landing_distal = belief.landing;
    return model;
}

void write_scan(const hidden::ScannedDevice& scan, const fs::path& folder)
{
    std::ofstream points = opened(folder / "measured.csv");
    points << "x_mm,y_mm,z_mm\n";
    for (const Vec3& p : scan.points)
        points << fmt::format("{:.3f},{:.3f},{:.3f}\n", 1e3 * p.x(), 1e3 * p.y(), 1e3 * p.z());
    std::ofstream ends = opened(folder / "measured.toml");
    ends << "# End markers of the measured device, arc lengths on the vessel's centerline.\n";
    for (std::size_t i = 0; i < 2; ++i) {
        ends << fmt::format("{0} = \"{1:.2f} mm\"\n{0}_sd = \"{2:.2f} mm\"\n", scalar_names[i],
                            1e3 * scan.ends.values[i]->value, 1e3 * scan.ends.values[i]->sd);
    }
}

void write_further(const hidden::FurtherData& further, const fs::path& folder)
{
    std::ofstream places = opened(folder / "density.csv");
    places << "x_mm,y_mm,z_mm,pore_density_per_mm2,sd_per_mm2\n";
    for (const DensityPlace& place : further.density.places) {
        places << fmt::format("{:.3f},{:.3f},{:.3f},{:.3f},{:.3f}\n", 1e3 * place.point.x(),
                              1e3 * place.point.y(), 1e3 * place.point.z(), 1e-6 * place.value,
                              1e-6 * place.sd);
    }
    opened(folder / "further.toml")
        << fmt::format("contact_force = \"{:.5f} N\"\ncontact_force_sd = \"{:.5f} N\"\n",
                       further.force.force.value, further.force.force.sd);
}

void write_case(const hidden::HiddenCase& made, const hidden::FurtherData& further,
                const fs::path& folder)
{
    fs::create_directories(folder);
    opened(folder / "phantom.toml") << phantom_text(made.belief.phantom);
    opened(folder / "device.toml")
        << fmt::format("diameter = {}\nlength = {}\nforce_scale = {:.6g}\nlanding_distal = {}\n",
                       millimetres(made.belief.device.nominal_diameter),
                       millimetres(made.belief.device.nominal_length),
                       made.belief.device.force_scale, millimetres(made.belief.landing));
    write_scan(made.scan, folder);
    write_further(further, folder);
}

CaseData read_case(const fs::path& folder, bool with_further)
{
    const hidden::Belief belief = read_belief(folder);
    Lumen lumen = believed_lumen(belief.phantom);
    MeasuredScalars scalars =
        read_measured_scalars(TomlTable::read_file(folder / "measured.toml"), lumen.centerline);
    DensityMap density;
    if (with_further) {
        scalars.contact_force =
            read_measured_scalars(TomlTable::read_file(folder / "further.toml"), lumen.centerline)
                .contact_force;
        density = read_density_map(folder / "density.csv");
    }
    return {believed_model(belief), std::move(lumen),
            read_measured_surface(folder / "measured.csv", {}), scalars, std::move(density)};
}

std::string truth_text(const CaseTruth& truth, std::uint64_t salt)
{
    Json json = {{"kind", truth.kind},
                 {"salt", salt},
                 {"effects", Json::array()},
                 {"detectability", truth.detectability}};
    for (const hidden::HiddenEffect& effect : truth.effects) {
        json["effects"].push_back(
            {{"name", effect.name}, {"size", name_of(effect.size)}, {"values", effect.values}});
    }
    return json.dump(1) + "\n";
}

CaseTruth read_truth(const fs::path& file)
{
    std::ifstream in(file);
    if (!in) throw IoError(fmt::format("{} cannot be read", file.string()));
    const Json json = Json::parse(in);
    CaseTruth truth{.kind = json.at("kind"), .effects = {}};
    for (const Json& one : json.at("effects")) {
        hidden::HiddenEffect effect{.name = one.at("name")};
        for (const auto size :
             {hidden::EffectSize::weak, hidden::EffectSize::medium, hidden::EffectSize::strong}) {
            if (one.at("size") == name_of(size)) effect.size = size;
        }
        for (const auto& [name, value] : one.at("values").items())
            effect.values[name] = value;
        truth.effects.push_back(effect);
    }
    truth.detectability = json.at("detectability").get<std::vector<double>>();
    return truth;
}

std::vector<std::string> cases_in(const fs::path& data)
{
    std::vector<std::string> names;
    for (const fs::directory_entry& entry : fs::directory_iterator(data)) {
        if (entry.is_directory()) names.push_back(entry.path().filename().string());
    }
    std::sort(names.begin(), names.end());
    return names;
}

}  // namespace braidzone::blind
