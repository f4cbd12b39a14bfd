// onggi: a potter's wheel with haptics. Each command has its own file; --help lists them in the order below.
#include <CLI/CLI.hpp>
#include <csignal>

#include "engine/jobs/thread_setup.h"
#include "game/app/command_line/commands.h"
#include "game/app/system/crash_report.h"

int main(int argc, char** argv) {
    // Exceeding the file size limit then fails the write with a message, instead of ending the program.
    std::signal(SIGXFSZ, SIG_IGN);
    onggi::app::report_crashes();
    onggi::jobs::keep_heaps_small();

    CLI::App program{"A potter's wheel one can feel", "onggi"};
    int exit_status = 0;
    onggi::app::add_kiosk_command(program, exit_status);
    onggi::app::add_throw_command(program, exit_status);
    onggi::app::add_live_command(program, exit_status);
    onggi::app::add_replay_command(program, exit_status);
    onggi::app::add_film_command(program, exit_status);
    onggi::app::add_share_command(program, exit_status);
    onggi::app::add_devices_command(program, exit_status);
    onggi::app::add_doctor_command(program, exit_status);
    onggi::app::add_status_command(program, exit_status);
    onggi::app::add_gallery_command(program, exit_status);
    onggi::app::add_manual_command(program, exit_status);
    return onggi::app::run_command_line(program, argc, argv, exit_status);
}
