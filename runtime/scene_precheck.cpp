#include "runtime/scene_precheck.h"

#include "runtime/error.h"
#include "runtime/one_line.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <bit>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <optional>
#include <set>
#include <string>
#include <system_error>
#include <vector>

namespace gnomon {
namespace {

bool is_coordinate(double value) { return std::abs(value) <= max_coordinate; } // false for NaN

/// Takes the next line off `text`, without its end.
std::string_view take_line(std::string_view& text) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    std::string_view line = text.substr(0, end);
    text.remove_prefix(std::min(end + 1, text.size()));
    if (line.ends_with('\r')) line.remove_suffix(1);
    return line;
}

/// Takes the next word off `text`; empty if there is none.
std::string_view take_word(std::string_view& text) {
    // A lone \r, \v or \f is left in the word and makes it no number: readers disagree on what it separates.
    constexpr std::string_view blanks = " \t";
    text.remove_prefix(std::min(text.find_first_not_of(blanks), text.size()));
    const std::string_view word = text.substr(0, text.find_first_of(blanks));
    text.remove_prefix(word.size());
    return word;
}

/// "nan", "inf" and numbers too large for a double (as infinity) count as numbers.
std::optional<double> parse_number(std::string_view word) {
    if (word.starts_with('+')) word.remove_prefix(1);
    double value = 0;
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
    if (error == std::errc::invalid_argument || end != word.data() + word.size()) return std::nullopt;
    // Too small also lands here, and is told apart by its exponent.
    if (error == std::errc::result_out_of_range)
        return word.find("e-") != word.npos || word.find("E-") != word.npos ? 0.0 : HUGE_VAL;
    return value;
}

enum class Encoding { ascii, little, big };
enum class Scalar { i8, u8, i16, u16, i32, u32, f32, f64 };

struct Property {
    std::string name;
    Scalar type = Scalar::f32;
    std::optional<Scalar> list_count; // the type of the count, if this is a list
};

struct Element {
    std::string name;
    std::uint64_t count = 0;
    std::vector<Property> properties;
};

struct PlyHeader {
    Encoding encoding = Encoding::ascii;
    std::vector<Element> elements;
};

std::optional<Scalar> scalar_named(std::string_view name) {
    constexpr std::array<std::pair<std::string_view, Scalar>, 16> names{{{"char", Scalar::i8},
                                                                         {"int8", Scalar::i8},
                                                                         {"uchar", Scalar::u8},
                                                                         {"uint8", Scalar::u8},
                                                                         {"short", Scalar::i16},
                                                                         {"int16", Scalar::i16},
                                                                         {"ushort", Scalar::u16},
                                                                         {"uint16", Scalar::u16},
                                                                         {"int", Scalar::i32},
                                                                         {"int32", Scalar::i32},
                                                                         {"uint", Scalar::u32},
                                                                         {"uint32", Scalar::u32},
                                                                         {"float", Scalar::f32},
                                                                         {"float32", Scalar::f32},
                                                                         {"double", Scalar::f64},
                                                                         {"float64", Scalar::f64}}};
    for (const auto& [known, type] : names)
        if (known == name) return type;
    return std::nullopt;
}

Property parse_property(std::string_view line, const std::string& file) {
    const std::string text(line);
    Property property;
    std::string_view word = take_word(line);
    if (word == "list") {
        property.list_count = scalar_named(take_word(line));
        if (!property.list_count) throw Error("'{}': unknown type in 'property{}'", file, text);
        word = take_word(line);
    }
    const std::optional<Scalar> type = scalar_named(word);
    if (!type) throw Error("'{}': unknown type in 'property{}'", file, text);
    property.type = *type;
    property.name = take_word(line);
    if (property.name.empty() || !take_word(line).empty())
        throw Error("'{}' is damaged: its header has 'property{}'", file, text);
    return property;
}

/// Takes the header off `rest`.
PlyHeader take_header(std::string_view& rest, const std::string& file) {
    if (take_line(rest) != "ply") throw Error("'{}' is not a PLY file: it does not start with 'ply'", file);
    PlyHeader header;
    bool has_format = false;
    while (!rest.empty()) {
        std::string_view line = take_line(rest);
        const std::string_view keyword = take_word(line);
        if (keyword == "end_header") {
            if (!has_format) throw Error("'{}' is damaged: its header has no 'format' line", file);
            return header;
        }
        if (keyword == "format") {
            const std::string_view name = take_word(line);
            has_format = name == "ascii" || name == "binary_little_endian" || name == "binary_big_endian";
            if (!has_format) throw Error("'{}': unknown PLY format '{}'", file, name);
            header.encoding = name == "ascii"                  ? Encoding::ascii
                              : name == "binary_little_endian" ? Encoding::little
                                                               : Encoding::big;
        } else if (keyword == "element") {
            Element element;
            element.name = take_word(line);
            const std::string_view count = take_word(line);
            const auto [end, error] =
                std::from_chars(count.data(), count.data() + count.size(), element.count);
            if (error != std::errc{} || end != count.data() + count.size())
                throw Error("'{}': element '{}' has no valid count", file, element.name);
            header.elements.push_back(std::move(element));
        } else if (keyword == "property") {
            if (header.elements.empty())
                throw Error("'{}' is damaged: its header has a property before any element", file);
            header.elements.back().properties.push_back(parse_property(line, file));
        } else if (!keyword.empty() && keyword != "comment" && keyword != "obj_info") {
            throw Error("'{}' is damaged: unknown word '{}' in its header", file, keyword.substr(0, 40));
        }
    }
    throw Error("'{}' is damaged: its header has no end", file);
}

template <typename T>
double from_bytes(std::string_view bytes, bool swap) {
    std::array<char, sizeof(T)> raw;
    std::copy_n(bytes.begin(), sizeof(T), raw.begin());
    if (swap) std::reverse(raw.begin(), raw.end());
    return static_cast<double>(std::bit_cast<T>(raw));
}

std::size_t size_of(Scalar type) {
    switch (type) {
    case Scalar::i8:
    case Scalar::u8:
        return 1;
    case Scalar::i16:
    case Scalar::u16:
        return 2;
    case Scalar::i32:
    case Scalar::u32:
    case Scalar::f32:
        return 4;
    case Scalar::f64:
        break;
    }
    return 8;
}

double decode(std::string_view bytes, Scalar type, bool swap) {
    switch (type) {
    case Scalar::i8:
        return from_bytes<std::int8_t>(bytes, swap);
    case Scalar::u8:
        return from_bytes<std::uint8_t>(bytes, swap);
    case Scalar::i16:
        return from_bytes<std::int16_t>(bytes, swap);
    case Scalar::u16:
        return from_bytes<std::uint16_t>(bytes, swap);
    case Scalar::i32:
        return from_bytes<std::int32_t>(bytes, swap);
    case Scalar::u32:
        return from_bytes<std::uint32_t>(bytes, swap);
    case Scalar::f32:
        return from_bytes<float>(bytes, swap);
    case Scalar::f64:
        break;
    }
    return from_bytes<double>(bytes, swap);
}

/// The values after the header, one after the other. Messages name the element and instance being read.
class PlyBody {
public:
    PlyBody(std::string_view rest, Encoding encoding, const std::string& file)
        : rest_(rest), encoding_(encoding), file_(file) {}

    /// In a text file, each instance has its line.
    void begin_instance(const Element& element, std::uint64_t number) {
        element_ = &element;
        number_ = number;
        if (encoding_ != Encoding::ascii) return;
        do {
            if (rest_.empty()) throw cut_short();
            line_ = take_line(rest_);
        } while (line_.find_first_not_of(" \t") == line_.npos);
    }

    double next(Scalar type) {
        if (encoding_ == Encoding::ascii) {
            const std::string_view word = take_word(line_);
            if (word.empty()) throw cut_short();
            const std::optional<double> value = parse_number(word);
            if (!value) throw Error("'{}': '{}' in {} is not a number", file_, word.substr(0, 40), where());
            return *value;
        }
        const std::size_t size = size_of(type);
        if (rest_.size() < size) throw cut_short();
        const bool swap = (encoding_ == Encoding::little) != (std::endian::native == std::endian::little);
        const double value = decode(rest_, type, swap);
        rest_.remove_prefix(size);
        return value;
    }

    void end_instance() {
        if (encoding_ == Encoding::ascii && !take_word(line_).empty())
            throw Error("'{}' is cut short or damaged: {} has more values than properties", file_, where());
    }

    std::string where() const { return fmt::format("{} {} (counted from 0)", element_->name, number_); }

private:
    Error cut_short() const { return Error("'{}' is cut short or damaged: it ends in {}", file_, where()); }

    std::string_view rest_, line_;
    Encoding encoding_;
    const std::string& file_;
    const Element* element_ = nullptr;
    std::uint64_t number_ = 0;
};

void check_list(PlyBody& body, const Property& property, bool is_face, std::uint64_t vertices,
                const std::string& file) {
    const bool is_indices = is_face && property.name.starts_with("vertex_ind");
    const double count = body.next(*property.list_count);
    if (!(count >= (is_indices ? 1 : 0)))
        throw Error("'{}': {} has a list of {} values", file, body.where(), count);
    for (double i = 0; i < count; ++i) {
        const double value = body.next(property.type);
        if (is_indices && !(value >= 0 && value < static_cast<double>(vertices)))
            throw Error("'{}': {} uses vertex {}, but the file has {} vertices", file, body.where(), value,
                        vertices);
    }
}

void check_element(PlyBody& body, const Element& element, std::uint64_t vertices, const std::string& file) {
    const bool is_vertex = element.name == "vertex";
    const bool is_face = element.name == "face";
    for (std::uint64_t number = 0; number < element.count; ++number) {
        body.begin_instance(element, number);
        for (const Property& property : element.properties) {
            if (property.list_count) {
                check_list(body, property, is_face, vertices, file);
                continue;
            }
            const double value = body.next(property.type);
            const bool is_position = property.name == "x" || property.name == "y" || property.name == "z";
            if (is_vertex && is_position && !is_coordinate(value))
                throw Error("'{}': {} has {} = {:g}: a coordinate must be a finite number up to {:g}", file,
                            body.where(), property.name, value, max_coordinate);
        }
        body.end_instance();
    }
}

} // namespace

void precheck_ply(const std::filesystem::path& path, std::string_view bytes) {
    const std::string file = path.string();
    const PlyHeader header = take_header(bytes, file);

    std::uint64_t vertices = 0, faces = 0;
    for (const Element& element : header.elements) {
        if (element.properties.empty() && element.count > 0)
            throw Error("'{}' is damaged: element '{}' has no properties", file, element.name);
        if (element.name == "vertex") vertices += element.count;
        if (element.name == "face" || element.name == "tristrips") faces += element.count;
    }
    // Assimp makes triangles of every three points where there are no faces.
    if (faces == 0) throw Error("'{}' has no triangles", file);

    PlyBody body(bytes, header.encoding, file);
    for (const Element& element : header.elements) check_element(body, element, vertices, file);
}

void precheck_obj(const std::filesystem::path& path, std::string_view bytes) {
    std::uint64_t line_number = 0, vertex = 0;
    while (!bytes.empty()) {
        std::string_view line = take_line(bytes);
        ++line_number;
        if (take_word(line) != "v") continue;
        ++vertex;
        for (const char axis : {'x', 'y', 'z'}) {
            std::string_view word = take_word(line);
            if (word == "\\") { // the line goes on in the next one
                line = take_line(bytes);
                ++line_number;
                word = take_word(line);
            }
            const std::optional<double> value = parse_number(word);
            if (!value)
                throw Error("'{}', line {}: {} of vertex {} (counted from 1) is '{}', not a number",
                            path.string(), line_number, axis, vertex, word.substr(0, 40));
            if (!is_coordinate(*value))
                throw Error("'{}', line {}: vertex {} (counted from 1) has {} = {:g}: a coordinate must be a "
                            "finite number up to {:g}",
                            path.string(), line_number, vertex, axis, *value, max_coordinate);
        }
    }
}

void precheck_glb(const std::filesystem::path& path, std::string_view bytes) {
    constexpr std::size_t file_header = 12, chunk_header = 8;
    if (!bytes.starts_with("glTF") || bytes.size() < file_header)
        throw Error("'{}' is not a binary glTF file: it does not start with 'glTF' and a size",
                    path.string());
    constexpr bool swap = std::endian::native != std::endian::little;
    const auto number_at = [&](std::size_t at) {
        return static_cast<std::size_t>(decode(bytes.substr(at), Scalar::u32, swap));
    };
    if (number_at(4) != 2)
        throw Error("'{}' is glTF of version {}: only version 2 can be read", path.string(), number_at(4));
    for (std::size_t at = file_header; at < bytes.size();) {
        const std::size_t left = bytes.size() - at;
        if (left < chunk_header || number_at(at) > left - chunk_header)
            throw Error("'{}' is cut short or damaged: the chunk at byte {} reaches past the end",
                        path.string(), at);
        if (at == file_header) precheck_gltf(path, bytes.substr(at + chunk_header, number_at(at)));
        at += chunk_header + number_at(at);
    }
}

namespace {

/// Finds a name that is said twice in one object. By events: the library's callbacks for a whole document
/// take a time that grows with the square of an array's length.
class Names final : public nlohmann::json_sax<nlohmann::json> {
public:
    std::string twice; ///< empty: none

    bool start_object(std::size_t) override {
        open_.emplace_back();
        return true;
    }
    bool key(std::string& name) override {
        if (!open_.back().insert(name).second) twice = name;
        return true;
    }
    bool end_object() override {
        open_.pop_back();
        return true;
    }
    bool null() override { return true; }
    bool boolean(bool) override { return true; }
    bool number_integer(std::int64_t) override { return true; }
    bool number_unsigned(std::uint64_t) override { return true; }
    bool number_float(double, const std::string&) override { return true; }
    bool string(std::string&) override { return true; }
    bool binary(nlohmann::json::binary_t&) override { return true; }
    bool start_array(std::size_t) override { return true; }
    bool end_array() override { return true; }
    bool parse_error(std::size_t, const std::string&, const nlohmann::detail::exception&) override {
        return false;
    }

private:
    std::vector<std::set<std::string>> open_; // objects, with the names of their members
};

/// Assimp's JSON reader takes the first of two members of one name and ours the last, and what one of them
/// cannot read the other may: only what both understand alike can be checked.
nlohmann::json parse_json(std::string_view text, const std::string& file) {
    text = text.substr(0, text.find_last_not_of('\0') + 1); // binary files pad with them
    Names names;
    if (!nlohmann::json::sax_parse(text, &names))
        throw Error("'{}' cannot be read as a model: its JSON is damaged", file);
    if (!names.twice.empty()) throw Error("'{}' says \"{}\" twice in one place", file, one_line(names.twice));
    return nlohmann::json::parse(text);
}

/// Null if it is no object or has none of this name.
const nlohmann::json* member(const nlohmann::json* of, const char* name) {
    return of && of->is_object() && of->contains(name) ? &(*of)[name] : nullptr;
}

/// The node that a member of "children" names; none if it names none.
std::optional<std::size_t> child_of(const nlohmann::json& child, const nlohmann::json& nodes) {
    if (!child.is_number_integer() || child.get<std::int64_t>() < 0) return {};
    const auto number = child.get<std::size_t>();
    return number < nodes.size() ? std::optional(number) : std::nullopt;
}

/// By node, the one that it is a child of. Throws Error if there are two: else some hundred nodes are a tree
/// of 2^100.
std::vector<std::optional<std::size_t>> parents_of(const nlohmann::json& nodes, const std::string& file) {
    std::vector<std::optional<std::size_t>> parents(nodes.size());
    for (std::size_t parent = 0; parent < nodes.size(); ++parent) {
        const nlohmann::json* children = member(&nodes[parent], "children");
        if (!children || !children->is_array()) continue;
        for (const nlohmann::json& child : *children) {
            const std::optional<std::size_t> number = child_of(child, nodes);
            if (!number) continue;
            if (parents[*number])
                throw Error("'{}': node {} (counted from 0) is a child more than once", file, *number);
            parents[*number] = parent;
        }
    }
    return parents;
}

/// Assimp follows the views of a sparse accessor's two parts without asking whether they are there.
void check_sparse_accessors(const nlohmann::json& document, const std::string& file) {
    const nlohmann::json *accessors = member(&document, "accessors"),
                         *views = member(&document, "bufferViews");
    if (!accessors || !accessors->is_array()) return;
    const std::size_t known = views && views->is_array() ? views->size() : 0;
    for (std::size_t number = 0; number < accessors->size(); ++number) {
        const nlohmann::json* sparse = member(&(*accessors)[number], "sparse");
        if (!sparse) continue;
        for (const char* part : {"indices", "values"}) {
            const nlohmann::json* view = member(member(sparse, part), "bufferView");
            if (!view || !view->is_number_unsigned() || view->get<std::size_t>() >= known)
                throw Error(
                    "'{}': accessor {} (counted from 0) is sparse, and there is no buffer view for its "
                    "{}",
                    file, number, part);
        }
    }
}

} // namespace

void precheck_gltf(const std::filesystem::path& path, std::string_view json) {
    constexpr std::size_t deepest = 500;
    std::size_t depth = 0;
    bool in_string = false;
    for (std::size_t i = 0; i < json.size(); ++i) {
        const char c = json[i];
        if (in_string && c == '\\')
            ++i; // whatever follows is part of the string
        else if (c == '"')
            in_string = !in_string;
        else if (!in_string && (c == '[' || c == '{'))
            ++depth;
        else if (!in_string && (c == ']' || c == '}') && depth > 0)
            --depth;
        if (depth > deepest) throw Error("'{}' nests its JSON deeper than {} levels", path.string(), deepest);
    }
    const nlohmann::json document = parse_json(json, path.string());
    if (!document.is_object()) return;
    check_sparse_accessors(document, path.string());
    const nlohmann::json* nodes = member(&document, "nodes");
    if (!nodes || !nodes->is_array()) return;
    const auto parents = parents_of(*nodes, path.string());
    for (const auto& parent : parents) {
        std::size_t level = 0;
        for (std::optional<std::size_t> above = parent; above; above = parents[*above])
            if (++level > deepest)
                throw Error("'{}' nests its nodes deeper than {} levels, or in a circle", path.string(),
                            deepest);
    }
}

} // namespace gnomon
