// Builds one composition from the design's parts: tokens, steppers, cards, words, scrims, the ledge. Places
// are given for a left-to-right screen and mirrored here, except as noted. The composer's thread. Lengths are
// u.
#pragma once

#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <unordered_map>

#include "engine/ui/painter.h"
#include "game/screens/page/composition.h"
#include "game/screens/page/design.h"
#include "game/screens/page/icons.h"
#include "game/screens/page/layout.h"
#include "game/screens/page/view.h"
#include "game/screens/pots/turning_pot.h"

namespace onggi::screens {

// Paintings by the hash of their sketch, kept while they are used.
class PaintingStore {
  public:
    // kAllForGood: also keeps unused paintings. kNothing: every painting is empty, for tests of places and
    // words.
    enum class Paints { kAll, kAllForGood, kNothing };

    explicit PaintingStore(ui::Painter& painter, Paints paints = Paints::kAll)
        : painter_(painter),
          paints_(paints) {}
    std::shared_ptr<const ui::Painting> get(const ui::Sketch& sketch, std::uint64_t& key);
    // Returns the painting of a pot.
    std::shared_ptr<const PotPicture> pot(const pot::Section& shape, const finish::GlazeMaterial& glaze,
                                          float px_per_mm, float elevation_rad);
    std::shared_ptr<const TurningPot> turning(const pot::Section& shape, const finish::GlazeMaterial& glaze,
                                              float px_per_mm, float elevation_rad, std::uint64_t& key);
    // Drops paintings that the last compositions did not use; large ones earlier.
    void forget_unused();

  private:
    template <typename T>
    struct Kept {
        std::shared_ptr<const T> value;
        int unused = 0;
    };
    ui::Painter& painter_;
    Paints paints_;
    std::unordered_map<std::uint64_t, Kept<ui::Painting>> paintings_;
    std::unordered_map<std::uint64_t, Kept<PotPicture>> pots_;
    std::unordered_map<std::uint64_t, Kept<TurningPot>> turning_;
};

struct Words {
    std::string text;
    design::Type type = design::kLabel;
    ui::Colour colour = design::kSlip;
    ui::Align align = ui::Align::kStart;
    int language = -1;  // -1: the visitor's
};

// Lines one below the other, scaled together to fit their room.
struct FittedLines {
    std::vector<Words> lines;
    std::vector<float> heights;  // each includes the gap to the next
    float height = 0.0F;
};

// The name of a target, as it is shown, with its key in the tables: from there it is spoken. A name without a
// key is spoken as it is shown.
struct Name {
    Name(std::string text) : shown(std::move(text)) {}
    Name(std::string text, std::string_view of_key) : shown(std::move(text)), key(of_key) {}

    std::string shown;
    std::string key{};
};

// A setting of `most` steps.
struct Steps {
    int most = 0;
    int on = 0;
};

enum class Look { kToken, kPrimary, kOutline };

class Page {
  public:
    Page(const View& view, ui::Painter& painter, PaintingStore& store);

    [[nodiscard]] Shape shape() const { return shape_; }
    [[nodiscard]] bool is_tall() const { return shape_ == Shape::kTall; }
    [[nodiscard]] bool is_square() const { return shape_ == Shape::kSquare; }
    template <typename T>
    [[nodiscard]] T by_shape(const T& wide, const T& square, const T& tall) const {
        return screens::by_shape(shape_, wide, square, tall);
    }
    [[nodiscard]] float width() const { return composition_.bounds.width; }
    [[nodiscard]] float height() const { return composition_.bounds.height; }
    [[nodiscard]] bool right_to_left() const { return language().right_to_left(); }
    [[nodiscard]] const View& view() const { return view_; }
    [[nodiscard]] float text_scale() const { return text_scale_; }
    // Returns the next smaller size of words to try, or the next smaller scale (base 1). The steps do not
    // depend on the start, so that a larger text setting never yields smaller words.
    [[nodiscard]] float smaller(float size, float base) const;
    // Low controls: all targets are in the lower half, for seated or small visitors.
    [[nodiscard]] bool is_low() const { return view_.state.comfort.reach; }
    // The distance between the start of the lower half and that of the design's; 0 without low controls.
    [[nodiscard]] float lower_by() const {
        return is_low() ? 0.5F * (height() - design_size(shape_).y) : 0.0F;
    }
    [[nodiscard]] float px_per_u() const { return composition_.px_per_u; }

    // The visitor's language (-1) or another.
    [[nodiscard]] const kiosk::Language& language(int place = -1) const;
    [[nodiscard]] const std::string& t(std::string_view key) const { return language().shown(key); }
    [[nodiscard]] Name named(std::string_view key) const { return {t(key), key}; }
    [[nodiscard]] std::string t(std::string_view key, std::string_view n) const {
        return language().shown(key, n);
    }
    // Returns the number with the language's digits and decimal sign.
    [[nodiscard]] std::string digits(std::string_view number, int place = -1) const;
    // Returns, for example, "305 mm", as a left-to-right run within a line of any direction.
    [[nodiscard]] std::string measure(std::string_view number, std::string_view unit_key,
                                      int place = -1) const;
    [[nodiscard]] std::string whole_mm(double length_mm, int place = -1) const;

    // Returns the rect mirrored on a right-to-left screen; on_ledge() mirrors for the left hand too.
    [[nodiscard]] ui::Rect mirrored(const ui::Rect& rect) const;
    [[nodiscard]] float mirrored(float x) const { return right_to_left() ? width() - x : x; }
    [[nodiscard]] ui::Rect on_ledge(const ui::Rect& rect) const;

    void covers() { composition_.covers = true; }
    void box(const ui::Rect& rect, const std::array<ui::Colour, 4>& corners);
    // Shades a rect by the colour of each place in u, as a grid of shaded boxes: the software renderer fills
    // them five times as fast as a texture.
    void shade(const ui::Rect& rect, const std::function<ui::Colour(vec2)>& colour_at);
    void down(const ui::Rect& rect, const ui::Colour& top, const ui::Colour& bottom);
    void across(const ui::Rect& rect, const ui::Colour& left, const ui::Colour& right);
    void sprite(const ui::Rect& rect, ui::Sketch sketch, int target = -1);
    // One line of words that the stage places: at least `least_width` wide, with or without a dark chip.
    [[nodiscard]] Item loose_words(const Words& words, float least_width, bool on_chip);
    // Records words that the stage places in each frame, for the audit.
    void keep_loose(Writing writing) { composition_.writings.push_back(std::move(writing)); }
    void keep_guard_words(CueGuard guard, Item words) {
        composition_.has_cue = true;
        composition_.guard_words[static_cast<std::size_t>(guard)] = std::move(words);
    }
    // Allows the stage to show the cue for a touch.
    void allow_cue() { composition_.has_cue = true; }
    void keep_forces(std::shared_ptr<const ForceParts> parts) { composition_.forces = std::move(parts); }
    void picture(const ui::Rect& rect, std::shared_ptr<const ui::Painting> painting, std::uint64_t key);

    // Adds words in a box that is already mirrored. Wraps, and shrinks down to the least size to fit the
    // box. Returns the used height.
    float words(const ui::Rect& rect, const Words& words, bool on_pot = false);
    [[nodiscard]] float words_width(const Words& words);
    // Returns the size of the words, scaled by `scale` and wrapped to `width`.
    [[nodiscard]] ui::TextSize words_size(Words words, float scale, float width);
    // Adds words that ignore the visitor's text size: numbers on cards, the staff's panel.
    float fixed_words(const ui::Rect& rect, const Words& words);
    [[nodiscard]] FittedLines fitted(std::vector<Words> lines, vec2 room, float between = 0.0F);
    void fitted_words(const ui::Rect& rect, const FittedLines& fitted);

    // Buttons. `rect` is already mirrored.
    int token(const ui::Rect& rect, Look look, kiosk::Button button, const Name& name, int value = 0,
              std::optional<Icon> icon = {}, bool with_words = true, bool repeats = false);
    void back_token(const ui::Rect& rect, kiosk::Button button = kiosk::Button::kBack) {
        token(rect, Look::kOutline, button, named("ctl.back"), 0,
              right_to_left() ? Icon::kRight : Icon::kLeft);
    }
    // Draws dots along the line through these points, cream over dark.
    void dotted(std::span<const vec2> points);
    // Without `less` the stepper is visible but disabled.
    void stepper(const ui::Rect& rect, Icon icon, const Steps& steps, kiosk::Button less, kiosk::Button more,
                 const Name& name, bool reversed);
    void label(const ui::Rect& rect, const std::string& text, const ui::Colour& colour = design::kSlip);
    void card(const ui::Rect& rect, const ui::Colour& top, const ui::Colour& bottom, int target = -1);
    int card_target(const ui::Rect& rect, bool celadon, kiosk::Button button, int value, const Name& name);
    // Adds a dark niche; a chosen one has the colour of paper.
    int card_niche(const ui::Rect& rect, bool chosen, kiosk::Button button, int value, const Name& name);
    // Adds the button for the choice of languages; with low controls at `low`, a place on a left-to-right
    // screen. Returns its place.
    ui::Rect languages_token(const ui::Rect& low);
    void look_in_token(const ui::Rect& languages);
    // Darkens the picture beyond the photographed room, with a soft edge.
    void scene_ends();
    // Adds a language by its own name and script.
    void language_token(const ui::Rect& rect, int place, bool chosen);
    void toggle(const ui::Rect& rect, Icon icon, bool on, kiosk::Button button, const Name& name);
    // Adds a target without a picture; the caller draws it.
    int plain_target(const ui::Rect& rect, kiosk::Button button, int value, const Name& name) {
        return add_target(rect, button, value, name, false);
    }
    // Adds to what is said of the newest target: that it is chosen.
    void say_chosen();
    // Adds to what is said of the newest target.
    void say_more(const std::string& words) { composition_.targets.back().spoken += " " + words; }
    // What a staff's panel says beside its buttons, in English.
    void tell(std::string words) { composition_.told.push_back(std::move(words)); }
    // The index of English among the languages, or 0 if it is missing.
    [[nodiscard]] int english() const;

    // Draw the museum's wall in the evening with a pool of light, and the shelf.
    void museum(vec2 light, vec2 reach, float strength);
    void shelf(float top, float thickness);
    void pot_shadow(float centre_x, float y, float radius, float height);
    // Adds a pot with its foot at `foot`, at `u_per_mm`. Returns the rect that it covers.
    ui::Rect pot(const pot::Section& shape, const finish::GlazeMaterial& glaze, float u_per_mm, vec2 foot,
                 float brightness = 1.0F);
    // The same for a turning pot.
    ui::Rect turning_pot(const pot::Section& shape, const finish::GlazeMaterial& glaze, float u_per_mm,
                         vec2 foot);
    void ledge(float y);

    // Makes the newest target react to touches in this rect of the picture too.
    void also_touched_at(const ui::Rect& rect) { composition_.targets.back().also = rect; }
    // What `add` adds appears by this motion.
    template <typename Add>
    void moving(const Motion& motion, Add&& add) {
        const std::size_t first = composition_.items.size();
        std::forward<Add>(add)();
        for (std::size_t i = first; i < composition_.items.size(); ++i)
            composition_.items[i].motion = motion;
    }
    void keep_clear(const ui::Rect& pot) { composition_.pots.push_back(pot); }
    [[nodiscard]] Composition take();

  private:
    // Adds the shadow of a pot; returns the rect of its picture.
    ui::Rect stand(const pot::Section& shape, float u_per_mm, vec2 foot);
    [[nodiscard]] ui::TextStyle style(const Words& words) const;
    void name_ring(const ui::Rect& ring, const std::string& name);
    int add_target(const ui::Rect& rect, kiosk::Button button, int value, const Name& name, bool repeats);
    void token_body(ui::Sketch& sketch, const ui::Rect& rect, Look look, bool pressed) const;

    const View& view_;
    ui::Painter& painter_;
    PaintingStore& store_;
    Composition composition_;
    Shape shape_ = Shape::kWide;
    float text_scale_ = 1.0F;
    float legible_scale_ = 1.0F;  // the factor of text_scale_ that serves the distance
};

}  // namespace onggi::screens
