#include "tests/golden/golden_scenes.h"

#include <algorithm>
#include <cmath>

#include "engine/core/hash.h"
#include "game/wheel/clay_look.h"

namespace onggi::golden {
namespace {

constexpr int kElements = 2000;
constexpr double kHeightMm = 200.0;

// The paper's clay, by height above the wheel head.
template <typename Outline>
pot::Pot paper_pot(Outline outline) {
    pot::Pot pot{.height_mm = kHeightMm};
    for (int i = 0; i < kElements; ++i)
        pot.outer_mm.push_back(static_cast<float>(outline((i + 0.5) * kHeightMm / kElements)));
    return pot;
}

// The same with another clay body or stage.
pot::Pot pot_of(const StudioShape& shape, clay::ClayBody body, clay::Firing stage = clay::Firing::kWet) {
    pot::Pot pot = studio_pot(shape);
    pot.body = body;
    pot.stage = stage;
    return pot;
}

double finer_rings(double y) {
    return 0.35 * std::sin(y * 0.78 + 2.3 * std::sin(y * 0.026));
}

double vase(double y) {
    return 30.0 + 26.0 * bump(y, 70.0, 52.0) + 12.0 * bump(y, 205.0, 26.0) + finer_rings(y);
}

// A sphere of 16 mm pressed 9 mm deep into a straight wall, and its trace higher up.
double pressed(double y) {
    const double off = y - 95.0;
    const double dent = std::abs(off) < 16.0 ? 60.0 - 9.0 + 16.0 - std::sqrt(16.0 * 16.0 - off * off) : 60.0;
    return std::min({60.0, dent, 60.0 - 5.0 * bump(y, 150.0, 20.0)});
}

// Ledges, where outline and rings have corners.
double stepped(double y) {
    return y < 40.0 ? 60.0 : (y < 90.0 ? 38.0 : (y < 130.0 ? 52.0 : 24.0));
}

// A pot with strokes on it, raw or under a glaze.
GoldenScene drawn_pot(const char* name, const StudioShape& shape, const char* glaze,
                      const decoration::Strokes& strokes) {
    const clay::Firing stage = glaze != nullptr ? clay::Firing::kGlaze : clay::Firing::kDry;
    GoldenScene scene{
        .name = name, .pot = pot_of(shape, clay::ClayBody::kStoneware, stage), .tool_shown = false};
    DrawnPot drawn;
    const finish::GlazeMaterial* const worn = glaze != nullptr ? finish::find_glaze(glaze) : nullptr;
    if (worn != nullptr)
        drawn.material = look::glazed_lathe(wheel::clay_material(scene.pot.body, stage), *worn);
    const decoration::Marks marks{decoration::wall_of(pot::outer_outline(scene.pot)), {strokes, 0}};
    drawn.marks.dress(decoration::texture_of(marks), marks.wall,
                      (worn != nullptr ? *worn : finish::wet_clay()).marks);
    scene.drawn = std::make_shared<const DrawnPot>(std::move(drawn));
    return scene;
}

// Each drawing technique, each under another glaze; the front is at three quarters of a turn.
std::vector<GoldenScene> drawn_scenes() {
    using decoration::Motif;
    using decoration::Technique;
    const auto point = [](double turns, double height_mm) {
        return decoration::stroke_point(turns, height_mm).value();
    };
    const auto round = [&](Technique technique, double height_mm, std::uint16_t width, double swing_mm) {
        decoration::Stroke stroke{.technique = technique, .width = width};
        for (int i = 0; i <= 192; ++i)
            stroke.points.push_back(point(i / 192.0, height_mm + swing_mm * std::sin(i * 0.19634954)));
        return stroke;
    };
    const auto motif = [&](Motif which, double turns, double height_mm, std::uint16_t size,
                           std::uint8_t repeats) {
        return decoration::Stroke{.technique = Technique::kMotif,
                                  .motif = which,
                                  .repeats = repeats,
                                  .width = size,
                                  .points = {point(turns, height_mm)}};
    };
    decoration::Stroke black = round(Technique::kInlay, 150.0, 250, 0.0);
    black.slip = decoration::Slip::kBlack;
    return {drawn_pot("drawn-celadon", jar(), "celadon",
                      {motif(Motif::kCrane, 0.73, 95.0, 6500, 4), motif(Motif::kCloud, 0.86, 120.0, 3600, 4),
                       round(Technique::kInlay, 156.0, 200, 0.0), black}),
            drawn_pot("drawn-porcelain", jar(), "porcelain",
                      {round(Technique::kCobalt, 150.0, 400, 0.0), round(Technique::kCobalt, 90.0, 500, 22.0),
                       round(Technique::kCobalt, 30.0, 250, 0.0)}),
            drawn_pot(
                "drawn-buncheong", bowl(), "buncheong",
                {round(Technique::kBrushedSlip, 45.0, 5200, 0.0), motif(Motif::kFish, 0.76, 46.0, 4200, 4)}),
            drawn_pot("drawn-iron", jar(), "iron", {round(Technique::kFinger, 92.0, 2600, 18.0)}),
            drawn_pot("drawn-ash", jar(), "ash",
                      {motif(Motif::kGrass, 0.75, 85.0, 9000, 3), round(Technique::kIron, 150.0, 500, 0.0)}),
            drawn_pot("drawn-dry", jar(), nullptr,
                      {motif(Motif::kWave, 0.75, 62.0, 6000, 8),
                       motif(Motif::kChrysanthemum, 0.76, 118.0, 4500, 5)})};
}

}  // namespace

haptic::Snapshot GoldenScene::shown(wheel::WheelScene& scene) const {
    const wheel::DrawnHand hand{.position_mm = tool_position_mm,
                                .radius_mm = tool_radius_mm,
                                .tool = tool,
                                .side = side.value_or(tool::Side::kOut),
                                .shown = tool_shown,
                                .touching = contacts > 0};
    wheel::DrawnHand second{.shown = false, .is_second = true};
    if (second_hand_mm) {
        second = {.position_mm = *second_hand_mm,
                  .radius_mm = tool_radius_mm,
                  .side = tool::Side::kIn,
                  .touching = contacts > 0,
                  .is_second = true};
    }
    scene.lead_hands(std::array{hand, second});
    ecs::Entity on_wheel;
    scene.registry().each<wheel::PotApart, wheel::OnWheel>(
        [&](ecs::Entity entity, const wheel::PotApart&, const wheel::OnWheel&) { on_wheel = entity; });
    if (drawn) {
        scene.put_on_wheel(on_wheel, {.pot = &pot,
                                      .material = drawn->material ? &*drawn->material : nullptr,
                                      .marks = &drawn->marks.marks()});
    } else {
        scene.registry().destroy(on_wheel);
    }
    haptic::Snapshot shown{.wheel_direction = wheel_direction, .pot = &pot};
    if (wire_height_mm) {
        shown.tool.wire = tool::Wire::kCutRim;
        shown.tool.wire_height_mm = *wire_height_mm;
    }
    return shown;
}

Result<asset::Image> GoldenScene::drawn_alone(int width_px, int height_px,
                                              const wheel::StillOptions& options) const {
    auto camera = wheel::StillCamera::create(width_px, height_px, options);
    if (!camera) return camera.error();
    auto image = (*camera)->take(shown((*camera)->scene()), view);
    if (auto closed = (*camera)->close(); image && !closed) return closed.error();
    return image;
}

std::uint64_t GoldenScene::hash() const {
    StateHash hash;
    const auto add = [&](const std::vector<float>& column) { hash.add(std::span<const float>(column)); };
    add(pot.outer_mm);
    add(pot.inner_mm);
    add(pot.top_mm);
    for (const vec2& centre : pot.centre_mm)
        add({centre.x, centre.y});
    add(pot.dents_mm);
    add(pot.film);
    add(pot.liquidity);
    add(pot.load_index);
    const dvec3 second = second_hand_mm.value_or(dvec3(0.0));
    for (const double value : {tool_position_mm.x, tool_position_mm.y, tool_position_mm.z, tool_radius_mm,
                               second.x, second.y, second.z, wheel_direction.x, wheel_direction.y,
                               static_cast<double>(pot.body), static_cast<double>(pot.stage),
                               static_cast<double>(view), static_cast<double>(tool), tool_shown ? 1.0 : 0.0})
        hash.add(value);
    if (side) hash.add(static_cast<double>(*side));
    if (wire_height_mm) hash.add(*wire_height_mm);
    if (drawn) hash.add_bytes(std::as_bytes(std::span(drawn->marks.marks().texels)));
    return hash.value();
}

GoldenScene scene_named(std::string_view name) {
    for (const GoldenScene& scene : golden_scenes()) {
        if (scene.name == name) return scene;
    }
    return {};
}

std::string test_name(const GoldenScene& scene) {
    std::string name = scene.name;
    std::replace(name.begin(), name.end(), '-', '_');
    return name;
}

namespace {

using clay::ClayBody;
using clay::Firing;
using tool::Side;
using wheel::StillView;

// The paper's clay: solid.
std::vector<GoldenScene> paper_scenes() {
    return {
        {.name = "fresh-lump", .pot = paper_pot([](double) { return 60.0; })},
        {.name = "vase", .pot = paper_pot(vase), .wheel_direction = {0.6, 0.8}},
        {.name = "stepped",
         .pot = paper_pot(stepped),
         .tool_position_mm = {-95.0, 40.0, 0.0},
         .tool_radius_mm = 40.0},
        {.name = "tool-pressing",
         .pot = paper_pot(pressed),
         .tool_position_mm = {67.0, 95.0, 0.0},
         .tool_radius_mm = 16.0,
         .contacts = 320},
    };
}

// Three bodies, wet, dry, bisque and glazed.
std::vector<GoldenScene> body_scenes() {
    StudioShape dry_jar = jar();
    dry_jar.liquidity = dry_jar.film = 0.0;
    return {
        {.name = "stoneware-wet", .pot = studio_pot(jar()), .tool_shown = false},
        {.name = "porcelain-wet", .pot = pot_of(bottle(), ClayBody::kPorcelain), .tool_shown = false},
        {.name = "earthenware-wet", .pot = pot_of(bowl(), ClayBody::kEarthenware), .tool_shown = false},
        {.name = "stoneware-dry",
         .pot = pot_of(dry_jar, ClayBody::kStoneware, Firing::kDry),
         .tool_shown = false},
        {.name = "earthenware-bisque",
         .pot = pot_of(cylinder(), ClayBody::kEarthenware, Firing::kBisque),
         .tool_shown = false},
        {.name = "celadon",
         .pot = pot_of(bottle(), ClayBody::kStoneware, Firing::kGlaze),
         .tool_shown = false},
    };
}

std::vector<GoldenScene> view_scenes() {
    pot::Pot loaded = studio_pot(jar());
    slump(loaded);
    loaded.centre_mm.clear();
    loaded.dents_mm.clear();
    return {
        {.name = "inside", .pot = studio_pot(jar()), .tool_shown = false, .view = StillView::kLookingIn},
        {.name = "inside-portrait",
         .width = 405,
         .height = 720,
         .pot = studio_pot(jar()),
         .tool_shown = false,
         .view = StillView::kLookingIn},
        {.name = "wide-plate",
         .pot = pot_of(plate(), ClayBody::kEarthenware),
         .tool_shown = false,
         .view = StillView::kLookingIn},
        {.name = "portrait",
         .width = 405,
         .height = 720,
         .pot = studio_pot(bottle()),
         .view = StillView::kPortrait},
        {.name = "cutaway", .pot = studio_pot(jar()), .view = StillView::kCutaway},
        {.name = "load", .pot = loaded, .view = StillView::kCutaway},
        {.name = "wide", .width = 960, .height = 540, .pot = studio_pot(bowl()), .tool_shown = false},
    };
}

std::vector<GoldenScene> move_scenes() {
    pot::Pot off_centre = studio_pot(lump());
    lean(off_centre, 9.0, -3.0);
    return {
        {.name = "centring",
         .pot = off_centre,
         .tool_position_mm = {70.0, 40.0, 8.0},
         .wheel_direction = {0.6, 0.8},
         .contacts = 200},
        {.name = "coning",
         .pot = studio_pot(cone()),
         .tool_position_mm = {40.0, 120.0, 20.0},
         .contacts = 200},
        {.name = "opening",
         .pot = studio_pot(opened()),
         .tool_position_mm = {0.0, 24.0, 12.0},
         .contacts = 90,
         .view = StillView::kLookingIn},
        {.name = "widening",
         .pot = studio_pot(widened()),
         .tool_position_mm = {40.0, 21.0, 10.0},
         .side = Side::kIn,
         .contacts = 90,
         .view = StillView::kLookingIn},
        {.name = "pulling",
         .pot = studio_pot(cylinder()),
         .tool_position_mm = {54.5, 96.0, 4.0},
         .second_hand_mm = dvec3{31.0, 96.0, 2.0},
         .contacts = 90},
        {.name = "bellying",
         .pot = studio_pot(bellied()),
         .tool_position_mm = {45.0, 84.0, 12.0},
         .side = Side::kIn,
         .contacts = 90},
        {.name = "collaring",
         .pot = studio_pot(collared()),
         .tool_position_mm = {38.0, 138.0, 10.0},
         .contacts = 90},
        {.name = "pressing-the-rim",
         .pot = studio_pot(thick_rimmed()),
         .tool_position_mm = {46.0, 128.0, 6.0},
         .side = Side::kTop,
         .contacts = 1},
        {.name = "rib",
         .pot = studio_pot(jar()),
         .tool_position_mm = {86.0, 88.0, 24.0},
         .tool = tool::Tool::kRib,
         .contacts = 60},
        {.name = "sponge",
         .pot = studio_pot(bowl()),
         .tool_position_mm = {73.0, 40.0, 22.0},
         .tool = tool::Tool::kSponge,
         .contacts = 60},
        {.name = "trimming",
         .pot = studio_pot(trimmed()),
         .tool_position_mm = {47.0, 10.0, 18.0},
         .tool = tool::Tool::kTrimmer,
         .contacts = 60},
    };
}

// Collapsed pots, and the cutting wire.
std::vector<GoldenScene> mishap_scenes() {
    pot::Pot uneven_rim = studio_pot(cylinder());
    lean(uneven_rim, 3.0, 1.0);
    press_dent(uneven_rim, 158.0, 5.2, 4.0, 20.0);
    pot::Pot dented = studio_pot(cylinder());
    press_dent(dented, 90.0, 4.9, 9.0, 15.0);
    pot::Pot failed = studio_pot(jar());
    slump(failed);
    return {
        {.name = "wire-at-the-rim", .pot = uneven_rim, .tool_shown = false, .wire_height_mm = 146.0},
        {.name = "wire-off-the-wheel", .pot = studio_pot(jar()), .tool_shown = false, .wire_height_mm = 1.5},
        {.name = "rough-grooves", .pot = studio_pot(rough()), .tool_shown = false},
        {.name = "dent", .pot = dented, .tool_shown = false},
        {.name = "failure", .pot = failed, .tool_shown = false, .wheel_direction = {0.8, -0.6}},
        {.name = "empty-wheel", .tool_shown = false},
    };
}

std::vector<GoldenScene> made_scenes() {
    std::vector<GoldenScene> all;
    for (const auto& part :
         {paper_scenes(), body_scenes(), view_scenes(), move_scenes(), mishap_scenes(), drawn_scenes()})
        all.insert(all.end(), part.begin(), part.end());
    return all;
}

}  // namespace

const std::vector<GoldenScene>& golden_scenes() {
    static const std::vector<GoldenScene> all = made_scenes();
    return all;
}

}  // namespace onggi::golden
