#include "core/line_ends.hpp"

#include "core/error.hpp"
#include "core/line_points.hpp"
#include "core/place_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

namespace braidzone {

namespace {

/// Below this share of the distance to the wall an end counts as lying on the opening.
constexpr double negligible = 0.01;

/// A place on a line: within segment `segment`, at a fraction of it.
struct PlaceOnLine {
    std::size_t segment = 0;
    double fraction = 0.0;
};

Vec3 point_at(const Polyline& line, const PlaceOnLine& place)
{
    const Vec3& start = line.points[place.segment];
    return start + place.fraction * (line.points[place.segment + 1] - start);
}

/// The opening whose cap a point lies on.
int opening_at_cap(const Vec3& point, const std::vector<Opening>& openings)
{
    int nearest = -1;
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t k = 0; k < openings.size(); ++k) {
        const Vec3 offset = point - openings[k].centre;
        const double across = std::abs(offset.dot(openings[k].normal)) / openings[k].radius;
        // An oval opening reaches farther than its mean radius.
        if (offset.norm() > 3.0 * openings[k].radius || across >= least) continue;
        least = across;
        nearest = static_cast<int>(k);
    }
    return nearest;
}

int opening_near(const Vec3& point, const std::vector<Opening>& openings)
{
    constexpr double most_radii = 3.0;
    int nearest = -1;
    double least = most_radii;
    for (std::size_t k = 0; k < openings.size(); ++k) {
        const double radii = (point - openings[k].centre).norm() / openings[k].radius;
        if (!(radii < least)) continue;
        least = radii;
        nearest = static_cast<int>(k);
    }
    return nearest;
}

class Trimming {
public:
    Trimming(const Polyline& line, const Vessel& vessel, const WallTree& wall)
        : line_(line), vessel_(vessel), wall_(wall)
    {
    }

    TrimmedLine result() &&
    {
        TrimmedLine trimmed;
        trimmed.first = trim_front();
        const std::size_t num_before = num_dropped_;
        line_ = reversed(std::move(line_));
        trimmed.last = trim_front();
        line_ = reversed(std::move(line_));
        require_inside(num_before);
        trimmed.line = std::move(line_);
        return trimmed;
    }

private:
    std::string place(const Vec3& point) const { return place_text(point, vessel_.unit); }

    LineEnd trim_front()
    {
        if (wall_.contains(line_.points.front()))
            return {opening_near(line_.points.front(), vessel_.openings), 0.0};
        const PlaceOnLine entry = entry_into_lumen();
        const Vec3 point = point_at(line_, entry);
        const int opening = opening_at_cap(point, vessel_.openings);
        double length = (point - line_.points[entry.segment]).norm();
        for (std::size_t i = 0; i < entry.segment; ++i)
            length += (line_.points[i + 1] - line_.points[i]).norm();
        const double radius = wall_.nearest(point).distance;
        if (length <= negligible * radius) return {opening, 0.0};
        cut_front(entry, radius);
        return {opening, length};
    }

    /// Where the line first comes into the lumen from beyond an opening.
    PlaceOnLine entry_into_lumen() const
    {
        constexpr int num_samples = 32;  // of a segment
        PlaceOnLine outside;
        for (std::size_t i = 0; i + 1 < line_.points.size(); ++i) {
            for (int k = 1; k <= num_samples; ++k) {
                const PlaceOnLine next{i, static_cast<double>(k) / num_samples};
                if (wall_.contains(point_at(line_, next))) {
                    if (outside.segment < i) outside = {i, 0.0};
                    return refined({i, outside.fraction}, next);
                }
                outside = next;
            }
        }
        throw GeometryError(
            fmt::format("nothing of the centerline, from {} to {}, lies in the "
                        "lumen",
                        place(line_.points.front()), place(line_.points.back())));
    }

    PlaceOnLine refined(PlaceOnLine outside, PlaceOnLine inside) const
    {
        if (const auto hit = wall_.first_hit(point_at(line_, inside), point_at(line_, outside))) {
            throw GeometryError(fmt::format(
                "the centerline comes into the lumen through the wall, at {}; outside the lumen it "
                "may lie beyond the openings only",
                place(hit->point)));
        }
        constexpr int num_halvings = 40;  // to 1e-12 of the segment
        for (int k = 0; k < num_halvings; ++k) {
            const PlaceOnLine middle{inside.segment, 0.5 * (inside.fraction + outside.fraction)};
            (wall_.contains(point_at(line_, middle)) ? inside : outside) = middle;
        }
        return inside;
    }

    void cut_front(const PlaceOnLine& entry, double radius)
    {
        const Vec3 point = point_at(line_, entry);
        std::size_t num_gone = entry.segment;  // the point after them becomes the entry
        // A point that is next to the entry would only make the line rough.
        constexpr double too_near = 0.05;
        const bool is_near = (line_.points[num_gone + 1] - point).norm() < too_near * radius &&
                             num_gone + 2 < line_.points.size();
        if (!line_.inscribed_radii.empty()) {
            const double first = line_.inscribed_radii[entry.segment];
            const double second = line_.inscribed_radii[entry.segment + 1];
            const double there = first + entry.fraction * (second - first);
            line_.inscribed_radii[num_gone + (is_near ? 1 : 0)] = there;
        }
        if (is_near) ++num_gone;
        line_.points[num_gone] = point;
        const auto drop = [&](auto& values) {
            if (values.empty()) return;
            values.erase(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(num_gone));
        };
        drop(line_.points);
        drop(line_.inscribed_radii);
        num_dropped_ += num_gone;
    }

    void require_inside(std::size_t num_before) const
    {
        std::size_t num_outside = 0, first = 0;
        for (std::size_t i = 1; i + 1 < line_.points.size(); ++i) {
            if (wall_.contains(line_.points[i])) continue;
            if (num_outside == 0) first = i;
            ++num_outside;
        }
        if (num_outside == 0) return;
        throw GeometryError(fmt::format(
            "{} of the centerline's {} points lie outside the lumen; the first is point {} at {}",
            num_outside, line_.points.size() + num_dropped_, first + num_before,
            place(line_.points[first])));
    }

    Polyline line_;
    const Vessel& vessel_;
    const WallTree& wall_;
    std::size_t num_dropped_ = 0;
};

}  // namespace

TrimmedLine trimmed_at_openings(const Polyline& line, const Vessel& vessel, const WallTree& wall)
{
    return Trimming(line, vessel, wall).result();
}

}  // namespace braidzone
