// See gltf_read.h. tinygltf parses; this file checks what tinygltf does not. Any thread.
#include "engine/asset/gltf_read.h"

#include <fmt/format.h>
#include <tiny_gltf.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <exception>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include "engine/asset/mesh_rules.h"
#include "engine/asset/utf8.h"
#include "engine/core/little_endian.h"
#include "engine/core/quote.h"
#include "engine/core/result.h"

namespace tinygltf {
class Model;
}

namespace onggi::asset {
namespace {

// Reads numbers from a glTF accessor, with bounds checks. Any thread.

// The location of an accessor's elements, all inside their buffer.
struct Elements {
    const unsigned char* first = nullptr;
    std::size_t count = 0;
    std::size_t stride = 0;  // bytes from one to the next
    int component_type = 0;
    int width = 0;
    bool normalised = false;
};

// tinygltf's indices: -1, or any index beyond the list, means none.
template <typename T>
const T* at(const std::vector<T>& list, int index) {
    return index >= 0 && static_cast<std::size_t>(index) < list.size()
               ? &list[static_cast<std::size_t>(index)]
               : nullptr;
}

Result<Elements> locate(const tinygltf::Model& model, int index, std::size_t max_count) {
    const tinygltf::Accessor* accessor = at(model.accessors, index);
    if (accessor == nullptr) return bad_input(fmt::format("accessor {}: expected one, found none", index));
    const auto wrong = [&](std::string_view expected) {
        return bad_input(fmt::format("accessor {}: expected {}", index, expected));
    };
    if (accessor->sparse.isSparse) return wrong("whole data, found sparse");
    const tinygltf::BufferView* view = at(model.bufferViews, accessor->bufferView);
    if (view == nullptr) return wrong("a buffer view, found none");
    const tinygltf::Buffer* buffer = at(model.buffers, view->buffer);
    if (buffer == nullptr) return wrong("a buffer, found none");

    const int component_bytes =
        tinygltf::GetComponentSizeInBytes(static_cast<std::uint32_t>(accessor->componentType));
    const int width = tinygltf::GetNumComponentsInType(static_cast<std::uint32_t>(accessor->type));
    if (component_bytes < 1 || width < 1) return wrong("numbers, found another type");
    const auto element_bytes = static_cast<std::size_t>(component_bytes) * static_cast<std::size_t>(width);
    const std::size_t stride = view->byteStride == 0 ? element_bytes : view->byteStride;
    if (accessor->count < 1 || accessor->count > max_count) {
        return wrong(fmt::format("1 to {} elements, found {}", max_count, accessor->count));
    }
    constexpr std::size_t kMaxStride = 252;  // glTF 2.0, section 5.11
    if (stride < element_bytes || stride > kMaxStride) return wrong("elements that do not overlap");
    // Offsets have 64 bits and any value: subtract from the size instead of adding, to avoid overflow.
    const std::size_t held = buffer->data.size();
    const std::size_t needed = (accessor->count - 1) * stride + element_bytes;
    const bool is_inside = view->byteOffset <= held && view->byteLength <= held - view->byteOffset &&
                           accessor->byteOffset <= view->byteLength &&
                           needed <= view->byteLength - accessor->byteOffset;
    if (!is_inside) return wrong("data inside its buffer, found it reaching past the end");
    return Elements{.first = buffer->data.data() + view->byteOffset + accessor->byteOffset,
                    .count = accessor->count,
                    .stride = stride,
                    .component_type = accessor->componentType,
                    .width = width,
                    .normalised = accessor->normalized};
}

template <typename T>
T load(const unsigned char* from) {
    T value;
    std::memcpy(&value, from, sizeof value);
    return value;
}

template <typename T>
float scaled(const unsigned char* from, bool normalised) {
    const auto value = static_cast<float>(load<T>(from));
    return normalised ? value / static_cast<float>(std::numeric_limits<T>::max()) : value;
}

// Returns the numbers per element; 0 if there is no such accessor.
int accessor_width(const tinygltf::Model& model, int accessor) {
    const tinygltf::Accessor* found = at(model.accessors, accessor);
    return found == nullptr
               ? 0
               : std::max(0, tinygltf::GetNumComponentsInType(static_cast<std::uint32_t>(found->type)));
}

// Reads the elements of `accessor`, each of `width` numbers (1 to 4), into one list. Integers are kept, or
// scaled to 0 to 1 if the accessor is normalised. Errors have no file name yet.
Result<std::vector<float>> read_floats(const tinygltf::Model& model, int accessor, int width,
                                       std::size_t max_count) {
    const auto located = locate(model, accessor, max_count);
    if (!located) return located.error();
    if (located->width != width) {
        return bad_input(fmt::format("accessor {}: expected {} numbers an element, found {}", accessor, width,
                                     located->width));
    }
    std::vector<float> numbers;
    numbers.reserve(located->count * static_cast<std::size_t>(width));
    for (std::size_t i = 0; i < located->count; ++i) {
        const unsigned char* element = located->first + i * located->stride;
        for (std::size_t k = 0; k < static_cast<std::size_t>(width); ++k) {
            switch (located->component_type) {
                case TINYGLTF_COMPONENT_TYPE_FLOAT:
                    numbers.push_back(load<float>(element + 4 * k));
                    break;
                case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE:
                    numbers.push_back(scaled<std::uint8_t>(element + k, located->normalised));
                    break;
                case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT:
                    numbers.push_back(scaled<std::uint16_t>(element + 2 * k, located->normalised));
                    break;
                default:
                    return bad_input(fmt::format(
                        "accessor {}: expected floats or unsigned 8 or 16 bit numbers, found type {}",
                        accessor, located->component_type));
            }
        }
    }
    return numbers;
}

// Unsigned scalars of 8, 16 or 32 bits.
Result<std::vector<std::uint32_t>> read_indices(const tinygltf::Model& model, int accessor,
                                                std::size_t max_count) {
    const auto located = locate(model, accessor, max_count);
    if (!located) return located.error();
    if (located->width != 1) {
        return bad_input(fmt::format("accessor {}: expected scalar indices, found another type", accessor));
    }
    std::vector<std::uint32_t> indices;
    indices.reserve(located->count);
    for (std::size_t i = 0; i < located->count; ++i) {
        const unsigned char* element = located->first + i * located->stride;
        switch (located->component_type) {
            case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE:
                indices.push_back(load<std::uint8_t>(element));
                break;
            case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT:
                indices.push_back(load<std::uint16_t>(element));
                break;
            case TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT:
                indices.push_back(load<std::uint32_t>(element));
                break;
            default:
                return bad_input(fmt::format("accessor {}: expected unsigned indices, found type {}",
                                             accessor, located->component_type));
        }
    }
    return indices;
}

constexpr std::size_t kGlbHeaderBytes = 20;  // headers of the file and of its first chunk

std::uint32_t word_at(std::span<const std::byte> bytes, std::size_t offset) {
    return little_endian::get<std::uint32_t>(bytes.data() + offset);
}

// The library parses JSON recursively: deeper nesting than any glTF needs must not reach it.
bool nests_deeper_than(std::span<const std::byte> json, int max_depth) {
    int depth = 0;
    bool in_string = false;
    for (std::size_t i = 0; i < json.size(); ++i) {
        const auto c = std::to_integer<char>(json[i]);
        if (in_string) {
            if (c == '\\') ++i;
            if (c == '"') in_string = false;
            continue;
        }
        if (c == '"') in_string = true;
        if (c == '{' || c == '[') ++depth;
        if (c == '}' || c == ']') --depth;
        if (depth > max_depth) return true;
    }
    return false;
}

Result<void> check_header(std::span<const std::byte> bytes, const GltfLimits& limits) {
    constexpr std::uint32_t kMagic = 0x46546C67;  // "glTF"
    if (bytes.size() > limits.max_bytes) {
        return bad_input(fmt::format("expected at most {} bytes, found {}", limits.max_bytes, bytes.size()));
    }
    if (bytes.size() < kGlbHeaderBytes || word_at(bytes, 0) != kMagic || word_at(bytes, 4) != 2) {
        return bad_input("expected a binary glTF 2.0, found another kind of file");
    }
    if (word_at(bytes, 8) != bytes.size()) {
        return bad_input(
            fmt::format("expected {} bytes as its header says, found {}", word_at(bytes, 8), bytes.size()));
    }
    const std::size_t json_bytes = word_at(bytes, 12);
    if (json_bytes > bytes.size() - kGlbHeaderBytes) {
        return bad_input("expected its JSON inside the file, found it reaching past the end");
    }
    if (nests_deeper_than(bytes.subspan(kGlbHeaderBytes, json_bytes), limits.max_depth)) {
        return bad_input(fmt::format("expected JSON of at most {} levels, found more", limits.max_depth));
    }
    return {};
}

// Opens no other file, whatever the URIs say.
tinygltf::FsCallbacks no_files() {
    tinygltf::FsCallbacks callbacks{};
    callbacks.FileExists = [](const std::string&, void*) { return false; };
    callbacks.ExpandFilePath = [](const std::string&, void*) { return std::string(); };
    callbacks.ReadWholeFile = [](std::vector<unsigned char>*, std::string* problem, const std::string&,
                                 void*) {
        if (problem != nullptr) *problem = "it refers to another file";
        return false;
    };
    callbacks.WriteWholeFile = [](std::string*, const std::string&, const std::vector<unsigned char>&,
                                  void*) { return false; };
    return callbacks;
}

// The first line of the library's message.
std::string first_line(std::string text) {
    const std::size_t start = text.find_first_not_of(" \n\r\t");
    if (start == std::string::npos) return "no reason given";
    text.erase(0, start);
    constexpr std::size_t kReadable = 200;
    return valid_utf8(text.substr(0, std::min(text.find_first_of("\n\r"), kReadable)));
}

Result<tinygltf::Model> parse(std::span<const std::byte> bytes) {
    tinygltf::Model model;
    tinygltf::TinyGLTF reader;
    reader.SetFsCallbacks(no_files());
    reader.SetImageLoader([](tinygltf::Image*, int, std::string*, std::string*, int, int,
                             const unsigned char*, int, void*) { return true; },
                          nullptr);
    std::string problem;
    std::string warning;
    try {
        if (reader.LoadBinaryFromMemory(&model, &problem, &warning,
                                        reinterpret_cast<const unsigned char*>(bytes.data()),
                                        static_cast<unsigned int>(bytes.size()))) {
            return model;
        }
    } catch (const std::exception& thrown) {
        problem = thrown.what();
    }
    return bad_input(fmt::format("expected a glTF scene, found a damaged one: {}", first_line(problem)));
}

// Reads a material (glTF 2.0, section 3.9.2), with values clamped to their ranges.
Material material_of(const tinygltf::Material& from) {
    const tinygltf::PbrMetallicRoughness& pbr = from.pbrMetallicRoughness;
    const auto fraction = [](double value) {
        return std::isfinite(value) ? std::clamp(value, 0.0, 1.0) : 1.0;
    };
    Material material{.name = valid_utf8(from.name),
                      .base_colour_linear = dvec3(1.0),
                      .roughness = fraction(pbr.roughnessFactor),
                      .metallic = fraction(pbr.metallicFactor)};
    for (int i = 0; i < 3 && static_cast<std::size_t>(i) < pbr.baseColorFactor.size(); ++i)
        material.base_colour_linear[i] = fraction(pbr.baseColorFactor[static_cast<std::size_t>(i)]);
    return material;
}

// The node's local transform (glTF 2.0, section 5.25): a matrix, or translation, rotation and scale.
dmat4 place_of(const tinygltf::Node& node) {
    dmat4 place(1.0);
    if (node.matrix.size() == 16) {
        for (int column = 0; column < 4; ++column)
            for (int row = 0; row < 4; ++row)
                place[column][row] = node.matrix[static_cast<std::size_t>(4 * column + row)];
        return place;
    }
    if (node.translation.size() == 3)
        place = glm::translate(place, dvec3(node.translation[0], node.translation[1], node.translation[2]));
    if (node.rotation.size() == 4) {
        place *=
            glm::mat4_cast(dquat(node.rotation[3], node.rotation[0], node.rotation[1], node.rotation[2]));
    }
    if (node.scale.size() == 3) place = glm::scale(place, dvec3(node.scale[0], node.scale[1], node.scale[2]));
    return place;
}

// Computes vertex normals, weighted by the area of the adjacent faces.
void make_normals(Mesh& mesh) {
    std::vector<dvec3> sums(mesh.positions_m.size(), dvec3(0.0));
    for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
        const dvec3 a(mesh.positions_m[mesh.indices[i]]);
        const dvec3 b(mesh.positions_m[mesh.indices[i + 1]]);
        const dvec3 c(mesh.positions_m[mesh.indices[i + 2]]);
        for (std::size_t k = 0; k < 3; ++k)
            sums[mesh.indices[i + k]] += glm::cross(b - a, c - a);
    }
    mesh.normals.clear();
    for (const dvec3& sum : sums) {
        const double length = glm::length(sum);
        mesh.normals.emplace_back(length > 0.0 ? sum / length : dvec3(0.0, 1.0, 0.0));
    }
}

void place_mesh(Mesh& mesh, const dmat4& place) {
    // Normals transform by the inverse transpose; a singular matrix has no inverse, and then they are
    // unchanged.
    const dmat3 linear(place);
    const double volume = glm::determinant(linear);
    const dmat3 turn = volume != 0.0 ? glm::transpose(glm::inverse(linear)) : dmat3(1.0);
    for (vec3& position : mesh.positions_m)
        position = vec3(place * dvec4(dvec3(position), 1.0));
    for (vec3& normal : mesh.normals) {
        const dvec3 turned = turn * dvec3(normal);
        const double length = glm::length(turned);
        normal = length > 0.0 ? vec3(turned / length) : vec3(0.0F, 1.0F, 0.0F);
    }
    if (volume < 0.0) {
        for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3)
            std::swap(mesh.indices[i + 1], mesh.indices[i + 2]);
    }
}

std::vector<vec3> vectors_of(const std::vector<float>& numbers) {
    std::vector<vec3> vectors;
    vectors.reserve(numbers.size() / 3);
    for (std::size_t i = 0; i + 2 < numbers.size(); i += 3)
        vectors.emplace_back(numbers[i], numbers[i + 1], numbers[i + 2]);
    return vectors;
}

// Walks the scene and collects its primitives within the limits.
class Gathering {
  public:
    Gathering(const tinygltf::Model& model, const GltfLimits& limits) : model_(model), limits_(limits) {}

    Result<std::vector<GltfPart>> gather() {
        const auto scene = static_cast<std::size_t>(std::max(model_.defaultScene, 0));
        if (!model_.scenes.empty() && scene >= model_.scenes.size())
            return bad_input("expected a scene, found none");
        for (const int node : model_.scenes.empty() ? roots() : model_.scenes[scene].nodes) {
            if (auto added = add_node(node, dmat4(1.0), 0); !added) return added.error();
        }
        if (parts_.empty()) return bad_input("expected triangles, found none");
        return std::move(parts_);
    }
    [[nodiscard]] std::vector<std::string> take_left_out() { return std::move(left_out_); }

  private:
    [[nodiscard]] std::vector<int> roots() const {
        std::vector<bool> is_child(model_.nodes.size(), false);
        for (const tinygltf::Node& node : model_.nodes)
            for (const int child : node.children)
                if (child >= 0 && static_cast<std::size_t>(child) < is_child.size())
                    is_child[static_cast<std::size_t>(child)] = true;
        std::vector<int> found;
        for (std::size_t node = 0; node < is_child.size(); ++node)
            if (!is_child[node]) found.push_back(static_cast<int>(node));
        return found;
    }

    Result<void> add_node(int index, const dmat4& above, int depth) {
        if (index < 0 || static_cast<std::size_t>(index) >= model_.nodes.size()) {
            return bad_input(fmt::format("node {}: expected one, found none", index));
        }
        // This also ends a cycle of nodes.
        if (depth >= limits_.max_depth || ++visited_ > limits_.max_nodes) {
            return bad_input(fmt::format("expected at most {} nodes, {} deep, found more", limits_.max_nodes,
                                         limits_.max_depth));
        }
        const tinygltf::Node& node = model_.nodes[static_cast<std::size_t>(index)];
        const dmat4 place = above * place_of(node);
        for (int column = 0; column < 4; ++column) {
            for (int row = 0; row < 4; ++row) {
                if (!std::isfinite(place[column][row]))
                    return bad_input(fmt::format("node {}: expected finite numbers", index));
            }
        }
        if (node.mesh >= 0) {
            if (static_cast<std::size_t>(node.mesh) >= model_.meshes.size())
                return bad_input(fmt::format("mesh {}: expected one, found none", node.mesh));
            const tinygltf::Mesh& mesh = model_.meshes[static_cast<std::size_t>(node.mesh)];
            for (const tinygltf::Primitive& primitive : mesh.primitives) {
                if (is_left_out(primitive, node.mesh, mesh.name)) continue;
                if (auto added = add_primitive(primitive, node.name, mesh.name, place); !added) {
                    return bad_input(fmt::format("mesh {}: {}", node.mesh, added.error().message));
                }
            }
        }
        for (const int child : node.children) {
            if (auto added = add_node(child, place, depth + 1); !added) return added;
        }
        return {};
    }

    // Points and lines have no surface.
    bool is_left_out(const tinygltf::Primitive& primitive, int index, const std::string& mesh_name) {
        const bool is_points = primitive.mode == TINYGLTF_MODE_POINTS;
        if (!is_points && primitive.mode != TINYGLTF_MODE_LINE && primitive.mode != TINYGLTF_MODE_LINE_LOOP &&
            primitive.mode != TINYGLTF_MODE_LINE_STRIP)
            return false;
        std::string words =
            fmt::format("mesh {}: {}", mesh_name.empty() ? std::to_string(index) : in_quotes(mesh_name),
                        is_points ? "points" : "lines");
        if (std::find(left_out_.begin(), left_out_.end(), words) == left_out_.end())
            left_out_.push_back(std::move(words));
        return true;
    }

    Result<void> add_primitive(const tinygltf::Primitive& primitive, const std::string& node,
                               const std::string& mesh_name, const dmat4& place) {
        GltfPart part{.node = valid_utf8(node),
                      .mesh_name = valid_utf8(mesh_name),
                      .mesh = {},
                      .colours = {},
                      .material = primitive.material};
        if (primitive.material >= 0 &&
            static_cast<std::size_t>(primitive.material) >= model_.materials.size()) {
            return bad_input(fmt::format("material {}: expected one, found none", primitive.material));
        }
        auto positions = attribute(primitive, "POSITION", 3);
        if (!positions) return positions.error();
        if (!*positions) return bad_input("expected positions, found none");
        part.mesh.positions_m = vectors_of(**positions);
        const std::size_t vertices = part.mesh.positions_m.size();

        if (auto read = read_triangles(primitive, vertices, part.mesh.indices); !read) return read;
        auto normals = attribute(primitive, "NORMAL", 3);
        if (!normals) return normals.error();
        if (*normals) {
            part.mesh.normals = vectors_of(**normals);
        } else {
            make_normals(part.mesh);
        }
        if (auto read = read_colours(primitive, vertices, part.colours); !read) return read;
        // Check before transforming: an index out of range must not be followed.
        if (auto good = check_mesh(part.mesh); !good) return good;
        place_mesh(part.mesh, place);
        if (auto good = check_mesh(part.mesh); !good) return good;
        vertices_ += vertices;
        triangles_ += part.mesh.triangle_count();
        parts_.push_back(std::move(part));
        return {};
    }

    // Empty if the primitive has no such attribute.
    Result<std::optional<std::vector<float>>> attribute(const tinygltf::Primitive& primitive,
                                                        const char* name, int width) const {
        const auto found = primitive.attributes.find(name);
        if (found == primitive.attributes.end()) return std::optional<std::vector<float>>();
        auto numbers = read_floats(model_, found->second, width, limits_.max_vertices - vertices_);
        if (!numbers) return bad_input(fmt::format("{}: {}", name, numbers.error().message));
        return std::optional(std::move(*numbers));
    }

    Result<void> read_triangles(const tinygltf::Primitive& primitive, std::size_t vertices,
                                std::vector<std::uint32_t>& into) const {
        const std::size_t most = 3 * (limits_.max_triangles - triangles_);
        if (primitive.indices >= 0) {
            auto indices = read_indices(model_, primitive.indices, most);
            if (!indices) return indices.error();
            into = std::move(*indices);
        } else {
            if (vertices > most) return bad_input("expected fewer triangles, found more than the limit");
            for (std::uint32_t i = 0; i < vertices; ++i)
                into.push_back(i);
        }
        const bool is_inside =
            std::all_of(into.begin(), into.end(), [&](std::uint32_t index) { return index < vertices; });
        if (!is_inside) return bad_input("expected indices of vertices, found one past the last");
        return as_triangles(primitive.mode, most, into);
    }

    // Strips and fans as single triangles (glTF 2.0, 3.7.2.1); those without an area, which join strips, are
    // dropped.
    static Result<void> as_triangles(int mode, std::size_t most, std::vector<std::uint32_t>& indices) {
        if (mode == TINYGLTF_MODE_TRIANGLES) return {};
        if (mode != TINYGLTF_MODE_TRIANGLE_STRIP && mode != TINYGLTF_MODE_TRIANGLE_FAN)
            return bad_input(fmt::format("expected triangles, found mode {}", mode));
        if (indices.size() > most / 3 + 2)
            return bad_input("expected fewer triangles, found more than the limit");
        const std::vector<std::uint32_t> row = std::exchange(indices, {});
        for (std::size_t i = 0; i + 2 < row.size(); ++i) {
            const bool is_fan = mode == TINYGLTF_MODE_TRIANGLE_FAN;
            const std::uint32_t first = is_fan ? row[0] : row[i];
            const std::uint32_t second = row[i + 1 + (is_fan ? 0 : i % 2)];
            const std::uint32_t third = row[i + 2 - (is_fan ? 0 : i % 2)];
            if (first == second || second == third || third == first) continue;
            indices.insert(indices.end(), {first, second, third});
        }
        return {};
    }

    Result<void> read_colours(const tinygltf::Primitive& primitive, std::size_t vertices,
                              std::vector<vec4>& into) const {
        const auto found = primitive.attributes.find("COLOR_0");
        if (found == primitive.attributes.end()) return {};
        const int width = accessor_width(model_, found->second) == 3 ? 3 : 4;
        auto numbers = attribute(primitive, "COLOR_0", width);
        if (!numbers) return numbers.error();
        const std::vector<float>& all = **numbers;
        if (all.size() != vertices * static_cast<std::size_t>(width))
            return bad_input("COLOR_0: expected one a vertex");
        for (std::size_t i = 0; i < all.size(); i += static_cast<std::size_t>(width)) {
            const vec4 colour(all[i], all[i + 1], all[i + 2], width == 4 ? all[i + 3] : 1.0F);
            for (int k = 0; k < 4; ++k) {
                if (!std::isfinite(colour[k])) return bad_input("COLOR_0: expected finite numbers");
            }
            into.push_back(colour);
        }
        return {};
    }

    const tinygltf::Model& model_;
    const GltfLimits& limits_;
    std::vector<GltfPart> parts_;
    std::vector<std::string> left_out_;
    std::size_t visited_ = 0;
    std::size_t vertices_ = 0;
    std::size_t triangles_ = 0;
};

// Whether a file can be drawn in plain colours without it: it says how a surface looks, not where it is.
bool is_of_the_surface(std::string_view extension) {
    return extension.starts_with("KHR_materials_") || extension.starts_with("KHR_texture_") ||
           extension.starts_with("EXT_texture_") || extension == "KHR_lights_punctual";
}

Result<GltfModel> decode(std::span<const std::byte> bytes, const GltfLimits& limits) {
    if (auto good = check_header(bytes, limits); !good) return good.error();
    auto parsed = parse(bytes);
    if (!parsed) return parsed.error();
    GltfModel model;
    for (const std::string& extension : parsed->extensionsRequired) {
        if (!is_of_the_surface(extension))
            return bad_input(
                fmt::format("expected no required extension of the shape, found {}", first_line(extension)));
        model.left_out.push_back("extension " + first_line(extension));
    }
    for (const tinygltf::Material& material : parsed->materials)
        model.materials.push_back(material_of(material));
    Gathering gathering(*parsed, limits);
    auto parts = gathering.gather();
    if (!parts) return parts.error();
    model.parts = std::move(*parts);
    for (std::string& words : gathering.take_left_out())
        model.left_out.push_back(std::move(words));
    return model;
}

}  // namespace

Result<GltfModel> decode_glb(std::span<const std::byte> bytes, std::string_view name,
                             const GltfLimits& limits) {
    auto model = decode(bytes, limits);
    if (!model) return bad_input(fmt::format("{}: {}", name, model.error().message));
    return model;
}

}  // namespace onggi::asset
