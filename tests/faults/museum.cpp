#include "tests/faults/museum.h"

#include <gtest/gtest.h>

#include <memory>
#include <set>

#include "game/app/kiosk/gallery/interrupted_session.h"
#include "game/app/kiosk/gallery/jar_keeping.h"
#include "game/app/kiosk/gallery/kiosk_gallery.h"
#include "game/app/kiosk/gallery/moving_house.h"
#include "game/app/kiosk/gallery/visit_journal.h"
#include "game/app/kiosk/gallery/wall_of_the_day.h"
#include "game/app/kiosk/health/house_status.h"
#include "game/app/kiosk/health/kiosk_statistics.h"
#include "game/app/kiosk/keeping/kiosk_keeper.h"
#include "game/app/kiosk/keeping/kiosk_phone.h"
#include "game/app/kiosk/kiosk_settings.h"
#include "game/app/system/start_log.h"
#include "game/haptic/history.h"
#include "game/haptic/simulated_device.h"
#include "game/sharing/outbox.h"
#include "tests/stress/whole.h"
#include "tests/support/comes_true.h"
#include "tests/support/shared_pot_samples.h"
#include "tests/unit/haptic/studio_hand.h"

namespace onggi::faults {
namespace {

namespace fs = std::filesystem;

constexpr double kRateHz = 500.0;
constexpr std::int64_t kNoonS = 1'795'608'000;  // of kToday, UTC
constexpr std::uint64_t kInterruptedTicks = 2000;
constexpr const char* kSharedMark = "before";
constexpr std::ptrdiff_t kFilesOfAPage = 29;
constexpr std::ptrdiff_t kFilesOfAFilm = 8;  // with the drawing and the measures, which come with it
constexpr const char* kKeptAlready = "2026-11-25/pot-001";
constexpr const char* kDayOfMoved = "2026-11-22";
constexpr const char* kMoved = "2026-11-22/pot-001";
constexpr std::int64_t kNoonOfMovedS = kNoonS - 3 * 86'400;

haptic::HapticParameters parameters() {
    haptic::HapticParameters found;
    found.set_rate_hz(kRateHz);
    return found;
}

// A visit in simulated time, and its history.
struct Visit {
    explicit Visit(const fs::path& aside = {})
        : history(test::studio_start(), parameters(), {.aside = aside}) {}

    void throw_until(std::uint64_t end) {
        while (state.ticks < end)
            tick(0);
    }
    void tick(std::uint32_t flags) {
        const tool::ToolState tool = test::studio_hand(state.ticks, kRateHz);
        const haptic::TickResult result = haptic::tick(state, tool, parameters());
        history.add({.tick = static_cast<std::uint32_t>(state.ticks - 1),
                     .flags = flags | (state.ticks == 1 ? haptic::TickRecord::kFreshLump : 0U),
                     .tool = state.tool,
                     .force_n = result.forces.total_n()});
    }

    haptic::HapticState state = test::studio_start();
    haptic::History history;
};

// Thrown once; forked children inherit it.
const Visit& thrown() {
    static const auto visit = [] {
        auto made = std::make_unique<Visit>();
        made->throw_until(1200);
        return made;
    }();
    return *visit;
}

app::PotToKeep pot_to_keep() {
    return {.history = &thrown().history,
            .clay = thrown().state.studio(),
            .glaze = &finish::glaze_at(0),
            .portrait = {.width = 2, .height = 1, .rgba = {200, 150, 100, 255, 0, 0, 0, 0}}};
}

app::WallPot wall_pot(const std::string& name) {
    return {
        .gallery_name = name, .glaze = 3, .shape = pot::hollowed({{40, 0}, {55, 50}, {45, 100}}, 5.0F, 8.0F)};
}

sharing::OutboxOptions outbox_of(const fs::path& museum, std::size_t most_pots = 8) {
    return {.folder = museum / "outbox", .most_pots = most_pots, .languages = support::three_languages()};
}

fs::path gallery_of(const fs::path& museum) {
    return museum / "gallery";
}
fs::path state_of(const fs::path& museum) {
    return app::state_folder(gallery_of(museum));
}

app::JarKeeping jar_of(const fs::path& museum) {
    return {state_of(museum), test::studio_start(), parameters()};
}

// As at a start. Returns whether there is a bowl.
bool restore(app::JarKeeping& jar, std::vector<std::string>& remarks) {
    if (const auto looked = jar.look(remarks); !looked) remarks.push_back(looked.error().message);
    for (;;) {
        const auto more = jar.restore(10'000);
        if (!more) remarks.push_back(more.error().message);
        if (!more || !*more) return jar.has_bowl();
    }
}

// The second bowl of the jar is like the first. Thrown once; forked children inherit it.
Visit& second_bowl() {
    static Visit visit;
    visit.throw_until(thrown().state.ticks);
    return visit;
}

// Each returns whether the whole action succeeded.
bool start(const fs::path& museum) {
    std::vector<std::string> remarks;
    app::StartKeeper starts(state_of(museum));
    static_cast<void>(starts.begin_now(remarks));
    app::Gallery(config_of(museum)).clear_parts();
    app::JarKeeping jar = jar_of(museum);
    static_cast<void>(restore(jar, remarks));
    static_cast<void>(
        app::InterruptedSession::find(state_of(museum), test::studio_start(), parameters(), remarks));
    app::WallOfTheDay wall(state_of(museum) / "wall.json");
    const bool has_wall = static_cast<bool>(wall.open(kToday));
    const bool has_outbox = static_cast<bool>(sharing::Outbox::open(outbox_of(museum)));
    const bool counted = static_cast<bool>(app::note_start(gallery_of(museum) / "statistics", kNoonS));
    return has_wall && has_outbox && counted && remarks.empty();
}

bool throw_with_a_journal(const fs::path& museum) {
    Visit visit(state_of(museum));
    app::VisitJournal journal(state_of(museum));
    std::int64_t now_ns = 0;
    bool done = true;
    const auto follow = [&] {
        done = static_cast<bool>(journal.follow(visit.history, now_ns += 2'000'000'000)) && done;
    };
    visit.throw_until(1500);
    follow();
    // Undone, and continued from there.
    const auto before = visit.history.state_at(700);
    if (!before) return false;
    visit.state = *before;
    visit.tick(haptic::TickRecord::kStatePut);
    follow();
    visit.throw_until(2600);
    follow();
    return static_cast<bool>(journal.leave()) && done;
}

bool keep_a_pot(const fs::path& museum) {
    app::Gallery gallery(config_of(museum));  // which has room for two
    return static_cast<bool>(gallery.keep(pot_to_keep(), kToday));
}

bool keep_a_jar(const fs::path& museum) {
    std::vector<std::string> remarks;
    app::JarKeeping bowls = jar_of(museum);
    if (!restore(bowls, remarks)) return false;
    const auto jar = bowls.join(second_bowl().history, {});
    if (!jar || !bowls.note(app::JarStage::kJar)) return false;
    app::PotToKeep pot = pot_to_keep();
    pot.history = &*jar;
    pot.clay = jar->state().studio();
    pot.bowls = bowls.sessions();
    app::Gallery gallery(config_of(museum));
    if (!gallery.keep(std::move(pot), kToday)) return false;
    bowls.forget();
    return true;
}

// Settings with room for the pots of two galleries.
kiosk::Config moving_config(const fs::path& museum) {
    kiosk::Config config = config_of(museum);
    config.gallery.most_pots = 100;
    config.sharing.public_url = "http://pots.example";
    config.sharing.outbox = (museum / "outbox").string();
    return config;
}

fs::path archive_of(const fs::path& museum) {
    return museum / "moved.zip";
}

bool import_a_gallery(const fs::path& museum) {
    auto archive = files::ArchiveReader::open(archive_of(museum));
    return archive &&
           app::import_gallery(std::move(*archive), moving_config(museum), kNoonS, [](auto, auto) {});
}

// Another museum's gallery.
void lay_out_archive(const fs::path& museum) {
    const fs::path other = museum / "other";
    ASSERT_TRUE(app::Gallery(config_of(other)).keep(pot_to_keep(), kDayOfMoved));
    ASSERT_TRUE(app::note_visit(gallery_of(other) / "statistics", {.dwell_s = 50}, kNoonOfMovedS));
    auto outbox = sharing::Outbox::open(outbox_of(other));
    ASSERT_TRUE(outbox);
    ASSERT_TRUE(outbox->put(support::full_pot("moved"), {.now_s = kNoonS - 60, .expires_s = kNoonS + 3600}));
    ASSERT_TRUE(app::export_gallery(moving_config(other), archive_of(museum), [](auto, auto) {}));
    fs::remove_all(other);
}

// With the portrait, and the visit's count.
bool keep_beside_the_frame(const fs::path& museum) {
    kiosk::Config config = config_of(museum);
    config.gallery.most_pots = 100;  // no pot gives way, whatever the day is
    haptic::HapticJob job(test::studio_start(), parameters(), std::make_unique<haptic::SimulatedDevice>(),
                          {});
    app::KioskKeeper keeper(job, test::studio_start(), parameters(), app::Gallery(config),
                            gallery_of(museum) / "statistics");
    if (!keeper.start()) return false;
    keeper.cut_off();
    keeper.save(std::make_shared<const pot::Section>(wall_pot("").shape), 3);
    keeper.note({.dwell_s = 60, .kept = 1});
    std::shared_ptr<const app::KeeperAnswer> answer;
    const auto is_saved = [&] {
        return answer && std::holds_alternative<app::KeeperAnswer::Saved>(answer->what);
    };
    test::comes_true([&] {
        answer = keeper.next_answer();
        return is_saved() || (answer && std::holds_alternative<kiosk::Event>(answer->what));
    });
    return is_saved();
}

// The page of a pot of the gallery, with its pictures.
bool share_beside_the_frame(const fs::path& museum) {
    auto settings = app::load_settings("");
    if (!settings) return false;
    settings->config.gallery.folder = gallery_of(museum).string();
    settings->config.sharing.outbox = (museum / "outbox").string();
    settings->config.sharing.public_url = "http://pots.example";
    app::KioskPhone phone(*settings);
    if (!phone.start()) return false;
    auto fired = std::make_shared<screens::FiredPot>();
    fired->shape = wall_pot("").shape;
    phone.share({.gallery_name = kKeptAlready, .pot = std::move(fired)});
    std::shared_ptr<const app::PhoneAnswer> answer;
    const app::PhoneAnswer::OfPot* of_pot = nullptr;
    test::comes_true([&] {
        answer = phone.next_answer();
        of_pot = answer ? std::get_if<app::PhoneAnswer::OfPot>(&answer->what) : nullptr;
        return of_pot != nullptr;
    });
    return of_pot != nullptr && of_pot->outcome == kiosk::ShareOutcome::kReady;
}

bool delete_a_pot(const fs::path& museum) {
    app::Gallery gallery(config_of(museum));
    for (const app::KeptPot& pot : gallery.pots())
        if (pot.name == "2026-11-24/pot-001") return static_cast<bool>(gallery.remove(pot));
    return false;
}

bool share_a_pot(const fs::path& museum) {
    auto outbox = sharing::Outbox::open(outbox_of(museum));
    return outbox && outbox->put(support::full_pot("after"), {.now_s = kNoonS, .expires_s = kNoonS + 3600});
}

bool share_in_place_of_the_oldest(const fs::path& museum) {
    auto outbox = sharing::Outbox::open(outbox_of(museum, 1));
    return outbox && outbox->put(support::full_pot("after"), {.now_s = kNoonS, .expires_s = kNoonS + 3600});
}

bool put_on_the_wall(const fs::path& museum) {
    app::WallOfTheDay wall(state_of(museum) / "wall.json");
    const bool has_opened = static_cast<bool>(wall.open(kToday));
    return wall.put(wall_pot("2026-11-25/pot-002"), kToday) && has_opened;
}

bool count(const fs::path& museum) {
    const fs::path statistics = gallery_of(museum) / "statistics";
    const bool visit = static_cast<bool>(app::note_visit(statistics, {.dwell_s = 60, .kept = 1}, kNoonS));
    const bool came = static_cast<bool>(app::note_attract_break(statistics, kNoonS));
    const bool phones = static_cast<bool>(app::note_phones(statistics, {.codes = 1}, kNoonS));
    return visit && came && phones;
}

bool set_the_house(const fs::path& museum) {
    return static_cast<bool>(
        app::keep_house(gallery_of(museum) / "statistics", {.volume = 2, .language = "en"}));
}

bool beat(const fs::path& museum) {
    app::KioskHeartbeat heart(config_of(museum));
    const bool beats =
        static_cast<bool>(heart.beat({.screen = "throw", .frames_shown = 5, .haptic_ticks = 7}, kNoonS + 60));
    const bool ends = static_cast<bool>(heart.end(kNoonS + 120));
    app::StartKeeper starts(state_of(museum));
    return static_cast<bool>(starts.end_now()) && beats && ends;
}

bool keep_a_fault(const fs::path& museum) {
    haptic::FaultReport faults(app::faults_folder(gallery_of(museum)));
    haptic::TickRecord record;
    record.flags = haptic::TickRecord::kFault;
    const auto kept = faults.look(record, thrown().history);
    return kept && *kept;
}

bool is(const Deed& deed, const char* name) {
    return std::string_view(deed.name) == name;
}

bool outbox_has_moved(const fs::path& museum) {
    for (const auto& page : fs::directory_iterator(museum / "outbox")) {
        const fs::path model = page.path() / "pot.glb";
        if (fs::exists(model) && test::content_of(model).starts_with("glTF moved")) return true;
    }
    return false;
}

void expect_sound_gallery(const fs::path& museum, const Deed& deed, bool said_done) {
    const app::Gallery gallery(config_of(museum));
    const auto finished = app::finish_import(moving_config(museum));
    EXPECT_TRUE(finished) << finished.error().message;
    gallery.clear_parts();
    std::set<std::string> names;
    for (const app::KeptPot& pot : gallery.pots()) {
        stress::expect_whole_pot(pot.folder);
        names.insert(pot.name);
    }
    const bool has_new = names.contains("2026-11-25/pot-002");
    EXPECT_TRUE(names.contains(kKeptAlready));
    // The oldest pot is removed only after the new one is written; it may stay if it cannot be removed.
    if (is(deed, "delete a pot")) {
        EXPECT_FALSE(names.contains("2026-11-24/pot-001") && said_done) << "it was said to be gone";
    } else if (!has_new) {
        EXPECT_TRUE(names.contains("2026-11-24/pot-001"));
    }
    if (is(deed, "keep a pot") || is(deed, "keep a jar")) {
        EXPECT_TRUE(has_new || !said_done);
    } else {
        EXPECT_FALSE(has_new);
    }
    if (is(deed, "keep beside the frame")) {
        EXPECT_TRUE(names.size() == 3 || !said_done);
    }
    // All of the archive has come in, or nothing.
    const bool has_moved = names.contains(kMoved);
    const app::UseOfDay use = app::use_of(gallery.folder() / "statistics", kDayOfMoved);
    EXPECT_EQ(use.total().visits, has_moved ? 1 : 0);
    EXPECT_EQ(outbox_has_moved(museum), has_moved);
    EXPECT_EQ(has_moved, is(deed, "import a gallery") && (said_done || has_moved));
    EXPECT_FALSE(fs::exists(gallery.folder() / "import"));
    for (const auto& entry : fs::recursive_directory_iterator(gallery.folder())) {
        const std::string name = entry.path().filename().string();
        const bool is_a_visit = entry.path().parent_path().filename() == "state";
        EXPECT_TRUE(is_a_visit || !entry.path().string().ends_with(".part"))
            << entry.path() << " is left behind";
        EXPECT_TRUE(is_a_visit || !name.starts_with(".onggi-")) << entry.path() << " is left behind";
    }
}

void expect_sound_outbox(const fs::path& museum, const Deed& deed, bool said_done) {
    const auto outbox = sharing::Outbox::open(outbox_of(museum));
    ASSERT_TRUE(outbox) << outbox.error().message;
    const auto entries = outbox->list();
    ASSERT_TRUE(entries) << entries.error().message;
    bool has_old = false;
    bool has_new = false;
    for (const sharing::OutboxEntry& entry : *entries) {
        const fs::path folder = museum / "outbox" / entry.code.text();
        const auto files = std::distance(fs::directory_iterator(folder), fs::directory_iterator());
        const std::string model = test::content_of(folder / "pot.glb");
        EXPECT_GT(model.size(), 20'000U);
        const bool is_old = model.starts_with(std::string("glTF ") + kSharedMark);
        const bool has_film = is_old || !is(deed, "share beside the frame");
        EXPECT_EQ(files, has_film ? kFilesOfAPage : kFilesOfAPage - kFilesOfAFilm) << "a page is half there";
        has_old = has_old || is_old;
        has_new = has_new || !is_old;
    }
    const bool gives_way = is(deed, "share in place of the oldest");
    // The phones' thread goes by the machine's clock, by which the old page may be over.
    EXPECT_TRUE(has_old || (gives_way && has_new) || is(deed, "share beside the frame"))
        << "a shared pot is gone";
    const bool shares = gives_way || is(deed, "share a pot") || is(deed, "share beside the frame") ||
                        is(deed, "import a gallery");
    EXPECT_TRUE(shares ? has_new || !said_done : !has_new);
    for (const auto& entry : fs::directory_iterator(museum / "outbox"))
        EXPECT_FALSE(entry.path().string().ends_with(".part")) << entry.path() << " is left behind";
}

void expect_sound_wall(const fs::path& museum, const Deed& deed, bool said_done) {
    app::WallOfTheDay wall(state_of(museum) / "wall.json");
    const auto opened = wall.open(kToday);
    ASSERT_TRUE(opened) << opened.error().message;
    ASSERT_FALSE(wall.pots().empty());
    EXPECT_EQ(wall.pots().front().gallery_name, "2026-11-25/pot-001");
    if (is(deed, "put on the wall") && said_done) {
        EXPECT_EQ(wall.pots().size(), 2U);
    }
}

void expect_sound_counts(const fs::path& museum, const Deed& deed, bool said_done) {
    const fs::path statistics = gallery_of(museum) / "statistics";
    const int more = is(deed, "count") && said_done ? 1 : 0;
    app::UseOfDay use = app::use_of(statistics, kToday);
    const int visits = use.total().visits;
    EXPECT_GE(visits, 2 + more);
    EXPECT_GE(use.total().breaks, 2 + more);
    EXPECT_GE(use.starts, 1);
    // A later visit is counted, whatever precedes it in the file.
    ASSERT_TRUE(app::note_visit(statistics, {.dwell_s = 77, .thrown = true, .kept = 1}, kNoonS));
    ASSERT_TRUE(app::note_attract_break(statistics, kNoonS));
    const int breaks = use.total().breaks;
    use = app::use_of(statistics, kToday);
    EXPECT_EQ(use.total().visits, visits + 1);
    EXPECT_EQ(use.total().breaks, breaks + 1);
    const std::string table = test::content_of(statistics / "visits.csv");
    EXPECT_TRUE(table.starts_with("day,hour,dwell_s,ended_on,thrown,kept\n")) << table;
}

void expect_sound_settings(const fs::path& museum, const Deed& deed, bool said_done) {
    auto settings = app::load_settings("");
    ASSERT_TRUE(settings);
    settings->config.gallery.folder = gallery_of(museum).string();
    settings->config.sound.remember_staff = true;
    settings->remarks.clear();
    app::take_kept_house(*settings);
    EXPECT_TRUE(settings->remarks.empty()) << settings->remarks.front();
    const int volume = settings->rules.default_volume;
    if (is(deed, "set the house")) {
        EXPECT_TRUE(volume == 2 || (volume == 4 && !said_done)) << volume;
    } else {
        EXPECT_EQ(volume, 4);
    }
}

void expect_sound_visit(const fs::path& museum, const Deed& deed, bool said_done) {
    std::vector<std::string> remarks;
    const auto found =
        app::InterruptedSession::find(state_of(museum), test::studio_start(), parameters(), remarks);
    for (const std::string& line : remarks)
        ADD_FAILURE() << line;
    ASSERT_TRUE(found) << "the interrupted visit is gone";
    for (;;) {
        const auto more = found->work(10'000);
        ASSERT_TRUE(more) << more.error().message;
        if (!*more) break;
    }
    EXPECT_TRUE(found->is_worth_it());
    const bool throws = is(deed, "throw with a journal");
    EXPECT_GE(found->history().ticks(), throws && said_done ? 2000U : kInterruptedTicks);
}

void expect_sound_jar(const fs::path& museum, const Deed& deed) {
    // The keeper drops the bowls of a jar whose visitor kept another pot.
    const bool has_given_way =
        is(deed, "keep beside the frame") && app::kept_pots(gallery_of(museum)).size() > 2;
    const fs::path kept = gallery_of(museum) / "2026-11-25/pot-002";
    std::vector<std::string> remarks;
    app::JarKeeping jar = jar_of(museum);
    const bool has_bowl = restore(jar, remarks);
    EXPECT_TRUE(remarks.empty()) << remarks.front();
    EXPECT_TRUE(has_bowl || has_given_way || fs::exists(kept / "bowl-1.onggi")) << "a bowl is gone";
    if (is(deed, "keep a jar") && fs::exists(kept)) {
        EXPECT_TRUE(fs::exists(kept / "bowl-1.onggi") && fs::exists(kept / "bowl-2.onggi"));
    }
}

}  // namespace

kiosk::Config config_of(const fs::path& museum) {
    kiosk::Config config;
    config.gallery.folder = gallery_of(museum).string();
    config.gallery.least_free_mb = 1.0;
    config.gallery.most_pots = 2;
    return config;
}

std::vector<Deed> deeds() {
    return {{"start", &start},
            {"throw with a journal", &throw_with_a_journal},
            {"keep a pot", &keep_a_pot},
            {"keep a jar", &keep_a_jar},
            {"delete a pot", &delete_a_pot},
            {"share a pot", &share_a_pot},
            {"share in place of the oldest", &share_in_place_of_the_oldest},
            {"put on the wall", &put_on_the_wall},
            {"count", &count},
            {"set the house", &set_the_house},
            {"beat and end", &beat},
            {"keep a fault", &keep_a_fault}};
}

std::vector<Deed> deeds_of_staff() {
    return {{"import a gallery", &import_a_gallery}};
}

std::vector<Deed> deeds_of_threads() {
    return {{"keep beside the frame", &keep_beside_the_frame},
            {"share beside the frame", &share_beside_the_frame}};
}

void lay_out(const fs::path& museum) {
    app::Gallery gallery(config_of(museum));
    ASSERT_TRUE(gallery.keep(pot_to_keep(), kYesterday));
    ASSERT_TRUE(gallery.keep(pot_to_keep(), kToday));
    auto outbox = sharing::Outbox::open(outbox_of(museum));
    ASSERT_TRUE(outbox);
    ASSERT_TRUE(
        outbox->put(support::full_pot(kSharedMark), {.now_s = kNoonS - 60, .expires_s = kNoonS + 3600}));
    app::WallOfTheDay wall(state_of(museum) / "wall.json");
    ASSERT_TRUE(wall.put(wall_pot("2026-11-25/pot-001"), kToday));
    const fs::path statistics = gallery_of(museum) / "statistics";
    for (int visitor = 0; visitor < 2; ++visitor) {
        ASSERT_TRUE(app::note_visit(statistics, {.dwell_s = 100}, kNoonS));
        ASSERT_TRUE(app::note_attract_break(statistics, kNoonS));
    }
    ASSERT_TRUE(app::note_start(statistics, kNoonS));
    ASSERT_TRUE(app::keep_house(statistics, {.volume = 4, .language = "ko"}));
    Visit visit;
    app::VisitJournal journal(state_of(museum));
    visit.throw_until(kInterruptedTicks + 50);
    ASSERT_TRUE(journal.follow(visit.history, 2'000'000'000));
    ASSERT_TRUE(journal.leave());
    Visit bowl;
    bowl.throw_until(second_bowl().state.ticks);
    app::JarKeeping jar = jar_of(museum);
    ASSERT_TRUE(jar.begin("moon-jar-nmk"));
    ASSERT_TRUE(jar.set_aside(std::move(bowl.history)));
    ASSERT_TRUE(jar.note(app::JarStage::kSecondBowl));
    ASSERT_TRUE(
        app::KioskHeartbeat(config_of(museum)).beat({.screen = "attract", .frames_shown = 1}, kNoonS));
    app::StartKeeper starts(state_of(museum));
    std::vector<std::string> remarks;
    static_cast<void>(starts.begin_now(remarks));
    ASSERT_TRUE(starts.end_now());
    lay_out_archive(museum);
}

void expect_sound(const fs::path& museum, const Deed& deed, bool said_done) {
    expect_sound_gallery(museum, deed, said_done);
    expect_sound_outbox(museum, deed, said_done);
    expect_sound_wall(museum, deed, said_done);
    expect_sound_counts(museum, deed, said_done);
    expect_sound_settings(museum, deed, said_done);
    expect_sound_visit(museum, deed, said_done);
    expect_sound_jar(museum, deed);
    const auto log = app::read_start_log_of(state_of(museum));
    ASSERT_TRUE(log) << log.error().message;
    const auto status = app::look_at_house(config_of(museum), kNoonS + 60);
    ASSERT_TRUE(status) << status.error().message;
    EXPECT_TRUE(status->note) << "the last heartbeat is gone";
    for (const app::HouseStatus::Fault& fault : status->faults) {
        const auto session = record::parse_session(test::content_of(fault.session), fault.session.string());
        ASSERT_TRUE(session) << session.error().message;
        EXPECT_TRUE(session->is_complete());
    }
}

}  // namespace onggi::faults
