#include <fmt/format.h>
#include <poll.h>
#include <sys/resource.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <csignal>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "engine/core/quote.h"
#include "engine/jobs/clock.h"
#include "engine/jobs/thread_setup.h"
#include "game/app/command_line/commands.h"
#include "game/app/kiosk/kiosk_settings.h"
#include "game/app/sharing/confinement.h"
#include "game/app/sharing/listen_place.h"
#include "game/app/sharing/share_server.h"
#include "game/app/system/end_signal.h"
#include "game/app/system/report.h"
#include "game/app/system/wall_clock.h"
#include "game/kiosk/config.h"

namespace onggi::app {
namespace {

struct ShareOptions {
    std::string config;
    std::string outbox;
    std::string listen;
    int port = 8080;
    std::string counter;
};

constexpr int kRoundMs = 500;  // between two checks of the end signal

// Executes the program again with only the arguments that the server needs, so that a process that answers
// strangers has no setting, such as the staff's PIN, in its memory. Returns only on failure.
Result<void> start_over(const kiosk::Config& config) {
    std::vector<std::string> words{"onggi",    "share",
                                   "--outbox", config.sharing.outbox,
                                   "--listen", config.sharing.listen,
                                   "--port",   std::to_string(config.sharing.port)};
    if (!config.sharing.counter.empty()) {
        words.emplace_back("--counter");
        words.push_back(config.sharing.counter);
    }
    std::vector<char*> arguments;
    for (std::string& word : words)
        arguments.push_back(word.data());
    arguments.push_back(nullptr);
    ::execv("/proc/self/exe", arguments.data());
    return failed("sharing: expected to start over without the settings, found: the program cannot be run");
}

Result<void> read_settings_and_start_over(const std::string& file) {
    const auto config = read_config_file(file);
    if (!config) return config.error();
    if (config->sharing.listen.empty()) {
        remark(fmt::format("sharing is off: {} names no address to listen at", shown_path(file)));
        return {};
    }
    return start_over(*config);
}

// On the kiosk's machine, the picture has priority and the haptic thread's core stays free. If the kernel
// refuses, phones lose nothing, so the refusal is not reported.
void stand_back() {
    constexpr int kPicturesFirst = 10;  // nice level: about a tenth of the normal share of a core
    static_cast<void>(::setpriority(PRIO_PROCESS, 0, kPicturesFirst));
    static_cast<void>(jobs::keep_this_thread_off_haptic_core(jobs::choose_haptic_core()));
}

// The kiosk creates its outbox when it starts, perhaps after this server.
Result<void> wait_for_folder(const std::string& folder) {
    std::error_code error;
    if (!std::filesystem::exists(folder, error))
        remark(fmt::format("sharing: {}: waiting for the folder of shared pots", shown_path(folder)));
    while (!std::filesystem::exists(folder, error) && !end_was_asked())
        ::poll(nullptr, 0, kRoundMs);  // a signal ends it sooner
    if (end_was_asked() || std::filesystem::is_directory(folder, error)) return {};
    return bad_input(
        fmt::format("{}: expected a folder of shared pots, found something else", shown_path(folder)));
}

Error no_access(const std::string& folder, const std::string& user) {
    return bad_input(fmt::format("{}: expected a folder that {} may open, found it closed",
                                 shown_path(folder), user.empty() ? "this user" : "the user " + user));
}

Result<void> serve(const ShareOptions& options) {
    stand_back();
    std::signal(SIGPIPE, SIG_IGN);  // a phone may disconnect during an answer
    note_end_signals();
    if (const auto there = wait_for_folder(options.outbox); !there) return there;
    if (end_was_asked()) return {};
    std::error_code error;
    const auto listening = listen_at(options.listen, options.port);
    if (!listening) return listening.error();
    std::string counter = std::filesystem::absolute(options.counter, error).string();
    // The outbox is the working folder from now on: another user need not have access to what is above it.
    std::filesystem::current_path(options.outbox, error);
    const auto user = give_up_root();
    if (!user) return user.error();
    if (error || ::access(".", X_OK) != 0) return no_access(options.outbox, *user);
    const bool counts = !options.counter.empty() && ::access(counter.c_str(), W_OK) == 0;
    if (!counts) counter.clear();
    const auto confined = confine_to(".", counter);
    if (!confined) return confined.error();
    const bool is_filtered = confine_calls();
    auto server = ShareServer::start({.listening_socket = *listening,
                                      .outbox = ".",
                                      .counter = counter,
                                      .now_s = jobs::MonotonicClock::now_s,
                                      .wall_s = wall_clock_s});
    if (!server) return server.error();
    remark(fmt::format("sharing at {}, port {}{}{}{}", options.listen, port_of(*listening),
                       user->empty() ? "" : ", as the user " + *user,
                       *confined ? "" : "; this kernel has no Landlock",
                       is_filtered ? "" : "; this kernel has no filter of system calls"));
    if (!options.counter.empty() && !counts)
        remark(fmt::format("sharing: {}: expected a pipe to count in, found none to write to",
                           shown_path(options.counter)));
    while (!end_was_asked())
        (*server)->run(kRoundMs);
    return {};
}

}  // namespace

void add_share_command(CLI::App& program, int& exit_status) {
    CLI::App* command = program.add_subcommand(
        "share", "Serve the pots that visitors take home by phone, in a confined process");
    const auto options = std::make_shared<ShareOptions>();
    auto* config = command->add_option("--config", options->config,
                                       "settings of the kiosk; [sharing] has all the others");
    config->type_name("FILE.toml");
    auto* outbox = command->add_option("--outbox", options->outbox, "the folder with a page for each pot");
    outbox->type_name("FOLDER")->excludes(config);
    auto* listen = command->add_option("--listen", options->listen,
                                       "address or interface of this machine, such as 10.0.0.5 or wlan0");
    listen->type_name("ADDRESS")->excludes(config)->needs(outbox);
    outbox->needs(listen);
    command->add_option("--port", options->port, "0: any free port")
        ->check(CLI::Range(0, 65535))
        ->excludes(config)
        ->capture_default_str();
    command->add_option("--counter", options->counter, "a pipe that counts opened pages")
        ->type_name("PIPE")
        ->excludes(config);
    command->callback([options, &exit_status] {
        if (options->config.empty() && options->outbox.empty()) {
            exit_status =
                report(bad_input("onggi share: expected --config, or --outbox and --listen, found neither"));
            return;
        }
        exit_status = exit_code(options->config.empty() ? serve(*options)
                                                        : read_settings_and_start_over(options->config));
    });
}

}  // namespace onggi::app
