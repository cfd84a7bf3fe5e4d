#include "casegen/kernel_case.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <map>

namespace gnomon {

std::string glsl_name(Type type) {
    const auto pick = [&](const char* scalar, const char* vector) {
        return type.components == 1 ? std::string(scalar) : fmt::format("{}{}", vector, type.components);
    };
    switch (type.scalar) {
    case Scalar::int32:
        return pick("int", "ivec");
    case Scalar::uint32:
        return pick("uint", "uvec");
    case Scalar::boolean:
        return pick("bool", "bvec");
    case Scalar::float32:
        break;
    }
    return pick("float", "vec");
}

std::string to_string(const Tolerance& tolerance) {
    switch (tolerance.kind) {
    case Tolerance::Kind::ulps:
        return fmt::format("{} ulp", tolerance.amount);
    case Tolerance::Kind::absolute:
        return fmt::format("{:.3g} absolute", tolerance.amount);
    case Tolerance::Kind::input_within:
        return fmt::format("input within {:.3g}", tolerance.amount);
    case Tolerance::Kind::conditioned:
        return fmt::format("{:.4g} x conditioning", tolerance.amount);
    case Tolerance::Kind::exact:
        break;
    }
    return "exact";
}

namespace {

glm::ivec2 reach_x(const Facts& f) { return {f.edge.reach.x, f.edge.reach.y}; }
glm::ivec2 reach_y(const Facts& f) { return {f.edge.reach.z, f.edge.reach.w}; }

int put(Numbers& out, double x) {
    out[0] = x;
    return 1;
}
template <typename V>
int put(Numbers& out, const V& v) {
    out[0] = static_cast<double>(v.x);
    out[1] = static_cast<double>(v.y);
    return 2;
}
int put_along(Numbers& out, glm::ivec2 reach, double c) {
    return reference::edge_type(reach) == 0 ? put(out, reference::along(reach, c)) : 0;
}

/// Whether two walls stand on opposite sides, and the texel is not shut on all four.
bool is_slot(const Facts& f) {
    return f.mask && (f.edge.sides.x == reference::both) != (f.edge.sides.y == reference::both);
}
unsigned closed_end(const Facts& f) {
    return f.edge.sides.x == reference::both ? f.edge.sides.y : f.edge.sides.x;
}

} // namespace

Fact find_fact(const std::string& name) {
    static const std::map<std::string, Fact> facts{
        {"texel", [](const Facts& f, Numbers& out) { return put(out, f.texel); }},
        {"p", [](const Facts& f, Numbers& out) { return put(out, f.p); }},
        {"sides", [](const Facts& f, Numbers& out) { return put(out, f.edge.sides); }},
        {"side_x",
         [](const Facts& f, Numbers& out) { return put(out, static_cast<double>(f.edge.sides.x)); }},
        {"side_y",
         [](const Facts& f, Numbers& out) { return put(out, static_cast<double>(f.edge.sides.y)); }},
        {"reach", [](const Facts& f, Numbers& out) { return put(out, f.along_y ? reach_y(f) : reach_x(f)); }},
        {"type", [](const Facts& f, Numbers& out) { return put(out, f.edge.type); }},
        {"dominant", [](const Facts& f, Numbers& out) { return put(out, f.edge.dominant); }},
        {"along_x", [](const Facts& f, Numbers& out) { return put_along(out, reach_x(f), f.p.x); }},
        {"along_y", [](const Facts& f, Numbers& out) { return put_along(out, reach_y(f), f.p.y); }},
        {"type_x", [](const Facts& f, Numbers& out) { return put(out, static_cast<double>(f.edge.type.x)); }},
        {"type_y", [](const Facts& f, Numbers& out) { return put(out, static_cast<double>(f.edge.type.y)); }},
        {"entering", [](const Facts& f, Numbers& out) { return put(out, f.edge.lit ? 1.0 : 0.0); }},
        {"neighbours",
         [](const Facts& f, Numbers& out) {
             return is_slot(f) ? put(out, reference::neighbours(*f.mask, f.texel, f.edge.sides)) : 0;
         }},
        {"neighbour",
         [](const Facts& f, Numbers& out) {
             if (!is_slot(f)) return 0;
             const glm::uvec2 both_ways = reference::neighbours(*f.mask, f.texel, f.edge.sides);
             return put(out,
                        static_cast<double>(closed_end(f) == reference::plus ? both_ways.x : both_ways.y));
         }},
        {"breach",
         [](const Facts& f, Numbers& out) {
             return is_slot(f)
                        ? put(out, static_cast<double>(reference::breach(*f.mask, f.texel, f.edge.sides)))
                        : 0;
         }},
        {"heading", [](const Facts& f, Numbers& out) { return put(out, glm::ivec2(!f.along_y, f.along_y)); }},
        {"c", [](const Facts& f, Numbers& out) { return put(out, f.along_y ? f.p.y : f.p.x); }},
    };
    const auto found = facts.find(name);
    return found == facts.end() ? nullptr : found->second;
}

double locus_distance(int step) { return step == 0 ? 0 : std::pow(10.0, -step); }

std::string function_name(const Case& c) {
    std::string name = c.name;
    std::ranges::replace(name, '/', '_');
    return name;
}

std::string signature(const Case& c) {
    std::vector<std::string> parameters;
    for (std::size_t i = 0; i < c.parameters.size(); ++i)
        parameters.push_back(glsl_name(c.reference.parameters[i]) + " " + c.parameters[i].name);
    return fmt::format("{} {}({})", glsl_name(c.reference.result), function_name(c),
                       fmt::join(parameters, ", "));
}

std::string to_string(const Domain& domain) {
    if (domain.choices.empty()) return fmt::format("{:g} to {:g}", domain.lower, domain.upper);
    std::vector<std::string> choices;
    for (const std::vector<double>& choice : domain.choices)
        choices.push_back(fmt::format("{}", fmt::join(choice, ",")));
    return fmt::format("one of {}", fmt::join(choices, " | "));
}

std::string leading_comment(const std::string& text) {
    std::string comment;
    std::string_view rest = text;
    while (rest.starts_with("//")) {
        const std::size_t end = std::min(rest.find('\n'), rest.size());
        std::string_view line = rest.substr(2, end - 2);
        if (line.starts_with(' ')) line.remove_prefix(1);
        comment.append(line).append("\n");
        rest.remove_prefix(std::min(end + 1, rest.size()));
    }
    return comment;
}

std::size_t texel_word(const Case& c) {
    std::size_t word = 0;
    for (std::size_t i = 0; i < c.parameters.size(); ++i) {
        if (c.parameters[i].name == "texel") return word;
        word += static_cast<std::size_t>(c.reference.parameters[i].components);
    }
    return word;
}

std::vector<std::string> columns(const Case& c) {
    std::vector<std::string> names;
    if (c.reference.takes_mask) names = {"mask", "outside"};
    for (std::size_t i = 0; i < c.parameters.size(); ++i) {
        const int components = c.reference.parameters[i].components;
        for (int k = 0; k < components; ++k)
            names.push_back(components == 1 ? c.parameters[i].name
                                            : fmt::format("{}_{}", c.parameters[i].name, "xyzw"[k]));
    }
    return names;
}

bool on_grid(std::span<const double> numbers) {
    return std::ranges::all_of(numbers,
                               [](double number) { return number * 0x1p22 == std::trunc(number * 0x1p22); });
}

bool in_domain(const Case& c, const Arguments& arguments) {
    std::size_t word = 0;
    for (std::size_t i = 0; i < c.parameters.size(); ++i) {
        const Domain& domain = c.parameters[i].domain;
        const auto components = static_cast<std::size_t>(c.reference.parameters[i].components);
        const double* first = arguments.numbers.data() + word;
        word += components;
        if (domain.choices.empty()) {
            if (!std::all_of(first, first + components,
                             [&](double v) { return v >= domain.lower && v <= domain.upper; }))
                return false;
        } else if (std::ranges::none_of(domain.choices, [&](const std::vector<double>& choice) {
                       return std::equal(choice.begin(), choice.end(), first, first + components);
                   })) {
            return false;
        }
    }
    constexpr double smallest_normal = 0x1p-126;
    if (c.reference.truth)
        for (std::size_t i = 0; i < c.reference.words.size(); ++i)
            if (c.reference.words[i] == Scalar::float32 && arguments.numbers[i] != 0 &&
                std::abs(arguments.numbers[i]) < smallest_normal)
                return false;
    return !c.where || c.where(arguments);
}

} // namespace gnomon
