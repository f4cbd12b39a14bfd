#!/usr/bin/env bash
# Package: libpango-1.0-0, libpangoft2-1.0-0, libpangocairo-1.0-0 1.50.12+ds-1 with fonts-nanum 20200506-1 (Debian 12).
# Behaviour: PANGO_WRAP_WORD breaks a line between any two syllables of a Korean word, with the language tag ko, en or
# none. The attribute allow_breaks=false over each word keeps it whole, but not with the default end index (text end).
# Expected: words that spaces separate stay whole in that mode, at least where the text is tagged as Korean, which has
# spaces between its words and is set by them on signs.
# Why it matters: buttons, captions and labels in Korean break in the middle of a word as soon as they wrap.
# Seen:
#   broken words with ko: 1; en: 1; none: 1; without breaks in words: 0, up to the default end: 1
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
cat >words.c <<'CODE'
// words LANGUAGE|- [whole|open]: how many lines of a narrow paragraph end inside a word.
#include <pango/pangocairo.h>
#include <stdio.h>
#include <string.h>
int main(int count, char** arguments) {
    const char* text = "\353\254\274\353\240\210\353\245\274 \353\217\214\353\246\254\353\251\264\354\204\234";  // two words
    PangoContext* context = pango_font_map_create_context(pango_cairo_font_map_get_default());
    PangoLayout* layout = pango_layout_new(context);
    PangoFontDescription* font = pango_font_description_from_string("NanumGothic 20");
    pango_layout_set_font_description(layout, font);
    pango_layout_set_text(layout, text, -1);
    PangoAttrList* attributes = pango_attr_list_new();
    if (strcmp(arguments[1], "-") != 0)
        pango_attr_list_insert(attributes, pango_attr_language_new(pango_language_from_string(arguments[1])));
    if (count > 2) {
        const guint space = (guint)(strchr(text, ' ') - text);
        PangoAttribute* first = pango_attr_allow_breaks_new(FALSE);
        first->end_index = space;
        PangoAttribute* second = pango_attr_allow_breaks_new(FALSE);
        second->start_index = space + 1;
        if (strcmp(arguments[2], "whole") == 0) second->end_index = (guint)strlen(text);
        pango_attr_list_insert(attributes, first);
        pango_attr_list_insert(attributes, second);
    }
    pango_layout_set_attributes(layout, attributes);
    // Room for all but the last two syllables.
    int width, height;
    pango_layout_get_size(layout, &width, &height);
    pango_layout_set_width(layout, width * 3 / 4);
    pango_layout_set_wrap(layout, PANGO_WRAP_WORD);
    int broken = 0;
    for (int line = 0; line + 1 < pango_layout_get_line_count(layout); ++line) {
        const PangoLayoutLine* at = pango_layout_get_line_readonly(layout, line);
        if (text[at->start_index + at->length - 1] != ' ') ++broken;
    }
    printf("%d", broken);
    return 0;
}
CODE
gcc words.c -o words $(pkg-config --cflags pangocairo) "$libraries/libpangocairo-1.0.so.0" "$libraries/libpango-1.0.so.0" \
    $(pkg-config --libs gobject-2.0)
words() { FONTCONFIG_FILE=$PWD/fonts.conf LD_LIBRARY_PATH=$libraries ./words "$@"; }
saw="broken words with ko: $(words ko); en: $(words en); none: $(words -); without breaks in words: $(words ko whole), \
up to the default end: $(words ko open)"
echo "saw: $saw"
[ "$saw" = "broken words with ko: 1; en: 1; none: 1; without breaks in words: 0, \
up to the default end: 1" ]
