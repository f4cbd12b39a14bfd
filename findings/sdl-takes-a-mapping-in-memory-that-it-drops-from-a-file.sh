#!/usr/bin/env bash
# Package: libsdl2-2.0-0, libsdl2-dev 2.26.5+dfsg-1 (Debian 12).
# Behaviour: SDL has two functions for lines of its controller database. The one for a file drops, on Linux, a line for
# Windows, and also one that names no platform, which its format allows; only their count tells. The one for a line takes
# both, also the one for Windows, and uses it.
# Expected: one rule for both: what names another platform is left out, what names none is taken (GLFW does so).
# Why it matters: the same stick has other numbers of axes under Windows. A museum's line for its own stick works while the
# program has it as a text and does nothing once moved to a file, or steers the wheel by another axis.
# Seen:
#   a line: Windows taken, none taken, Linux taken; a file: Windows dropped, none dropped, Linux taken
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
apt-get -qq -o APT::Sandbox::User=root download libsdl2-2.0-0=2.26.5+dfsg-1 libsdl2-dev=2.26.5+dfsg-1
for package in *.deb; do dpkg-deb -x "$package" .; done
libraries=$PWD/usr/lib/x86_64-linux-gnu
cat >map.c <<'CODE'
#include <SDL2/SDL.h>
#include <stdio.h>
static const char* const platforms[] = {"Windows", NULL, "Linux"};
static void line_of(char* line, int size, int number) {
    const char* platform = platforms[number % 3];
    snprintf(line, size, "0300000009120000010000000000%04d,Stick,leftx:a2%s%s,\n", number + 1, platform != NULL ? ",platform:" : "",
             platform != NULL ? platform : "");
}
static void tell(int first) {
    for (int number = first; number < first + 3; ++number) {
        char line[200];
        line_of(line, sizeof line, number);
        line[32] = '\0';
        char* mapping = SDL_GameControllerMappingForGUID(SDL_JoystickGetGUIDFromString(line));
        printf("%s %s%s", platforms[number % 3] != NULL ? platforms[number % 3] : "none", mapping != NULL ? "taken" : "dropped",
               number < first + 2 ? ", " : "");
        SDL_free(mapping);
    }
}
int main(void) {
    if (SDL_Init(SDL_INIT_GAMECONTROLLER) != 0) return 2;
    FILE* file = fopen("sticks.txt", "w");
    for (int number = 0; number < 6; ++number) {
        char line[200];
        line_of(line, sizeof line, number);
        if (number < 3) SDL_GameControllerAddMapping(line);
        else fputs(line, file);
    }
    fclose(file);
    if (SDL_GameControllerAddMappingsFromFile("sticks.txt") < 0) return 2;
    printf("a line: ");
    tell(0);
    printf("; a file: ");
    tell(3);
    return 0;
}
CODE
gcc -Iusr/include -Iusr/include/SDL2 -Iusr/include/x86_64-linux-gnu map.c -o map "$libraries/libSDL2-2.0.so.0" \
    -Wl,--unresolved-symbols=ignore-in-shared-libs
saw=$(LD_LIBRARY_PATH=$libraries ./map)
echo "saw: $saw"
[ "$saw" = "a line: Windows taken, none taken, Linux taken; a file: Windows dropped, none dropped, Linux taken" ]
