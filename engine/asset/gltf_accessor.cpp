#include "engine/asset/gltf_accessor.h"

#include <fmt/format.h>
#include <tiny_gltf.h>

#include <algorithm>
#include <cstring>
#include <limits>

namespace onggi::asset {
namespace {

// Where an accessor's elements lie, all of them inside their buffer.
struct Elements {
    const unsigned char* first = nullptr;
    std::size_t count = 0;
    std::size_t stride = 0;  // bytes from one to the next
    int component_type = 0;
    int width = 0;
    bool normalised = false;
};

// An index as tinygltf keeps it: -1 and anything else beyond the list means none.
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
    // Offsets are 64 bits wide and may be anything: compare by subtracting from what is there.
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

}  // namespace

int accessor_width(const tinygltf::Model& model, int accessor) {
    const tinygltf::Accessor* found = at(model.accessors, accessor);
    return found == nullptr
               ? 0
               : std::max(0, tinygltf::GetNumComponentsInType(static_cast<std::uint32_t>(found->type)));
}

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

}  // namespace onggi::asset
