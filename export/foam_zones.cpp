#include "export/foam_zones.hpp"

#include "core/error.hpp"
#include "export/foam_cell_zones.hpp"
#include "export/foam_format.hpp"
#include "export/text_file.hpp"

#include <Eigen/Eigenvalues>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numbers>
#include <numeric>

namespace braidzone {

namespace {

/// ln D and the six components of n n^T, off-diagonal ones times sqrt(2) so that the distance is
/// the tensors' Frobenius norm.
using Feature = Eigen::Matrix<double, 7, 1>;

struct WeightedFeature {
    Feature value = Feature::Zero();
    double weight = 0.0;
};

std::vector<WeightedFeature> make_features(const CellResistance& resistance, const FoamMesh& mesh)
{
    const bool is_darcy = std::any_of(resistance.darcy.begin(), resistance.darcy.end(),
                                      [](double darcy) { return darcy > 0.0; });
    const auto& strength = is_darcy ? resistance.darcy : resistance.forchheimer;
    const double ratio = resistance.tangential_ratio.linear;
    const double anisotropy = std::abs(1.0 - ratio) / std::max(1.0, ratio);

    std::vector<WeightedFeature> features(resistance.cells.size());
    for (std::size_t i = 0; i < features.size(); ++i) {
        if (!(strength[i] > 0.0)) continue;  // no resistance: no weight
        const Vec3& n = resistance.normal[i];
        const double s = std::numbers::sqrt2;
        features[i].value << std::log(strength[i]), anisotropy * n.x() * n.x(),
            anisotropy * n.y() * n.y(), anisotropy * n.z() * n.z(), anisotropy * s * n.x() * n.y(),
            anisotropy * s * n.y() * n.z(), anisotropy * s * n.z() * n.x();
        features[i].weight =
            strength[i] * mesh.cell_volumes[static_cast<std::size_t>(resistance.cells[i])];
    }
    return features;
}

/// Members of a future zone (indices into the features), and how it would be cut.
struct Group {
    std::vector<std::size_t> members;
    Feature mean = Feature::Zero();
    Feature widest = Feature::Zero();  ///< direction of the largest variance
    double error = 0.0;                ///< weighted sum of squared distances to the mean
};

Group make_group(std::vector<std::size_t> members, const std::vector<WeightedFeature>& features)
{
    Group group;
    double weight = 0.0;
    for (const std::size_t i : members) {
        weight += features[i].weight;
        group.mean += features[i].weight * features[i].value;
    }
    group.mean /= weight;
    Eigen::Matrix<double, 7, 7> scatter = Eigen::Matrix<double, 7, 7>::Zero();
    for (const std::size_t i : members) {
        const Feature d = features[i].value - group.mean;
        scatter += features[i].weight * d * d.transpose();
    }
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix<double, 7, 7>> solver(scatter);
    group.widest = solver.eigenvectors().col(6);
    group.error = scatter.trace();
    group.members = std::move(members);
    return group;
}

/// Cuts a group through its mean; the second part is empty if nothing separates its members.
std::pair<std::vector<std::size_t>, std::vector<std::size_t>> cut(
    const Group& group, const std::vector<WeightedFeature>& features)
{
    std::pair<std::vector<std::size_t>, std::vector<std::size_t>> parts;
    for (const std::size_t i : group.members) {
        const double side = group.widest.dot(features[i].value - group.mean);
        (side <= 0.0 ? parts.first : parts.second).push_back(i);
    }
    return parts;
}

FoamZone make_zone(const Group& group, const CellResistance& resistance, const FoamMesh& mesh)
{
    FoamZone zone;
    Mat3 directions = Mat3::Zero();
    for (const std::size_t i : group.members) {
        const int cell = resistance.cells[i];
        const double volume = mesh.cell_volumes[static_cast<std::size_t>(cell)];
        zone.cells.push_back(cell);
        zone.volume += volume;
        zone.darcy += resistance.darcy[i] * volume;
        zone.forchheimer += resistance.forchheimer[i] * volume;
        const double strength =
            resistance.darcy[i] > 0.0 ? resistance.darcy[i] : resistance.forchheimer[i];
        directions += strength * volume * resistance.normal[i] * resistance.normal[i].transpose();
    }
    zone.darcy /= zone.volume;
    zone.forchheimer /= zone.volume;
    // The mean of directions without sign: the first principal axis of the sum of n n^T.
    const Eigen::SelfAdjointEigenSolver<Mat3> solver(directions);
    zone.normal = solver.eigenvectors().col(2);
    if (zone.normal.dot(resistance.normal[group.members.front()]) < 0.0) zone.normal *= -1.0;
    return zone;
}

/// A unit vector at right angles to n.
Vec3 some_perpendicular(const Vec3& n)
{
    Eigen::Index smallest = 0;
    n.cwiseAbs().minCoeff(&smallest);
    return n.cross(Vec3::Unit(smallest)).normalized();
}

std::string darcy_forchheimer(const Vec3& d, const Vec3& f)
{
    return fmt::format(
        "        type            DarcyForchheimer;\n"
        "        d               d [0 -2 0 0 0 0 0] {};\n"
        "        f               f [0 -1 0 0 0 0 0] {};\n",
        foam_vector(d), foam_vector(f));
}

std::string fixed_coefficients(const Vec3& d, const Vec3& f, const Fluid& fluid)
{
    return fmt::format(
        "        type            fixedCoeff;\n"
        "        alpha           alpha [0 0 -1 0 0 0 0] {};\n"
        "        beta            beta [0 -1 0 0 0 0 0] {};\n",
        foam_vector(fluid.viscosity / fluid.density * d), foam_vector(0.5 * f));
}

}  // namespace

std::vector<FoamZone> cluster(const CellResistance& resistance, const FoamMesh& mesh,
                              int most_zones)
{
    if (most_zones < 1) throw InputError(fmt::format("{} zones; allowed: 1 or more", most_zones));
    const std::vector<WeightedFeature> features = make_features(resistance, mesh);
    std::vector<std::size_t> resisting;
    for (std::size_t i = 0; i < features.size(); ++i)
        if (features[i].weight > 0.0) resisting.push_back(i);
    if (resisting.empty()) return {};

    std::vector<Group> groups{make_group(std::move(resisting), features)};
    while (groups.size() < static_cast<std::size_t>(most_zones)) {
        const auto worst =
            std::max_element(groups.begin(), groups.end(),
                             [](const Group& a, const Group& b) { return a.error < b.error; });
        auto [below, above] = cut(*worst, features);
        if (below.empty() || above.empty()) break;  // its members are alike
        *worst = make_group(std::move(below), features);
        groups.push_back(make_group(std::move(above), features));
    }

    std::vector<FoamZone> zones;
    zones.reserve(groups.size());
    for (const Group& group : groups)
        zones.push_back(make_zone(group, resistance, mesh));
    std::stable_sort(zones.begin(), zones.end(),
                     [](const FoamZone& a, const FoamZone& b) { return a.darcy > b.darcy; });
    return zones;
}

std::string foam_zone_name(std::size_t zone)
{
    return fmt::format("FD_{:04}", zone);
}

double resistance_integral(const std::vector<FoamZone>& zones)
{
    double sum = 0.0;
    for (const FoamZone& zone : zones)
        sum += zone.darcy * zone.volume;
    return sum;
}

std::string porous_sources(const std::vector<FoamZone>& zones, const TangentialRatio& ratio,
                           const std::string& object, const std::optional<Fluid>& fixed)
{
    std::string text = foam_header("dictionary", "constant", object);
    text +=
        "// Resistance of the flow diverter: S = -(mu D + 1/2 rho |U| F) U, D in 1/m^2, F in 1/m,\n"
        "// along the axes of each zone; e1 is the normal of the braid.\n";
    if (fixed)
        text += fmt::format(
            "// mu is {} Pa s whatever the shear: alpha = mu D / rho [1/s], beta = F / 2 [1/m].\n",
            fixed->viscosity);
    if (zones.empty()) text += "// No zone: the device meets no flow, or is not applied yet.\n";
    auto out = std::back_inserter(text);
    for (std::size_t i = 0; i < zones.size(); ++i) {
        const FoamZone& zone = zones[i];
        const Vec3 d = zone.darcy * Vec3(1.0, ratio.linear, ratio.linear);
        const Vec3 f = zone.forchheimer * Vec3(1.0, ratio.quadratic, ratio.quadratic);
        const std::string model =
            fixed ? fixed_coefficients(d, f, *fixed) : darcy_forchheimer(d, f);
        fmt::format_to(out, R"(
{name}
{{
    type            explicitPorositySource;
    active          yes;
    explicitPorositySourceCoeffs
    {{
        selectionMode   cellZone;
        cellZone        {name};
{model}        coordinateSystem
        {{
            type            cartesian;
            origin          (0 0 0);
            coordinateRotation
            {{
                type            axesRotation;
                e1              {e1};
                e2              {e2};
            }}
        }}
    }}
}}
)",
                       fmt::arg("name", foam_zone_name(i)), fmt::arg("model", model),
                       fmt::arg("e1", foam_vector(zone.normal)),
                       fmt::arg("e2", foam_vector(some_perpendicular(zone.normal))));
    }
    return text;
}

void write_foam_zones(const std::filesystem::path& foam_case, const std::vector<FoamZone>& zones,
                      const TangentialRatio& ratio, const std::optional<Fluid>& fixed)
{
    std::vector<FoamCellZone> cell_zones = read_cell_zones(foam_case);
    std::erase_if(cell_zones,
                  [](const FoamCellZone& zone) { return zone.name.starts_with("FD_"); });
    for (std::size_t i = 0; i < zones.size(); ++i)
        cell_zones.push_back({foam_zone_name(i), zones[i].cells});
    write_cell_zones(foam_case, cell_zones);
    for (const char* object : {"fvOptions", "fvModels"})
        write_text_file(foam_case / "constant" / object,
                        porous_sources(zones, ratio, object, fixed));
}

}  // namespace braidzone
