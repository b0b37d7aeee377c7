#include "core/vessel_straightening.hpp"

#include "core/error.hpp"
#include "core/smooth_step.hpp"

#include <Eigen/SVD>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace braidzone {

namespace {

/// An edge of the wall may change its length by this factor at most.
constexpr double largest_edge_ratio = 4.0;

constexpr int most_foot_iterations = 30;
/// Distance of a foot from where it should be, over the centerline's spacing.
constexpr double foot_tolerance = 1e-9;

/// Tangent, normal and binormal as columns.
Mat3 frame_of(const CrossSection& section)
{
    Mat3 frame;
    frame << section.tangent, section.normal, section.binormal;
    return frame;
}

void set_frame(CrossSection& section, const Mat3& frame)
{
    section.tangent = frame.col(0);
    section.normal = frame.col(1);
    section.binormal = frame.col(2);
}

double window(const VesselStraightening& straightening, double arc_length)
{
    const double u = std::abs(arc_length - straightening.centre) / straightening.half_width;
    return smooth_step(2.0 * (1.0 - u));
}

double kept_weight(const VesselStraightening& straightening, double arc_length)
{
    if (!(straightening.kept_to > straightening.kept_from))
        return window(straightening, arc_length);
    return arc_length >= straightening.kept_from && arc_length <= straightening.kept_to ? 1.0 : 0.0;
}

/// Way over a unit of arc length in the frame at its start, of a line that turns evenly by a
/// rotation vector: the integral of exp(u omega) e_tangent for u from 0 to 1.
Vec3 way_along_arc(const Vec3& turn)
{
    const double angle = turn.norm(), square = angle * angle;
    // To the eighth order below 0.1, where the closed form of the last term cancels.
    const double first = angle < 0.1 ? 0.5 - square * (1.0 / 24.0 - square / 720.0)
                                     : (1.0 - std::cos(angle)) / square;
    const double second = angle < 0.1 ? 1.0 / 6.0 - square * (1.0 / 120.0 - square / 5040.0)
                                      : (angle - std::sin(angle)) / (square * angle);
    const Vec3 across = turn.cross(Vec3::UnitX());
    return Vec3::UnitX() + first * across + second * turn.cross(across);
}

/// The centerline with less curvature, its first section where it was.
Centerline with_less_curvature(const Centerline& centerline,
                               const VesselStraightening& straightening)
{
    Centerline result = centerline;
    for (std::size_t i = 0; i + 1 < centerline.sections.size(); ++i) {
        const Mat3 here = frame_of(centerline.sections[i]);
        const Mat3 next = frame_of(centerline.sections[i + 1]);
        const Eigen::AngleAxisd rotation(Mat3(here.transpose() * next));
        const Vec3 turn = rotation.angle() * rotation.axis();
        const double middle = (static_cast<double>(i) + 0.5) * centerline.spacing;
        const double kept = 1.0 - straightening.share * window(straightening, middle);
        const Vec3 step =
            here.transpose() * (centerline.sections[i + 1].origin - centerline.sections[i].origin) +
            centerline.spacing * (way_along_arc(kept * turn) - way_along_arc(turn));

        const Mat3 frame = frame_of(result.sections[i]);
        result.sections[i + 1].origin = result.sections[i].origin + frame * step;
        set_frame(result.sections[i + 1],
                  frame * Eigen::AngleAxisd(kept * rotation.angle(), rotation.axis()));
    }
    return result;
}

/// Points by which the place of a cross-section is judged: its middle and four on its circle.
std::array<Vec3, 5> points_of(const CrossSection& section)
{
    const Vec3 normal = section.inscribed_radius * section.normal;
    const Vec3 binormal = section.inscribed_radius * section.binormal;
    return {section.origin, section.origin + normal, section.origin - normal,
            section.origin + binormal, section.origin - binormal};
}

/// The rigid motion that brings the kept sections closest to where they were (Kabsch 1976).
Eigen::Isometry3d motion_back(const Centerline& moved, const Centerline& original,
                              const VesselStraightening& straightening)
{
    double weights = 0.0;
    Vec3 moved_mean = Vec3::Zero(), original_mean = Vec3::Zero();
    Mat3 products = Mat3::Zero();
    for (std::size_t i = 0; i < moved.sections.size(); ++i) {
        const double weight = kept_weight(straightening, static_cast<double>(i) * original.spacing);
        const auto from = points_of(moved.sections[i]), to = points_of(original.sections[i]);
        for (std::size_t k = 0; k < from.size(); ++k) {
            weights += weight;
            moved_mean += weight * from[k];
            original_mean += weight * to[k];
            products += weight * from[k] * to[k].transpose();
        }
    }
    if (!(weights > 0.0)) {
        throw GeometryError(fmt::format(
            "vessel.straightening: its window about {:.6g} mm and its kept stretch lie off the "
            "centerline, which runs from 0 to {:.6g} mm",
            1e3 * straightening.centre, 1e3 * original.length()));
    }
    moved_mean /= weights;
    original_mean /= weights;
    products -= weights * moved_mean * original_mean.transpose();
    const Eigen::JacobiSVD<Mat3> svd(products, Eigen::ComputeFullU | Eigen::ComputeFullV);
    Mat3 handed = Mat3::Identity();
    handed(2, 2) = (svd.matrixV() * svd.matrixU().transpose()).determinant() < 0.0 ? -1.0 : 1.0;
    Eigen::Isometry3d motion = Eigen::Isometry3d::Identity();
    motion.linear() = svd.matrixV() * handed * svd.matrixU().transpose();
    motion.translation() = original_mean - motion.linear() * moved_mean;
    return motion;
}

void move(Centerline& centerline, const Eigen::Isometry3d& motion)
{
    for (CrossSection& section : centerline.sections) {
        section.origin = motion * section.origin;
        set_frame(section, motion.linear() * frame_of(section));
    }
}

/// Arc length of the foot of a point: where the point lies in the cross-section, or an end.
double foot_of(const Centerline& centerline, const Vec3& point)
{
    double place = nearest_arc_length(centerline, point);
    for (int i = 0; i < most_foot_iterations; ++i) {
        const CrossSection section = section_at(centerline, place);
        const double way = section.tangent.dot(point - section.origin);
        const double next = std::clamp(place + way, 0.0, centerline.length());
        const bool is_found = std::abs(next - place) < foot_tolerance * centerline.spacing;
        place = next;
        if (is_found) break;
    }
    return place;
}

/// Refuses a wall that folds or tears.
/// @param turns  rotation of each point's surroundings
void require_whole(const TriangleMesh& before, const TriangleMesh& after,
                   const std::vector<Mat3>& turns)
{
    const auto refuse = [&](const Vec3& place, const char* what) {
        throw GeometryError(fmt::format(
            "vessel.straightening {} the wall near ({:.6g}, {:.6g}, {:.6g}) mm; take a smaller "
            "share or a wider window",
            what, 1e3 * place.x(), 1e3 * place.y(), 1e3 * place.z()));
    };
    for (const auto& triangle : before.triangles) {
        const auto corner = [&](const TriangleMesh& mesh, std::size_t k) -> const Vec3& {
            return mesh.points[static_cast<std::size_t>(triangle[k % 3])];
        };
        const auto area = [&](const TriangleMesh& mesh) -> Vec3 {
            return (corner(mesh, 1) - corner(mesh, 0)).cross(corner(mesh, 2) - corner(mesh, 0));
        };
        const Mat3& turn = turns[static_cast<std::size_t>(triangle[0])];
        if (!(area(after).dot(turn * area(before)) > 0.0)) refuse(corner(before, 0), "folds");
        for (std::size_t k = 0; k < 3; ++k) {
            const double ratio = (corner(after, k + 1) - corner(after, k)).norm() /
                                 (corner(before, k + 1) - corner(before, k)).norm();
            if (!(ratio < largest_edge_ratio && ratio > 1.0 / largest_edge_ratio))
                refuse(corner(before, k), "tears");
        }
    }
}

}  // namespace

void validate(const VesselStraightening& straightening)
{
    if (!(straightening.share >= 0.0 && straightening.share <= 1.0)) {
        throw ConfigError(
            fmt::format("straightening: share = {:.6g}; allowed are 0 (as it is) to 1 (straight)",
                        straightening.share));
    }
    if (!std::isfinite(straightening.centre) || !std::isfinite(straightening.kept_from) ||
        !std::isfinite(straightening.kept_to)) {
        throw ConfigError("straightening: centre, kept_from or kept_to is no place");
    }
    const bool has_width =
        straightening.half_width > 0.0 && std::isfinite(straightening.half_width);
    if (straightening.share > 0.0 && !has_width) {
        throw ConfigError(fmt::format("straightening: half_width = {:.6g} mm; it must be positive",
                                      1e3 * straightening.half_width));
    }
}

WallWithCenterline straightened(const TriangleMesh& wall, const Centerline& centerline,
                                const VesselStraightening& straightening)
{
    validate(straightening);
    if (straightening.share == 0.0) return {wall, centerline};
    WallWithCenterline result{wall, with_less_curvature(centerline, straightening)};
    move(result.centerline, motion_back(result.centerline, centerline, straightening));

    std::vector<Mat3> turns;
    turns.reserve(wall.points.size());
    for (Vec3& point : result.wall.points) {
        const double place = foot_of(centerline, point);
        const CrossSection before = section_at(centerline, place);
        const CrossSection after = section_at(result.centerline, place);
        turns.emplace_back(frame_of(after) * frame_of(before).transpose());
        point = after.origin + turns.back() * (point - before.origin);
    }
    require_whole(wall, result.wall, turns);
    return result;
}

}  // namespace braidzone
