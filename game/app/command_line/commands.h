// The program's commands: each function registers its command under `program`. A command that has run sets
// exit_status to 0, or to a code of the README. Each command has a file of its name. Main thread.
#pragma once

namespace CLI {
class App;
}  // namespace CLI

namespace onggi::app {

// Runs the command that main()'s arguments name; the default is the kiosk, if the program has one. Returns
// the exit code: the command's `exit_status`, or 2 with one line on stderr for wrong usage. In
// command_line.cpp.
int run_command_line(CLI::App& program, int argc, const char* const* argv, const int& exit_status);

// Runs the visitor's experience, from attract mode to a kept pot; the default of `onggi`.
void add_kiosk_command(CLI::App& program, int& exit_status);
// Plays a gesture or session in simulated time, as fast as possible, without a window.
void add_throw_command(CLI::App& program, int& exit_status);
// Plays a gesture or session in real time, with its picture.
void add_live_command(CLI::App& program, int& exit_status);
// Simulates a session again and compares it with the recording.
void add_replay_command(CLI::App& program, int& exit_status);
// Renders a session's pot and its making as a short film.
void add_film_command(CLI::App& program, int& exit_status);
// Serves the outbox to phones, in a separate confined process.
void add_share_command(CLI::App& program, int& exit_status);
// Lists the available haptic and input devices.
void add_devices_command(CLI::App& program, int& exit_status);
// Reports what the machine offers and, for each lack, its effect and its remedy. Exit code 0, or 3 with
// --strict if something is lacking.
void add_doctor_command(CLI::App& program, int& exit_status);
// Reports the state of a kiosk from its files. Exit code 0 if it is well, 1 if it is not, 2 if its settings
// are wrong, 3 if they or its files cannot be read.
void add_status_command(CLI::App& program, int& exit_status);
// Exports a kiosk's gallery as one archive, or imports one. Exit code 2 if the archive is refused, 3 if there
// is no room, no permission, or the kiosk runs.
void add_gallery_command(CLI::App& program, int& exit_status);
// Writes the program's manual page and completion, for the installation. Not listed in --help.
void add_manual_command(CLI::App& program, int& exit_status);

}  // namespace onggi::app
