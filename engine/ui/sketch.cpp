#include "engine/ui/sketch.h"

#include "engine/core/hash.h"

namespace onggi::ui {
namespace {

class SketchHash {
  public:
    void add(float value) { hash_.add(double{value}); }
    void add(bool value) { hash_.add_word(value ? 1 : 0); }
    void add(const std::string& text) { hash_.add_bytes(std::as_bytes(std::span(text))); }
    void add(vec2 value) { add(value.x), add(value.y); }
    void add(const Colour& colour) { add(colour.r), add(colour.g), add(colour.b), add(colour.a); }
    void add(const std::optional<Colour>& colour) {
        add(colour.has_value());
        if (colour) add(*colour);
    }
    void add(const Rect& rect) { add(rect.x), add(rect.y), add(rect.width), add(rect.height); }
    void add(const Fill& fill) {
        hash_.add_word(static_cast<std::uint64_t>(fill.kind));
        add(fill.from), add(fill.to);
    }
    void add(const Placing& placing) { add(placing.at), add(placing.scale), add(placing.turn_rad); }
    void add(const TextStyle& style) {
        add(style.family), add(style.bold), add(style.size), add(style.line_height), add(style.colour);
        hash_.add_word(static_cast<std::uint64_t>(style.align));
        add(style.right_to_left), add(style.language);
    }

    void operator()(const Box& box) { add(box.rect), add(box.radius), add(box.fill); }
    void operator()(const Frame& frame) {
        add(frame.rect), add(frame.radius), add(frame.width), add(frame.colour);
    }
    void operator()(const Shadow& shadow) {
        add(shadow.rect), add(shadow.radius), add(shadow.blur), add(shadow.colour);
    }
    void operator()(const Ellipse& ellipse) { add(ellipse.rect), add(ellipse.fill); }
    void operator()(const Shape& shape) {
        add(shape.path), add(shape.placing), add(shape.fill), add(shape.stroke), add(shape.stroke_width);
        add(shape.dash);
    }
    void operator()(const Writing& writing) {
        add(writing.at), add(writing.text.words), add(writing.text.style), add(writing.text.width);
        add(writing.box_width);
    }
    void operator()(const Picture& picture) {
        hash_.add_word(picture.hash);
        add(picture.rect), add(picture.brightness);
    }

    void add_kind(std::size_t kind) { hash_.add_word(kind); }
    [[nodiscard]] std::uint64_t value() const { return hash_.value(); }

  private:
    StateHash hash_;
};

}  // namespace

std::uint64_t Sketch::hash() const {
    SketchHash hash;
    hash.add(size), hash.add(px_per_u), hash.add(fade.has_value());
    if (fade) hash.add(fade->whole), hash.add(fade->gone);
    for (const SketchItem& item : items) {
        hash.add_kind(item.index());
        std::visit(hash, item);
    }
    return hash.value();
}

}  // namespace onggi::ui
