#include "core/line_choice.hpp"

#include "core/error.hpp"
#include "core/line_ends.hpp"
#include "core/line_network.hpp"
#include "core/line_points.hpp"
#include "core/place_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace braidzone {

namespace {

/// The openings that a line joins; -1 for an end elsewhere, or a line that leaves the lumen.
std::pair<int, int> openings_of(const Polyline& line, const Vessel& vessel, const WallTree& wall)
{
    try {
        const TrimmedLine trimmed = trimmed_at_openings(line, vessel, wall);
        return {trimmed.first.opening, trimmed.last.opening};
    } catch (const GeometryError&) {
        return {-1, -1};
    }
}

class Choosing {
public:
    Choosing(const std::vector<Polyline>& lines, const Vessel& vessel, const WallTree& wall)
        : lines_(lines), vessel_(vessel), wall_(wall)
    {
        for (const Polyline& line : lines)
            openings_.push_back(openings_of(line, vessel, wall));
    }

    /// The line with a number.
    Polyline numbered(int number) const
    {
        if (number < static_cast<int>(lines_.size()))
            return lines_[static_cast<std::size_t>(number)];
        throw InputError(fmt::format("vessel.centerline_line = {}; the file has {} lines:{}",
                                     number, lines_.size(), list()));
    }

    /// The line between two openings, in that direction.
    Polyline between(int from, int to) const
    {
        if (auto line = joining(from, to)) return *std::move(line);
        throw ConfigError(
            fmt::format("no centerline of the file runs from opening {} to opening {}; it has:{}",
                        from, to, list()));
    }

    /// The only line that can be meant.
    Polyline only() const
    {
        if (lines_.size() == 1) return lines_.front();
        std::pair<int, int> pair{-1, -1};
        bool is_one_pair = true;
        for (const auto& [from, to] : openings_) {
            if (from < 0 || to < 0 || from == to) continue;
            if (pair.first >= 0 && std::minmax(from, to) != std::minmax(pair.first, pair.second))
                is_one_pair = false;
            if (pair.first < 0) pair = {from, to};
        }
        if (pair.first >= 0 && is_one_pair) return between(pair.first, pair.second);
        if (pair.first < 0 && vessel_.openings.size() == 2) {
            if (auto line = joining(0, 1)) return *std::move(line);
        }
        throw ConfigError(
            fmt::format("the file holds {} lines, so vessel.from and vessel.to (openings) or "
                        "vessel.centerline_line (a number) must tell which of them is meant:{}",
                        lines_.size(), list()));
    }

private:
    std::optional<Polyline> joining(int from, int to) const
    {
        for (std::size_t k = 0; k < lines_.size(); ++k) {
            if (openings_[k] == std::pair(from, to)) return lines_[k];
            if (openings_[k] != std::pair(to, from)) continue;
            return reversed(lines_[k]);
        }
        return along_network(from, to);
    }

    std::optional<Polyline> along_network(int from, int to) const
    {
        const LineNetwork network(lines_);
        const std::vector<int> ends = network.free_ends();
        for (const int first : ends) {
            for (const int last : ends) {
                if (first == last) continue;
                Polyline path = network.path(first, last);
                if (path.points.size() > 1 &&
                    openings_of(path, vessel_, wall_) == std::pair(from, to))
                    return path;
            }
        }
        return std::nullopt;
    }

    std::string end_text(int opening, const Vec3& point) const
    {
        if (opening >= 0) return fmt::format("opening {}", opening);
        return place_text(point, vessel_.unit);
    }

    std::string list() const
    {
        constexpr std::size_t most = 30;
        std::string text;
        for (std::size_t k = 0; k < std::min(lines_.size(), most); ++k) {
            const std::vector<Vec3>& points = lines_[k].points;
            text += fmt::format(
                "\n  {}: from {} to {}, {:.4g} mm", k, end_text(openings_[k].first, points.front()),
                end_text(openings_[k].second, points.back()), 1e3 * length_of(lines_[k]));
        }
        if (lines_.size() > most) text += fmt::format("\n  and {} more", lines_.size() - most);
        return text;
    }

    const std::vector<Polyline>& lines_;
    const Vessel& vessel_;
    const WallTree& wall_;
    std::vector<std::pair<int, int>> openings_;  ///< of each line
};

}  // namespace

ChosenLine chosen_line(const std::vector<Polyline>& lines, const Vessel& vessel,
                       const WallTree& wall, const LineChoice& choice)
{
    const Choosing choosing(lines, vessel, wall);
    ChosenLine chosen;
    if (choice.line >= 0) {
        chosen.line = choosing.numbered(choice.line);
    } else if (choice.from && choice.to) {
        chosen.line = choosing.between(*choice.from, *choice.to);
    } else {
        chosen.line = choosing.only();
    }
    if (choice.reverse) chosen.line = reversed(std::move(chosen.line));
    chosen.num_others = static_cast<int>(lines.size()) - 1;
    return chosen;
}

}  // namespace braidzone
