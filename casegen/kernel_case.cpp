#include "casegen/kernel_case.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

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
    case Tolerance::Kind::exact:
        break;
    }
    return "exact";
}

std::vector<double> fact(const Facts& facts, const std::string& name) {
    const reference::Edge& e = facts.edge;
    const glm::ivec2 reach_x(e.reach.x, e.reach.y), reach_y(e.reach.z, e.reach.w);
    const auto one_sided = [](glm::ivec2 reach) { return reference::edge_type(reach) == 0; };
    if (name == "texel") return {static_cast<double>(facts.texel.x), static_cast<double>(facts.texel.y)};
    if (name == "p") return {facts.p.x, facts.p.y};
    if (name == "sides") return {static_cast<double>(e.sides.x), static_cast<double>(e.sides.y)};
    if (name == "side_x") return {static_cast<double>(e.sides.x)};
    if (name == "side_y") return {static_cast<double>(e.sides.y)};
    if (name == "type") return {static_cast<double>(e.type.x), static_cast<double>(e.type.y)};
    if (name == "dominant") return {static_cast<double>(e.dominant.x), static_cast<double>(e.dominant.y)};
    if (name == "along_x" && one_sided(reach_x)) return {reference::along(reach_x, facts.p.x)};
    if (name == "along_y" && one_sided(reach_y)) return {reference::along(reach_y, facts.p.y)};
    if (name == "reach") {
        const glm::ivec2 reach = facts.along_y ? reach_y : reach_x;
        return {static_cast<double>(reach.x), static_cast<double>(reach.y)};
    }
    if (name == "c") return {facts.along_y ? facts.p.y : facts.p.x};
    if (name == "heading") return facts.along_y ? std::vector<double>{0, 1} : std::vector<double>{1, 0};
    return {};
}

std::string function_name(const Case& c) {
    std::string name = c.name;
    std::ranges::replace(name, '/', '_');
    return name;
}

std::size_t word_count(const Case& c) {
    std::size_t words = 0;
    for (const Type& type : c.reference.parameters) words += static_cast<std::size_t>(type.components);
    return words;
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
    return !c.where || c.where(arguments);
}

double widen(Scalar scalar, std::uint32_t word) {
    switch (scalar) {
    case Scalar::float32:
        return static_cast<double>(std::bit_cast<float>(word));
    case Scalar::int32:
        return static_cast<double>(std::bit_cast<std::int32_t>(word));
    case Scalar::boolean:
    case Scalar::uint32:
        break;
    }
    return static_cast<double>(word);
}

std::uint32_t narrow(Scalar scalar, double number) {
    switch (scalar) {
    case Scalar::float32:
        return std::bit_cast<std::uint32_t>(static_cast<float>(number));
    case Scalar::int32:
        return std::bit_cast<std::uint32_t>(static_cast<std::int32_t>(number));
    case Scalar::boolean:
        return number != 0 ? 1u : 0u;
    case Scalar::uint32:
        break;
    }
    return static_cast<std::uint32_t>(number);
}

Arguments arguments(const Case& c, std::span<const std::uint32_t> words, const Mask* mask) {
    Arguments result;
    result.mask = mask;
    std::size_t word = 0;
    for (const Type& type : c.reference.parameters)
        for (int k = 0; k < type.components; ++k, ++word)
            result.numbers[word] = widen(type.scalar, words[word]);
    return result;
}

} // namespace gnomon
