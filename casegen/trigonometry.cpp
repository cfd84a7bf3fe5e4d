#include "casegen/trigonometry.h"

#include "runtime/error.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

namespace gnomon {

const std::vector<std::string>& trigonometry_names() {
    static const std::vector<std::string> names{"portable", "built-in", "coarse"};
    return names;
}

Trigonometry parse_trigonometry(const std::string& name) {
    const auto& names = trigonometry_names();
    const auto found = std::ranges::find(names, name);
    if (found == names.end())
        throw Error("no trigonometry \"{}\"; there are: {}", name, fmt::join(names, ", "));
    return static_cast<Trigonometry>(found - names.begin());
}

std::string to_string(Trigonometry trigonometry) {
    return trigonometry_names()[static_cast<std::size_t>(trigonometry)];
}

std::string trigonometry_source(Trigonometry trigonometry) {
    switch (trigonometry) {
    case Trigonometry::portable: // macros: one level of calls less for a driver to inline
        return R"(#include "integral/elementary/cos.glsl"
#include "integral/elementary/exp.glsl"
#include "integral/elementary/sin.glsl"
#include "integral/elementary/turn.glsl"
#define sine(x) integral_elementary_sin(x)
#define cosine(x) integral_elementary_cos(x)
#define turn(x) integral_elementary_turn(x)
#define exponential(x) integral_elementary_exp(x)
)";
    case Trigonometry::built_in:
        return R"(float sine(const float x) { return sin(x); }
float cosine(const float x) { return cos(x); }
vec2 turn(const float x) { return vec2(cos(x), sin(x)); }
float exponential(const float x) { return exp(x); }
)";
    case Trigonometry::coarse:
        break;
    }
    // Rounded to multiples of 2⁻¹⁰, so that the error is anything up to 2⁻¹¹; the largest error of exp that
    // is allowed.
    return R"(float coarse(const float x) { return floor(x * 1024.0 + 0.5) / 1024.0; }
float sine(const float x) { return coarse(sin(x)); }
float cosine(const float x) { return coarse(cos(x)); }
vec2 turn(const float x) { return vec2(cosine(x), sine(x)); }
float exponential(const float x) { return exp(x) * (1.0 + (3.0 + 2.0 * abs(x)) * 1.1920929e-7); }
)";
}

} // namespace gnomon
