#pragma once

#include "core/vector.hpp"
#include "export/colour_map.hpp"

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

namespace braidzone {

enum class Align { left, centre, right };

/// A rectangle of a picture [pixels from its top left corner].
struct PictureBox {
    double left = 0.0;
    double top = 0.0;
    double width = 0.0;
    double height = 0.0;

    double right() const { return left + width; }
    double bottom() const { return top + height; }
};

/// A white picture to draw on, by cairo's image surface: needs no display. Lines and text are in
/// dark ink; positions in pixels from the top left corner.
class Canvas {
public:
    Canvas(double width, double height);
    ~Canvas();
    Canvas(const Canvas&) = delete;
    Canvas& operator=(const Canvas&) = delete;

    /// Text at a baseline point.
    /// @param turn  angle by which it is turned, clockwise [rad]
    void text(const std::string& content, const Vec2& at, Align align, double size,
              double turn = 0.0);
    void line(const Vec2& from, const Vec2& to);
    /// The outline of a rectangle.
    void frame(const PictureBox& box);
    /// The outline of a polygon.
    void outline(const std::vector<Vec2>& corners);
    void fill(const std::vector<Vec2>& corners, const Colour& colour);
    void fill(const PictureBox& box, const Colour& colour);
    /// A coloured line through points.
    void curve(const std::vector<Vec2>& points, const Colour& colour, double width);

    /// Until `end_tiles`, drawing is cut off at a box and has no smoothed edges: those of tiles
    /// side by side would let the background shine through.
    void begin_tiles(const PictureBox& box);
    void end_tiles();

    /// Writes the picture as PNG.
    /// @throws IoError if the file cannot be written
    void save(const std::filesystem::path& path) const;

private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace braidzone
