#include "core/phantom_axis.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace braidzone {

namespace {

AxisPiece straight_piece(const CrossSection& start, double arc_length, double length)
{
    AxisPiece piece;
    piece.start = start;
    piece.towards = start.normal;
    piece.arc_length = arc_length;
    piece.length = length;
    return piece;
}

}  // namespace

PhantomAxis make_axis(const std::vector<PhantomSegment>& segments)
{
    PhantomAxis axis;
    CrossSection end;
    for (const PhantomSegment& segment : segments) {
        AxisPiece piece = straight_piece(end, axis.length, segment.length);
        piece.towards = std::cos(segment.plane_angle) * end.normal +
                        std::sin(segment.plane_angle) * end.binormal;
        piece.curvature = segment.angle / segment.length;
        axis.pieces.push_back(piece);
        axis.length += segment.length;
        end = section_along(piece, piece.length);
    }
    return axis;
}

PhantomAxis with_straight_ends(const PhantomAxis& axis, double proximal, double distal)
{
    PhantomAxis extended = axis;
    if (proximal > 0.0) {
        CrossSection start = axis.pieces.front().start;
        start.origin -= proximal * start.tangent;
        extended.pieces.insert(extended.pieces.begin(), straight_piece(start, -proximal, proximal));
    }
    if (distal > 0.0) {
        extended.pieces.push_back(
            straight_piece(section_along(axis, axis.length), axis.length, distal));
        extended.length += distal;
    }
    return extended;
}

CrossSection section_along(const AxisPiece& piece, double distance)
{
    CrossSection section = piece.start;
    if (piece.curvature == 0.0) {
        section.origin += distance * piece.start.tangent;
        return section;
    }
    const double angle = piece.curvature * distance;
    const Vec3 turning_axis = piece.start.tangent.cross(piece.towards);
    const Vec3 centre = piece.start.origin + piece.towards / piece.curvature;
    // Turning the whole frame about the bend's own axis does not turn it about the tangent.
    const Eigen::AngleAxisd turn(angle, turning_axis);
    section.origin = centre + turn * (piece.start.origin - centre);
    section.tangent = turn * piece.start.tangent;
    section.normal = turn * piece.start.normal;
    section.binormal = turn * piece.start.binormal;
    return section;
}

CrossSection section_along(const PhantomAxis& axis, double arc_length)
{
    std::size_t i = 0;
    while (i + 1 < axis.pieces.size() && arc_length > axis.pieces[i + 1].arc_length)
        ++i;
    const AxisPiece& piece = axis.pieces[i];
    return section_along(piece, std::clamp(arc_length - piece.arc_length, 0.0, piece.length));
}

double nearest_along(const AxisPiece& piece, const Vec3& point)
{
    const Vec3 offset = point - piece.start.origin;
    const double along = offset.dot(piece.start.tangent);
    if (piece.curvature == 0.0) return std::clamp(along, 0.0, piece.length);

    // Angle about the bend's centre from the start, shifted by whole turns to the nearest end if
    // it falls outside the arc.
    const double radius = 1.0 / piece.curvature;
    const double full_turn = 2.0 * std::numbers::pi;
    const double arc = piece.curvature * piece.length;
    double angle = std::atan2(along, radius - offset.dot(piece.towards));
    if (angle < 0.5 * (arc - full_turn)) angle += full_turn;
    if (angle > 0.5 * (arc + full_turn)) angle -= full_turn;
    return std::clamp(angle, 0.0, arc) * radius;
}

}  // namespace braidzone
