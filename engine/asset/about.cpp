#include "engine/asset/about.h"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>

#include "engine/asset/image.h"
#include "engine/asset/mp4_film.h"
#include "engine/asset/utf8.h"

namespace onggi::asset {
namespace {

// XMP wants the default of a language alternative first, tagged x-default.
std::string in_languages(std::string_view term, const Wordings& wordings) {
    if (wordings.empty()) return {};
    const auto item = [](std::string_view language, const std::string& text) {
        return fmt::format("<rdf:li xml:lang=\"{}\">{}</rdf:li>", language, xml_text(text));
    };
    std::string items = item("x-default", wordings.front().text);
    for (const Wording& one : wordings)
        items += item(xml_text(one.language), one.text);
    return fmt::format("<dc:{0}><rdf:Alt>{1}</rdf:Alt></dc:{0}>\n", term, items);
}

std::string list_of(std::string_view term, std::string_view kind, const std::vector<std::string>& texts) {
    std::string items;
    for (const std::string& text : texts)
        if (!text.empty()) items += "<rdf:li>" + xml_text(text) + "</rdf:li>";
    if (items.empty()) return {};
    return fmt::format("<dc:{0}><rdf:{1}>{2}</rdf:{1}></dc:{0}>\n", term, kind, items);
}

std::string one_of(std::string_view name, const std::string& text) {
    return text.empty() ? "" : fmt::format("<{0}>{1}</{0}>\n", name, xml_text(text));
}

}  // namespace

std::string first_of(const Wordings& wordings) {
    return wordings.empty() ? std::string() : wordings.front().text;
}

std::vector<std::string> texts_of(const Wordings& wordings) {
    std::vector<std::string> texts;
    for (const Wording& one : wordings)
        if (std::find(texts.begin(), texts.end(), one.text) == texts.end()) texts.push_back(one.text);
    return texts;
}

std::string About::copyright() const {
    const std::string who = first_of(publisher);
    const std::string what = first_of(rights);
    return who.empty() || what.empty() ? who + what : who + ". " + what;
}

std::string xmp_packet(const About& about) {
    return fmt::format(
        "<?xpacket begin=\"\uFEFF\" id=\"W5M0MpCehiHzreSzNTczkc9d\"?>\n"
        "<x:xmpmeta xmlns:x=\"adobe:ns:meta/\">\n"
        "<rdf:RDF xmlns:rdf=\"http://www.w3.org/1999/02/22-rdf-syntax-ns#\">\n"
        "<rdf:Description rdf:about=\"\" xmlns:dc=\"http://purl.org/dc/elements/1.1/\" "
        "xmlns:xmp=\"http://ns.adobe.com/xap/1.0/\">\n"
        "{}{}{}{}{}{}{}{}</rdf:Description>\n</rdf:RDF>\n</x:xmpmeta>\n<?xpacket end=\"r\"?>",
        in_languages("title", about.title), in_languages("description", about.description),
        in_languages("rights", about.rights), list_of("publisher", "Bag", texts_of(about.publisher)),
        list_of("date", "Seq", {about.date}), one_of("dc:identifier", about.identifier),
        list_of("relation", "Bag", {about.relation}), one_of("xmp:CreatorTool", about.tool));
}

namespace {

// In <metadata> (SVG 1.1, 21).
Result<std::vector<std::byte>> svg_with_about(std::string_view svg, const About& about) {
    const std::size_t root = svg.find("<svg");
    const std::size_t inside = svg.find('>', root);
    if (root == std::string_view::npos || inside == std::string_view::npos)
        return bad_input("SVG: expected a drawing, found another document");
    std::string told(svg.substr(0, inside + 1));
    told += fmt::format("\n<title>{}</title>\n<metadata>{}</metadata>", xml_text(first_of(about.title)),
                        xmp_packet(about));
    told += svg.substr(inside + 1);
    const auto* const first = reinterpret_cast<const std::byte*>(told.data());
    return std::vector<std::byte>(first, first + told.size());
}

}  // namespace

Result<std::vector<std::byte>> picture_about(std::span<const std::byte> picture, const About& about) {
    const std::string_view bytes(reinterpret_cast<const char*>(picture.data()), picture.size());
    if (bytes.substr(0, 8).ends_with("ftyp")) return mp4_with_about(picture, about);
    if (bytes.starts_with("<?xml")) return svg_with_about(bytes, about);
    const std::string xmp = xmp_packet(about);
    return bytes.starts_with('\x89') ? png_with_xmp(picture, xmp) : webp_with_xmp(picture, xmp);
}

}  // namespace onggi::asset
