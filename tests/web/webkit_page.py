"""xvfb-run python3 webkit_page.py ONGGI MAKE_OUTBOX SESSION FOLDER

Opens a shared pot's page in WebKitGTK, the engine of iPhones' browsers as far as Debian has it: the pot is drawn, and the
film as MP4 runs by itself and begins again. Writes FOLDER/webkit.png.
"""
import json
import os
import re
import subprocess
import sys

import gi

gi.require_version("Gtk", "3.0")
gi.require_version("WebKit2", "4.1")
from gi.repository import GLib, Gtk, WebKit2  # noqa: E402

PATIENCE_S = 240.0 * max(1.0, float(os.environ.get("ONGGI_SLOWNESS", "1")))
FILM_S = 2.0
# What the page tells every 50 ms, as its title.
REPORTER = """
const seen = { most: 0, again: false, ended: false, drawn: false, errors: [] };
window.addEventListener('error', (problem) => seen.errors.push(String(problem.message)));
setInterval(() => {
    const video = document.getElementById('video');
    seen.drawn = document.querySelector('.drawn canvas') !== null;
    if (!video) return;
    video.scrollIntoView();
    if (seen.most > %f - 0.5 && video.currentTime < 1.0) seen.again = true;
    seen.most = Math.max(seen.most, video.currentTime);
    seen.ended = seen.ended || video.ended;
    document.title = JSON.stringify({ ...seen, paused: video.paused, width: video.videoWidth, lasts: video.duration || 0 });
}, 50);
""" % FILM_S


def served(onggi, make_outbox, session, folder):
    """Shares a pot with a film; gives the server's process and the page's address."""
    film = {"--out": "film.webp", "--mp4": "film.mp4"}
    subprocess.run([onggi, "film", session, "--glaze", "celadon", "--quick", "--seconds", str(FILM_S),
                    *(word for option, name in film.items() for word in (option, f"{folder}/{name}"))], check=True)
    code = subprocess.run([make_outbox, session, folder, "--film", f"{folder}/film.webp", "--mp4", f"{folder}/film.mp4"],
                          check=True, capture_output=True, text=True).stdout.strip()
    server = subprocess.Popen([onggi, "share", "--outbox", f"{folder}/box", "--listen", "127.0.0.1", "--port", "0"],
                              stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
    for line in server.stdout:
        if port := re.search(r"port (\d+)", line):
            return server, f"http://127.0.0.1:{port[1]}/{code}/"
    sys.exit("expected a server that says its port")


def looked_at(address, picture):
    """What the page told last: everything that is awaited, or what there was when the patience ended."""
    found = {}
    content = WebKit2.UserContentManager()
    content.add_script(WebKit2.UserScript(REPORTER, WebKit2.UserContentInjectedFrames.TOP_FRAME,
                                          WebKit2.UserScriptInjectionTime.END, None, None))
    view = WebKit2.WebView(user_content_manager=content)
    # Without it a film waits for a finger, also a silent one.
    view.get_settings().set_media_playback_requires_user_gesture(False)
    view.get_settings().set_enable_webgl(True)
    window = Gtk.Window(default_width=390, default_height=844)
    window.add(view)
    window.show_all()

    def told(*_):
        try:
            found.update(json.loads(view.get_title() or ""))
        except json.JSONDecodeError:
            return  # the page's own title
        if found["drawn"] and found["again"]:
            view.get_snapshot(WebKit2.SnapshotRegion.FULL_DOCUMENT, WebKit2.SnapshotOptions.NONE, None, drawn)

    def drawn(_, result):
        view.get_snapshot_finish(result).write_to_png(picture)
        Gtk.main_quit()

    view.connect("notify::title", told)
    view.load_uri(address)
    GLib.timeout_add(int(1000 * PATIENCE_S), Gtk.main_quit)
    Gtk.main()
    return found


def main():
    if len(sys.argv) != 5:
        sys.exit("expected: python3 webkit_page.py ONGGI MAKE_OUTBOX SESSION FOLDER")
    onggi, make_outbox, session, folder = sys.argv[1:]
    os.makedirs(folder, exist_ok=True)
    server, address = served(onggi, make_outbox, session, folder)
    try:
        found = looked_at(address, f"{folder}/webkit.png")
    finally:
        server.terminate()
        server.wait()
    version = f"WebKitGTK {WebKit2.get_major_version()}.{WebKit2.get_minor_version()}.{WebKit2.get_micro_version()}"
    is_good = (found.get("drawn") and found["again"] and not found["ended"] and not found["paused"] and not found["errors"]
               and found["width"] == 480 and abs(found["lasts"] - FILM_S) < 0.01)
    print(f"{version}: {'passed' if is_good else 'FAILED'}: {found}")
    sys.exit(0 if is_good else 1)


main()
