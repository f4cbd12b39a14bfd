#include "game/sharing/plain_pages.h"

#include <fmt/format.h>

#include "game/sharing/html_text.h"
#include "page_assets.h"

namespace onggi::sharing {
namespace {

std::string around(const kiosk::Language& first, const std::string& title, const std::string& inside) {
    return fmt::format(
        "<!doctype html>\n<html {}>\n<head>\n<meta charset=\"utf-8\">\n"
        "<meta name=\"viewport\" content=\"width=device-width,initial-scale=1\">\n"
        "<meta name=\"robots\" content=\"noindex\">\n<meta name=\"color-scheme\" content=\"light dark\">\n"
        "<link rel=\"icon\" href=\"data:,\">\n<title>{} · {}</title>\n<style>\n{}</style>\n</head>\n<body>\n"
        "<main>\n{}</main>\n</body>\n</html>\n",
        language_attributes(first.code(), first.right_to_left()), title, html(first.shown("phone.name")),
        built_in::kPlainCss, inside);
}

// What `one` gives for each language, the first one's first.
template <typename One>
std::string in_each(const std::vector<kiosk::Language>& languages, std::size_t first, One one) {
    std::string text = one(languages[first], true);
    for (std::size_t i = 0; i < languages.size(); ++i)
        if (i != first) text += one(languages[i], false);
    return text;
}

}  // namespace

std::string lost_page(const std::vector<kiosk::Language>& languages, std::size_t first) {
    return around(languages[first], html(languages[first].shown("phone.lost")),
                  in_each(languages, first, [](const kiosk::Language& language, bool is_first) {
                      return fmt::format("<section {}>\n<{}>{}</{}>\n<p>{}</p>\n</section>\n",
                                         language_attributes(language.code(), language.right_to_left()),
                                         is_first ? "h1" : "h2", html(language.shown("phone.lost")),
                                         is_first ? "h1" : "h2", html(language.shown("phone.lost.line")));
                  }));
}

std::string ask_page(const std::vector<kiosk::Language>& languages, std::size_t first) {
    const kiosk::Language& own = languages[first];
    const std::string labels = in_each(languages, first, [](const kiosk::Language& language, bool is_first) {
        return fmt::format("<span {} class=\"{}\"><b>{}</b> {}</span>\n",
                           language_attributes(language.code(), language.right_to_left()),
                           is_first ? "ask" : "ask less", html(language.shown("phone.ask")),
                           html(language.shown("phone.ask.line")));
    });
    return around(
        own, html(own.shown("phone.ask")),
        fmt::format(
            "<form id=\"ask\" method=\"get\">\n<label for=\"code\">\n{}</label>\n"
            "<input id=\"code\" name=\"code\" dir=\"ltr\" required maxlength=\"20\" autocomplete=\"off\" "
            "autocapitalize=\"characters\" spellcheck=\"false\">\n<button>{}</button>\n</form>\n"
            "<script src=\"code.js\" defer></script>\n",
            labels, html(own.shown("phone.ask.go"))));
}

std::string_view ask_script() {
    return built_in::kCodeScript;
}

}  // namespace onggi::sharing
