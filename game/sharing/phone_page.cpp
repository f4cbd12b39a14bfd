#include "game/sharing/phone_page.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <utility>

#include "engine/core/quote.h"
#include "page_assets.h"

namespace onggi::sharing {
namespace {

constexpr std::size_t kMostPoints = 160;
constexpr double kMostMm = 2000.0;
constexpr double kOffMm = 0.05;  // of a line with fewer points

bool is_drawn(const OutlinePoint& point) {
    // NaN fails these comparisons.
    return point.radius_mm >= 0.0 && point.radius_mm <= kMostMm && std::abs(point.height_mm) <= kMostMm;
}

double distance_mm(const OutlinePoint& from, const OutlinePoint& to, const OutlinePoint& point) {
    const double across = to.radius_mm - from.radius_mm;
    const double up = to.height_mm - from.height_mm;
    const double length = std::hypot(across, up);
    const double right = point.radius_mm - from.radius_mm;
    const double above = point.height_mm - from.height_mm;
    return length > 0.0 ? std::abs(across * above - up * right) / length : std::hypot(right, above);
}

// At the point's height.
double distance_mm(const AxisPoint& from, const AxisPoint& to, const AxisPoint& point) {
    const double high_mm = to.height_mm - from.height_mm;
    const double up = high_mm > 0.0 ? (point.height_mm - from.height_mm) / high_mm : 0.0;
    return std::hypot(point.x_mm - std::lerp(from.x_mm, to.x_mm, up),
                      point.z_mm - std::lerp(from.z_mm, to.z_mm, up));
}

// The points without which the line is off by more than that (Ramer 1972, Douglas and Peucker 1973).
template <typename Point>
std::vector<Point> within(std::span<const Point> line, double off_mm) {
    std::vector<bool> is_kept(line.size(), false);
    is_kept.front() = is_kept.back() = true;
    std::vector<std::pair<std::size_t, std::size_t>> spans{{0, line.size() - 1}};
    while (!spans.empty()) {
        const auto [first, last] = spans.back();
        spans.pop_back();
        std::size_t farthest = first;
        double most_mm = off_mm;
        for (std::size_t i = first + 1; i < last; ++i) {
            const double far_mm = distance_mm(line[first], line[last], line[i]);
            if (far_mm > most_mm) most_mm = far_mm, farthest = i;
        }
        if (farthest == first) continue;
        is_kept[farthest] = true;
        spans.insert(spans.end(), {{first, farthest}, {farthest, last}});
    }
    std::vector<Point> points;
    for (std::size_t i = 0; i < line.size(); ++i)
        if (is_kept[i]) points.push_back(line[i]);
    return points;
}

std::vector<OutlinePoint> thinned(std::span<const OutlinePoint> outline) {
    const auto end = std::find_if_not(outline.begin(), outline.end(), is_drawn);
    const auto line = outline.first(static_cast<std::size_t>(end - outline.begin()));
    if (line.empty()) return {};
    std::vector<OutlinePoint> points = within(line, kOffMm);
    for (double off_mm = 2.0 * kOffMm; points.size() > kMostPoints; off_mm *= 2.0)
        points = within(line, off_mm);
    return points;
}

double height_of(const std::vector<OutlinePoint>& points) {
    double most = 0.0;
    for (const OutlinePoint& point : points)
        most = std::max(most, point.height_mm);
    return most;
}

double radius_of(const std::vector<OutlinePoint>& points) {
    double most = 0.0;
    for (const OutlinePoint& point : points)
        most = std::max(most, point.radius_mm);
    return most;
}

// Up the right side and down the left.
std::string path_of(const std::vector<OutlinePoint>& points, double middle, double foot, double scale) {
    std::string path;
    const auto add = [&](const OutlinePoint& point, double side) {
        path += fmt::format("{}{:.1f} {:.1f}", path.empty() ? 'M' : 'L',
                            middle + side * point.radius_mm * scale, foot - point.height_mm * scale);
    };
    for (const OutlinePoint& point : points)
        add(point, 1.0);
    for (auto point = points.rbegin(); point != points.rend(); ++point)
        add(*point, -1.0);
    return path + "Z";
}

// A page under construction.
class Page {
  public:
    explicit Page(const PageFacts& facts)
        : facts_(facts),
          pot_(facts.pot),
          language_(facts.languages[facts.language]) {}

    [[nodiscard]] std::string whole() const {
        return fmt::format(
            "<!doctype html>\n<html {}>\n<head>\n{}</head>\n<body>\n{}<main>\n<div class=\"pair\">\n{}<div>\n"
            "<h1>{}</h1>\n{}{}{}</div>\n</div>\n<div class=\"pair\">\n{}<div>\n{}{}</div>\n</div>\n</main>\n"
            "{}</body>\n</html>\n",
            language_attributes(language_.code(), language_.right_to_left()), head(), header(), stage(),
            word("your.title"), glaze(), files(), sizes(), film(), nearest(), end(), script());
    }

  private:
    [[nodiscard]] std::string word(std::string_view key) const { return html(language_.shown(key)); }
    [[nodiscard]] std::string word(std::string_view key, std::string_view number) const {
        return html(language_.shown(key, digits(number)));
    }
    [[nodiscard]] std::string digits(std::string_view number) const {
        return language_.number(number, facts_.own_digits);
    }
    [[nodiscard]] const PotWords& words() const {
        static const PotWords none;
        return facts_.language < pot_.words.size() ? pot_.words[facts_.language] : none;
    }
    // The picture's alternative text: "Your pot, Celadon".
    [[nodiscard]] std::string said() const {
        const std::string& glaze = words().glaze;
        return word("your.title") +
               (glaze.empty() ? "" : std::string(language_.punctuation().comma) + html(glaze));
    }

    [[nodiscard]] std::string head() const {
        return fmt::format(
            "<meta charset=\"utf-8\">\n<meta name=\"viewport\" "
            "content=\"width=device-width,initial-scale=1\">\n"
            "<meta http-equiv=\"Content-Security-Policy\" content=\"{}\">\n"
            "<meta name=\"robots\" content=\"noindex\">\n<meta name=\"referrer\" content=\"no-referrer\">\n"
            "<meta name=\"color-scheme\" content=\"light dark\">\n<title>{} · {}</title>\n"
            "<link rel=\"icon\" href=\"data:,\">\n<link rel=\"stylesheet\" href=\"page.css\">\n",
            kPagePolicy, word("your.title"), word("phone.name"));
    }

    [[nodiscard]] std::string header() const {
        std::string links;
        for (const kiosk::Language& other : facts_.languages) {
            const bool is_here = other.code() == language_.code();
            links += fmt::format("<a href=\"{0}.html\" hreflang=\"{0}\" {1} {2}>{3}</a>\n",
                                 html(other.code()), language_attributes(other.code(), other.right_to_left()),
                                 is_here ? "aria-current=\"page\"" : "", html(other.shown("name")));
        }
        return fmt::format(
            "<header>\n<span class=\"brand\">{}</span>\n<nav aria-label=\"{}\">\n{}</nav>\n</header>\n",
            word("phone.name"), word("lang.title"), links);
    }

    [[nodiscard]] std::string stage() const {
        const PageLinks& links = facts_.links;
        const auto& colour = pot_.colour_linear;
        std::string shape;
        if (pot_.outside.size() > 1) {
            shape = fmt::format(
                " data-outside=\"{}\" data-inside=\"{}\" data-surface=\"{}\" data-colour=\"{:.3f} {:.3f} "
                "{:.3f}\" "
                "data-gloss=\"{:.2f}\" data-say=\"{}. {}\" data-stop=\"{}\" data-go=\"{}\"",
                outline_numbers(pot_.outside), outline_numbers(pot_.inside), html(links.surface), colour[0],
                colour[1], colour[2], pot_.gloss, said(), word("phone.turn"), word("phone.stop"),
                word("phone.go"));
        }
        if (!pot_.axis.empty() && !shape.empty()) {
            shape += fmt::format(" data-reach=\"{:.2f}\" data-axis=\"{}\" data-dents=\"{}\"", pot_.reach_mm,
                                 axis_numbers(pot_.axis), dent_numbers(pot_.dents_mm));
        }
        const std::string poster =
            links.poster.empty() ? ""
                                 : fmt::format("<img src=\"{}\" alt=\"{}\">\n", html(links.poster), said());
        return fmt::format("<div class=\"stage\" id=\"stage\"{}>\n{}</div>\n", shape, poster);
    }

    [[nodiscard]] std::string glaze() const {
        return words().glaze.empty() ? "" : fmt::format("<p class=\"glaze\">{}</p>\n", html(words().glaze));
    }

    [[nodiscard]] std::string save_link(std::string_view name, std::string_view label, std::string_view kind,
                                        std::string_view look = "") const {
        const std::string_view ending = name.substr(name.rfind('.'));
        const std::string_view arrow =
            look.empty()
                ? std::string_view()
                : "<svg viewBox=\"0 0 64 64\" aria-hidden=\"true\"><path d=\"M32 8v32M18 28l14 14 14-14M10 "
                  "56h44\"/></svg>";
        const std::string small =
            kind.empty() ? "" : fmt::format(" <small dir=\"ltr\">{}</small>", html(kind));
        return fmt::format(
            "<a class=\"token{}\" href=\"{}\" download=\"onggi-{}{}\">{}<span>{}{}</span></a>\n", look, name,
            facts_.code.text(), ending, arrow, label, small);
    }

    [[nodiscard]] std::string files() const {
        std::string links;
        if (!facts_.links.picture.empty())
            links += save_link(facts_.links.picture, word("phone.pic"), "", " first");
        links += share_button();
        if (pot_.film.is_given()) {
            links += save_link(pot_.film_mp4.is_given() ? "film.mp4" : "film.webp",
                               word("phone.film", fmt::format("{:.0f}", std::ceil(pot_.film_s))), "");
        }
        if (pot_.model_glb.is_given()) links += save_link("pot.glb", word("phone.glb"), "");
        if (pot_.print_stl.is_given()) links += save_link("pot.stl", word("phone.print"), "STL");
        if (pot_.print_3mf.is_given()) links += save_link("pot.3mf", word("phone.print"), "3MF");
        links += augmented();
        if (links.empty()) return {};
        const std::string note = pot_.print_stl.is_given()
                                     ? fmt::format("<p class=\"note\">{}</p>\n", word("phone.print.line"))
                                     : "";
        return "<div class=\"files\">\n" + links + "</div>\n" +
               fmt::format("<p class=\"note\" id=\"iphone\" hidden>{}</p>\n", word("phone.iphone")) + note +
               drawings();
    }

    // Behind a fold, because few want it.
    [[nodiscard]] std::string drawings() const {
        std::string links;
        if (pot_.drawing_pdf.is_given()) links += save_link("pot.pdf", word("phone.drawing"), "PDF");
        if (pot_.drawing_svg.is_given()) links += save_link("pot.svg", word("phone.drawing"), "SVG");
        if (pot_.measures_json.is_given()) links += save_link("pot.json", word("phone.measures"), "JSON");
        if (links.empty()) return {};
        return fmt::format("<details>\n<summary>{}</summary>\n<div class=\"files\">\n{}</div>\n</details>\n",
                           word("phone.more"), links);
    }

    [[nodiscard]] bool is_https() const { return facts_.page_url.starts_with("https://"); }

    // Browsers share files of secure pages only; the script shows the button if the phone does so.
    [[nodiscard]] std::string share_button() const {
        if (!is_https() || facts_.links.picture.empty()) return {};
        return fmt::format(
            "<button class=\"token\" id=\"share\" type=\"button\" hidden><span>{}</span></button>\n",
            word("phone.share"));
    }

    // Links to Android's Scene Viewer and to iOS's AR Quick Look, by https only. The script shows the one
    // whose viewer the phone has.
    [[nodiscard]] std::string augmented() const {
        if (!is_https()) return {};
        std::string links;
        if (pot_.model_usdz.is_given()) {
            links = fmt::format(
                "<a class=\"token\" id=\"room\" hidden rel=\"ar\" href=\"pot.usdz\"><span>{}</span></a>\n",
                word("phone.ar"));
        }
        if (!pot_.model_glb.is_given()) return links;
        return links + fmt::format(
                           "<a class=\"token\" id=\"ar\" hidden "
                           "href=\"intent://arvr.google.com/scene-viewer/1.0?file={0}pot.glb"
                           "&amp;mode=ar_preferred#Intent;scheme=https;package=com.google.android."
                           "googlequicksearchbox;"
                           "action=android.intent.action.VIEW;S.browser_fallback_url={0};end;\"><span>{1}</"
                           "span></a>\n",
                           html(facts_.page_url), word("phone.ar"));
    }

    [[nodiscard]] std::string size(std::string_view key, double value, int decimals,
                                   std::string_view unit_key) const {
        if (!(value > 0.0)) return {};
        return fmt::format("<div><dt>{}</dt><dd><bdi>{}</bdi>\u00a0<i>{}</i></dd></div>\n", word(key),
                           html(digits(fmt::format("{:.{}f}", value, decimals))), word(unit_key));
    }

    [[nodiscard]] std::string sizes() const {
        const double litres = pot_.capacity_ml / 1000.0;
        const std::string rows = size("your.h", pot_.height_mm, 0, "unit.mm") +
                                 size("your.w", pot_.width_mm, 0, "unit.mm") +
                                 size("your.wt", pot_.mass_g, 0, "unit.g") +
                                 size("your.cap", litres, litres < 1.0 ? 2 : 1, "unit.l");
        return rows.empty() ? "" : "<dl class=\"card\">\n" + rows + "</dl>\n";
    }

    [[nodiscard]] std::string film() const {
        if (!pot_.film.is_given()) return {};
        const std::string still =
            facts_.links.film_still.empty()
                ? ""
                : fmt::format("<img src=\"{}\" alt=\"\" loading=\"lazy\">\n", html(facts_.links.film_still));
        const std::string animation = fmt::format(
            "<a class=\"film\" id=\"film\" href=\"film.webp\" data-seconds=\"{:.1f}\">\n{}"
            "<span class=\"token play\"><span>{}</span></span></a>\n",
            pot_.film_s, still, word("phone.play"));
        if (!pot_.film_mp4.is_given()) return animation;
        // The script starts it once the page stands, unless the phone saves data or wants less motion.
        return fmt::format(
            "<video class=\"film\" id=\"video\" playsinline muted loop controls preload=\"none\" "
            "poster=\"{}\" "
            "aria-label=\"{}\">\n<source src=\"film.mp4\" type=\"video/mp4\">\n{}</video>\n",
            html(facts_.links.film_still), word("phone.play"), animation);
    }

    [[nodiscard]] std::string nearest() const {
        if (words().nearest_name.empty()) return {};
        const TwoPots two = two_pots(pot_.outside, pot_.nearest_outside);
        const std::string scale = two.times_as_tall > 0.0
                                      ? word("your.size", fmt::format("{:.1f}", two.times_as_tall))
                                      : word("your.scale");
        return fmt::format(
            "<section class=\"card near\">\n{}\n<div><h2><small>{}</small> "
            "{}</h2>\n<p>{}{}</p></div>\n</section>\n",
            two.svg, word("your.near"), html(words().nearest_name), html(words().nearest_line),
            two.svg.empty() ? "" : "\n" + scale);
    }

    [[nodiscard]] std::string end() const {
        return fmt::format("<p class=\"end\"><b>{}</b><br>{}</p>\n",
                           word(facts_.is_gone_today ? "phone.gone" : "phone.gone.later", facts_.gone_at),
                           word("phone.priv"));
    }

    [[nodiscard]] static std::string script() { return "<script src=\"pot.js\" defer></script>\n"; }

    const PageFacts& facts_;
    const SharedPot& pot_;
    const kiosk::Language& language_;
};

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

// Concatenates the results of `one` for each language, starting with `first`.
template <typename One>
std::string in_each(const std::vector<kiosk::Language>& languages, std::size_t first, One one) {
    std::string text = one(languages[first], true);
    for (std::size_t i = 0; i < languages.size(); ++i)
        if (i != first) text += one(languages[i], false);
    return text;
}

}  // namespace

std::string html(std::string_view text) {
    std::string safe;
    safe.reserve(text.size() + text.size() / 8);
    while (!text.empty()) {
        std::size_t length = 1;
        switch (text.front()) {
            case '&':
                safe += "&amp;";
                break;
            case '<':
                safe += "&lt;";
                break;
            case '>':
                safe += "&gt;";
                break;
            case '"':
                safe += "&quot;";
                break;
            case '\n':
                safe += '\n';
                break;
            case '\'':
                safe += "&#39;";
                break;
            default: {
                // U+00A0 to U+00BF start with the same byte as control characters, but are printable.
                const bool is_latin = text.size() > 1 && text[0] == '\xc2' &&
                                      static_cast<unsigned char>(text[1]) >= 0xa0 &&
                                      static_cast<unsigned char>(text[1]) <= 0xbf;
                length = is_latin ? 2 : shown_character_length(text);
                safe += length > 0 ? text.substr(0, length) : std::string_view("\ufffd");
                if (length == 0) length = 1;
            }
        }
        text.remove_prefix(length);
    }
    return safe;
}

std::string language_attributes(std::string_view code, bool right_to_left) {
    return fmt::format("lang=\"{}\" dir=\"{}\"", html(code), right_to_left ? "rtl" : "ltr");
}

std::string outline_numbers(std::span<const OutlinePoint> outline) {
    std::string text;
    for (const OutlinePoint& point : thinned(outline)) {
        if (!text.empty()) text += ' ';
        // In the shortest form: 54.2, 5.
        const auto tenth = [](double value) { return std::round(value * 10.0) / 10.0 + 0.0; };
        text += fmt::format("{},{}", tenth(point.radius_mm), tenth(point.height_mm));
    }
    return text;
}

namespace {

void append_twentieths(std::string& text, std::initializer_list<double> lengths_mm) {
    for (const double mm : lengths_mm) {
        if (!text.empty() && text.back() != ' ') text += ',';
        text += fmt::format("{}", std::lround(std::clamp(mm, -kMostMm, kMostMm) * 20.0));
    }
}

}  // namespace

std::string axis_numbers(std::span<const AxisPoint> axis) {
    if (axis.empty()) return {};
    std::string text;
    for (const AxisPoint& point : within(axis, kOffMm)) {
        if (!text.empty()) text += ' ';
        append_twentieths(text, {point.height_mm, point.x_mm, point.z_mm});
    }
    return text;
}

std::string dent_numbers(std::span<const std::vector<double>> rows_mm) {
    std::string text;
    for (const std::vector<double>& row : rows_mm) {
        if (!text.empty()) text += ' ';
        for (const double dent_mm : row)
            append_twentieths(text, {dent_mm});
    }
    return text;
}

TwoPots two_pots(std::span<const OutlinePoint> ours, std::span<const OutlinePoint> nearest) {
    constexpr double kWidth = 132.0;
    constexpr double kHeight = 112.0;
    constexpr double kBoard = 4.0;
    constexpr double kGap = 10.0;
    const auto our_points = thinned(ours);
    const auto their_points = thinned(nearest);
    if (our_points.size() < 2 || their_points.size() < 2) return {};
    const auto size_of = [](const auto& points) {
        return std::max(height_of(points), 2.0 * radius_of(points));
    };
    if (size_of(our_points) <= 0.0 || size_of(their_points) <= 0.0) return {};
    const double their_share = std::min(1.0, size_of(our_points) / size_of(their_points));
    const double wide = 2.0 * (radius_of(our_points) + radius_of(their_points) * their_share);
    const double high = std::max(height_of(our_points), height_of(their_points) * their_share);
    const double scale = std::min((kWidth - kGap) / wide, (kHeight - kBoard - 2.0) / high);
    const double their_scale = scale * their_share;
    const double left = (kWidth - kGap - wide * scale) / 2.0;
    const double foot = kHeight - kBoard;
    const double our_middle = left + radius_of(our_points) * scale;
    const double their_middle = kWidth - left - radius_of(their_points) * their_scale;
    std::string svg = fmt::format(
        "<svg viewBox=\"0 0 {0} {1}\" aria-hidden=\"true\"><path class=\"ours\" d=\"{2}\"/>"
        "<path class=\"theirs\" d=\"{3}\"/><path class=\"board\" d=\"M0 {4}H{0}\"/></svg>",
        kWidth, kHeight, path_of(our_points, our_middle, foot, scale),
        path_of(their_points, their_middle, foot, their_scale), kHeight - kBoard / 2.0);
    const double times = height_of(their_points) / std::max(1.0, height_of(our_points));
    return {.svg = std::move(svg), .times_as_tall = their_share < 1.0 ? times : 0.0};
}

std::string phone_page(const PageFacts& facts) {
    return Page(facts).whole();
}

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
        fmt::format("<form id=\"ask\" method=\"get\">\n<label for=\"code\">\n{}</label>\n"
                    "<input id=\"code\" name=\"code\" type=\"text\" dir=\"ltr\" required maxlength=\"20\" "
                    "autocomplete=\"off\" "
                    "autocapitalize=\"characters\" spellcheck=\"false\">\n<button>{}</button>\n</form>\n"
                    "<script src=\"code.js\" defer></script>\n",
                    labels, html(own.shown("phone.ask.go"))));
}

std::string_view ask_script() {
    return built_in::kCodeScript;
}

}  // namespace onggi::sharing
