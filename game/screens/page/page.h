// Builds one composition out of the design's parts: tokens, steppers, cards, words, scrims, the ledge.
// Places are given for a left-to-right screen and mirrored here; what must not mirror says so. The composer's
// thread. Lengths are u.
#pragma once

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
    // kAllForGood: what is no longer used stays too. kNothing: every painting is empty, and only places and
    // words count.
    enum class Paints { kAll, kAllForGood, kNothing };

    explicit PaintingStore(ui::Painter& painter, Paints paints = Paints::kAll)
        : painter_(painter),
          paints_(paints) {}
    std::shared_ptr<const ui::Painting> get(const ui::Sketch& sketch, std::uint64_t& key);
    // A painting that is made otherwise: pots.
    std::shared_ptr<const PotPicture> pot(const pot::Section& shape, const finish::GlazeMaterial& glaze,
                                          float px_per_mm, float elevation_rad);
    std::shared_ptr<const TurningPot> turning(const pot::Section& shape, const finish::GlazeMaterial& glaze,
                                              float px_per_mm, float elevation_rad, std::uint64_t& key);
    // What was not asked for during the last few compositions goes, earlier where it is much.
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
    int language = -1;  // another than the visitor's
};

// Lines one below the other, all as large as their room bears, not the first at the cost of the last.
struct FittedLines {
    std::vector<Words> lines;
    std::vector<float> heights;  // each with what lies between it and the next
    float height = 0.0F;
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
    // The next smaller size to try for words, or the next smaller of their scale (base 1). The same steps
    // whatever it begins with, so that nobody gets smaller words by asking for larger ones.
    [[nodiscard]] float smaller(float size, float base) const;
    // All that can be pressed stands in the lower half, for who sits or is small.
    [[nodiscard]] bool is_low() const { return view_.state.comfort.reach; }
    // So much further down the lower half begins than in the design; 0 where nothing is brought low.
    [[nodiscard]] float lower_by() const {
        return is_low() ? 0.5F * (height() - design_size(shape_).y) : 0.0F;
    }
    [[nodiscard]] float px_per_u() const { return composition_.px_per_u; }

    // Words of the visitor's language, or of another.
    [[nodiscard]] const kiosk::Language& language(int place = -1) const;
    [[nodiscard]] const std::string& t(std::string_view key) const { return language().shown(key); }
    [[nodiscard]] std::string t(std::string_view key, std::string_view n) const {
        return language().shown(key, n);
    }
    // In the digits of the language; an Arabic decimal sign too.
    [[nodiscard]] std::string digits(std::string_view number, int place = -1) const;
    // "305 mm", as a left-to-right piece inside whatever line.
    [[nodiscard]] std::string measure(std::string_view number, std::string_view unit_key,
                                      int place = -1) const;
    [[nodiscard]] std::string whole_mm(double length_mm, int place = -1) const;

    // The rect mirrored when the screen is (ledge: also by left hand).
    [[nodiscard]] ui::Rect mirrored(const ui::Rect& rect) const;
    [[nodiscard]] float mirrored(float x) const { return right_to_left() ? width() - x : x; }
    [[nodiscard]] ui::Rect on_ledge(const ui::Rect& rect) const;

    void covers() { composition_.covers = true; }
    void box(const ui::Rect& rect, const std::array<ui::Colour, 4>& corners);
    void down(const ui::Rect& rect, const ui::Colour& top, const ui::Colour& bottom);
    void across(const ui::Rect& rect, const ui::Colour& left, const ui::Colour& right);
    void sprite(const ui::Rect& rect, ui::Sketch sketch, int target = -1);
    // One line that the stage places itself: at least so wide, on a dark chip or on nothing.
    [[nodiscard]] Item loose_words(const Words& words, float least_width, bool on_chip);
    // Words that the stage sets there from frame to frame: what a test must know of them.
    void keep_loose(Writing writing) { composition_.writings.push_back(std::move(writing)); }
    void keep_guard_words(CueGuard guard, Item words) {
        composition_.has_cue = true;
        composition_.guard_words[static_cast<std::size_t>(guard)] = std::move(words);
    }
    // Where the pot may be touched, the stage may say so.
    void allow_cue() { composition_.has_cue = true; }
    void keep_forces(std::shared_ptr<const ForceParts> parts) { composition_.forces = std::move(parts); }
    void picture(const ui::Rect& rect, std::shared_ptr<const ui::Painting> painting, std::uint64_t key);

    // Words in a box that is already where it should be. Wraps; shrinks to its least size before it would
    // leave the box. Gives the height it took.
    float words(const ui::Rect& rect, const Words& words, bool on_pot = false);
    [[nodiscard]] float words_width(const Words& words);
    // As they would wrap in that width, so many times as large.
    [[nodiscard]] ui::TextSize words_size(Words words, float scale, float width);
    // Words that keep their size whatever the visitor's: numbers on cards, the staff's panel.
    float fixed_words(const ui::Rect& rect, const Words& words);
    [[nodiscard]] FittedLines fitted(std::vector<Words> lines, vec2 room, float between = 0.0F);
    void fitted_words(const ui::Rect& rect, const FittedLines& fitted);

    // Buttons. `rect` is final.
    int token(const ui::Rect& rect, Look look, kiosk::Button button, std::string_view name, int value = 0,
              std::optional<Icon> icon = {}, bool with_words = true, bool repeats = false);
    void back_token(const ui::Rect& rect, kiosk::Button button = kiosk::Button::kBack) {
        token(rect, Look::kOutline, button, t("ctl.back"), 0, right_to_left() ? Icon::kRight : Icon::kLeft);
    }
    // Dots along a line that joins those places, cream over dark.
    void dotted(std::span<const vec2> points);
    // No `less`: it rests, to be seen and not to be pressed.
    void stepper(const ui::Rect& rect, Icon icon, int dots, int on, kiosk::Button less, kiosk::Button more,
                 const std::string& name, bool reversed);
    void label(const ui::Rect& rect, const std::string& text, const ui::Colour& colour = design::kSlip);
    void card(const ui::Rect& rect, const ui::Colour& top, const ui::Colour& bottom, int target = -1);
    int card_target(const ui::Rect& rect, bool celadon, kiosk::Button button, int value,
                    const std::string& name);
    // A dark niche, or a paper one where it is chosen.
    int card_niche(const ui::Rect& rect, bool chosen, kiosk::Button button, int value,
                   const std::string& name);
    // Opens the choice of languages; with low controls it stands at `low` (of a left-to-right screen). Gives
    // where it is.
    ui::Rect languages_token(const ui::Rect& low);
    void look_in_token(const ui::Rect& languages);
    // Dark where the photographed room ends, and a soft edge to it.
    void scene_ends();
    // A language by its own name, in its own letters.
    void language_token(const ui::Rect& rect, int place, bool chosen);
    void toggle(const ui::Rect& rect, Icon icon, bool on, kiosk::Button button, const std::string& name);
    // A target whose looks are the caller's.
    int plain_target(const ui::Rect& rect, kiosk::Button button, int value, const std::string& name) {
        return add_target(rect, button, value, name, false);
    }
    // Where English is among the languages; else the first.
    [[nodiscard]] int english() const;

    // The wall of the evening museum, its pool of light about a place, and the shelf.
    void museum(vec2 light, vec2 reach, float strength);
    void shelf(float top, float thickness);
    void pot_shadow(float centre_x, float y, float radius, float height);
    // A pot standing at a place at so many px a mm of the design; gives the rect it covers.
    ui::Rect pot(const pot::Section& shape, const finish::GlazeMaterial& glaze, float u_per_mm, vec2 foot,
                 float brightness = 1.0F);
    // As pot(), and it turns.
    ui::Rect turning_pot(const pot::Section& shape, const finish::GlazeMaterial& glaze, float u_per_mm,
                         vec2 foot);
    void ledge(float y);

    // Touching this place of the picture presses the newest target too.
    void also_touched_at(const ui::Rect& rect) { composition_.targets.back().also = rect; }
    void keep_clear(const ui::Rect& pot) { composition_.pots.push_back(pot); }
    [[nodiscard]] Composition take();

  private:
    // The shadow of a pot, and the rect that its picture covers.
    ui::Rect stand(const pot::Section& shape, float u_per_mm, vec2 foot);
    [[nodiscard]] ui::TextStyle style(const Words& words) const;
    void name_ring(const ui::Rect& ring, const std::string& name);
    int add_target(const ui::Rect& rect, kiosk::Button button, int value, std::string name, bool repeats);
    void token_body(ui::Sketch& sketch, const ui::Rect& rect, Look look, bool pressed) const;

    const View& view_;
    ui::Painter& painter_;
    PaintingStore& store_;
    Composition composition_;
    Shape shape_ = Shape::kWide;
    float text_scale_ = 1.0F;
    float legible_scale_ = 1.0F;  // of it, what the distance asks for
};

}  // namespace onggi::screens
