#!/usr/bin/env bash
# Package: libpango-1.0-0, libpangoft2-1.0-0, libpangocairo-1.0-0 1.50.12+ds-1 with fonts-nanum 20200506-1 (Debian 12).
# Behaviour: Pango has fontconfig sort all fonts once for each size of a text in the same family and style. The same
# word measured in twenty sizes costs twenty sorts, and again in those sizes none.
# Expected: one sort: a scalable font of one family is the same file in every size.
# Why it matters: a layout that searches the largest size that fits, a growing caption or a zoom costs a sort of the
# machine's fonts a step, milliseconds each with many fonts. Measure at one size and scale the result.
# Seen:
#   sorts in one size: 1; in twenty more sizes: 20; in those again: 0
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
version=1.50.12+ds-1
apt-get -qq -o APT::Sandbox::User=root download "libpango-1.0-0=$version" "libpangoft2-1.0-0=$version" \
    "libpangocairo-1.0-0=$version" fonts-nanum=20200506-1
for package in *.deb; do dpkg-deb -x "$package" .; done
libraries=$PWD/usr/lib/x86_64-linux-gnu
cat >fonts.conf <<CONF
<?xml version="1.0"?><!DOCTYPE fontconfig SYSTEM "fonts.dtd">
<fontconfig><dir>$PWD/usr/share/fonts</dir><cachedir>$PWD/cache</cachedir></fontconfig>
CONF
cat >sorts.c <<'CODE'
#define _GNU_SOURCE
#include <dlfcn.h>
#include <fontconfig/fontconfig.h>
#include <pango/pangocairo.h>
#include <stdio.h>
static int sorts;
// The program's own function goes before fontconfig's, also for Pango.
FcFontSet* FcFontSetSort(FcConfig* config, FcFontSet** sets, int count, FcPattern* wish, FcBool trim, FcCharSet** letters,
                         FcResult* result) {
    ++sorts;
    FcFontSet* (*real)(FcConfig*, FcFontSet**, int, FcPattern*, FcBool, FcCharSet**, FcResult*) =
        (FcFontSet * (*)(FcConfig*, FcFontSet**, int, FcPattern*, FcBool, FcCharSet**, FcResult*)) dlsym(RTLD_NEXT, "FcFontSetSort");
    return real(config, sets, count, wish, trim, letters, result);
}
static int measure(PangoContext* context, int first_px, int last_px) {
    sorts = 0;
    for (int size_px = first_px; size_px <= last_px; ++size_px) {
        PangoLayout* layout = pango_layout_new(context);
        PangoFontDescription* font = pango_font_description_from_string("NanumGothic");
        pango_font_description_set_absolute_size(font, size_px * PANGO_SCALE);
        pango_layout_set_font_description(layout, font);
        pango_layout_set_text(layout, "Wheel", -1);
        int width, height;
        pango_layout_get_size(layout, &width, &height);
        pango_font_description_free(font);
        g_object_unref(layout);
    }
    return sorts;
}
int main(void) {
    PangoContext* context = pango_font_map_create_context(pango_cairo_font_map_get_default());
    const int one = measure(context, 20, 20);
    const int more = measure(context, 21, 40);
    printf("sorts in one size: %d; in twenty more sizes: %d; in those again: %d", one, more, measure(context, 21, 40));
    return 0;
}
CODE
gcc -rdynamic sorts.c -o sorts $(pkg-config --cflags pangocairo) "$libraries/libpangocairo-1.0.so.0" \
    "$libraries/libpango-1.0.so.0" $(pkg-config --libs gobject-2.0) -ldl
saw=$(FONTCONFIG_FILE=$PWD/fonts.conf LD_LIBRARY_PATH=$libraries ./sorts)
echo "saw: $saw"
[ "$saw" = "sorts in one size: 1; in twenty more sizes: 20; in those again: 0" ]
