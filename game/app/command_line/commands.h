// The program's commands: each registers itself under `program`, and when it was chosen and has run sets
// exit_status to 0, or to what the README says. A file a command, of its name. Main thread.
#pragma once

namespace CLI {
class App;
}  // namespace CLI

namespace onggi::app {

// Runs the command that the words name; the words are those of main(). Without a command it is the kiosk,
// where the program has one. Gives the exit code: what the command left in `exit_status`, or 2 with one line
// on stderr for wrong usage. In command_line.cpp.
int run_command_line(CLI::App& program, int argc, const char* const* argv, const int& exit_status);

// The experience a visitor walks up to, from attract to a kept pot; what `onggi` alone does.
void add_kiosk_command(CLI::App& program, int& exit_status);
// A gesture or session in simulated time, as fast as it can, without a window.
void add_throw_command(CLI::App& program, int& exit_status);
// A gesture or session in real time, with its picture.
void add_live_command(CLI::App& program, int& exit_status);
// Simulates a session again and compares it with what was recorded.
void add_replay_command(CLI::App& program, int& exit_status);
// The making of a session's pot as a short film.
void add_film_command(CLI::App& program, int& exit_status);
// Serves the outbox to phones, in a process of its own that can do nothing else.
void add_share_command(CLI::App& program, int& exit_status);
// What there is to hold and feel the clay with.
void add_devices_command(CLI::App& program, int& exit_status);
// What the machine offers, what each lack costs, and how to mend it. 0 when it could look, 3 with --strict
// where something is lacking.
void add_doctor_command(CLI::App& program, int& exit_status);
// How a wheel fares, by what it leaves on the disk. 0 where it is well, 1 where it is not, 2 where its
// settings are wrong, 3 where they or its files may not be read.
void add_status_command(CLI::App& program, int& exit_status);
// Writes the program's own manual page and completion, for whoever installs it. Not listed in --help.
void add_manual_command(CLI::App& program, int& exit_status);

}  // namespace onggi::app
