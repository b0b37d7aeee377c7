#include "export/canvas.hpp"

#include "core/error.hpp"

#include <cairo.h>
#include <fmt/format.h>

#include <cmath>

namespace braidzone {

namespace {

struct DestroySurface {
    void operator()(cairo_surface_t* surface) const { cairo_surface_destroy(surface); }
};
struct DestroyContext {
    void operator()(cairo_t* context) const { cairo_destroy(context); }
};

constexpr Colour ink{0.13, 0.13, 0.13};

}  // namespace

struct Canvas::Impl {
    std::unique_ptr<cairo_surface_t, DestroySurface> surface;
    std::unique_ptr<cairo_t, DestroyContext> context;

    void set_colour(const Colour& colour) const
    {
        cairo_set_source_rgb(context.get(), colour[0], colour[1], colour[2]);
    }

    /// Starts a path through points. (Text leaves a point behind from which a path would go on.)
    void trace(const std::vector<Vec2>& points) const
    {
        cairo_new_path(context.get());
        for (const Vec2& point : points)
            cairo_line_to(context.get(), point[0], point[1]);
    }

    void trace(const PictureBox& box) const
    {
        cairo_new_path(context.get());
        cairo_rectangle(context.get(), box.left, box.top, box.width, box.height);
    }
};

Canvas::Canvas(double width, double height) : impl_(std::make_unique<Impl>())
{
    impl_->surface.reset(cairo_image_surface_create(CAIRO_FORMAT_RGB24,
                                                    static_cast<int>(std::lround(width)),
                                                    static_cast<int>(std::lround(height))));
    impl_->context.reset(cairo_create(impl_->surface.get()));
    impl_->set_colour({1.0, 1.0, 1.0});
    cairo_paint(impl_->context.get());
    cairo_select_font_face(impl_->context.get(), "DejaVu Sans", CAIRO_FONT_SLANT_NORMAL,
                           CAIRO_FONT_WEIGHT_NORMAL);
    cairo_set_line_width(impl_->context.get(), 1.5);
}

Canvas::~Canvas() = default;

void Canvas::text(const std::string& content, const Vec2& at, Align align, double size, double turn)
{
    cairo_t* context = impl_->context.get();
    cairo_save(context);
    cairo_translate(context, at[0], at[1]);
    cairo_rotate(context, turn);
    cairo_set_font_size(context, size);
    cairo_text_extents_t extents;
    cairo_text_extents(context, content.c_str(), &extents);
    const double shift = align == Align::left     ? 0.0
                         : align == Align::centre ? 0.5 * extents.x_advance
                                                  : extents.x_advance;
    impl_->set_colour(ink);
    cairo_move_to(context, -shift, 0.0);
    cairo_show_text(context, content.c_str());
    cairo_restore(context);
}

void Canvas::line(const Vec2& from, const Vec2& to)
{
    impl_->set_colour(ink);
    impl_->trace({from, to});
    cairo_stroke(impl_->context.get());
}

void Canvas::frame(const PictureBox& box)
{
    impl_->set_colour(ink);
    impl_->trace(box);
    cairo_stroke(impl_->context.get());
}

void Canvas::outline(const std::vector<Vec2>& corners)
{
    impl_->set_colour(ink);
    impl_->trace(corners);
    cairo_close_path(impl_->context.get());
    cairo_stroke(impl_->context.get());
}

void Canvas::fill(const std::vector<Vec2>& corners, const Colour& colour)
{
    impl_->set_colour(colour);
    impl_->trace(corners);
    cairo_close_path(impl_->context.get());
    cairo_fill(impl_->context.get());
}

void Canvas::fill(const PictureBox& box, const Colour& colour)
{
    impl_->set_colour(colour);
    impl_->trace(box);
    cairo_fill(impl_->context.get());
}

void Canvas::curve(const std::vector<Vec2>& points, const Colour& colour, double width)
{
    cairo_save(impl_->context.get());
    impl_->set_colour(colour);
    cairo_set_line_width(impl_->context.get(), width);
    impl_->trace(points);
    cairo_stroke(impl_->context.get());
    cairo_restore(impl_->context.get());
}

void Canvas::begin_tiles(const PictureBox& box)
{
    cairo_save(impl_->context.get());
    impl_->trace(box);
    cairo_clip(impl_->context.get());
    cairo_set_antialias(impl_->context.get(), CAIRO_ANTIALIAS_NONE);
}

void Canvas::end_tiles()
{
    cairo_restore(impl_->context.get());
}

void Canvas::save(const std::filesystem::path& path) const
{
    cairo_surface_flush(impl_->surface.get());
    const cairo_status_t status =
        cairo_surface_write_to_png(impl_->surface.get(), path.string().c_str());
    if (status != CAIRO_STATUS_SUCCESS) {
        throw IoError(fmt::format("{}: cannot be written: {}", path.string(),
                                  cairo_status_to_string(status)));
    }
}

}  // namespace braidzone
