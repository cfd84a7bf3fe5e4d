#include "tests/support/sine_family.h"

#include "runtime/files.h"

#include <cmath>
#include <stdexcept>

namespace gnomon::testing {
namespace {

constexpr const char* printed = R"(// As a textbook has it.
float wave_printed(float k, float a, float b) { return (sin(k * b) - sin(k * a)) / k; }
)";

constexpr const char* sinc = R"(
float S(float x) { return abs(x) < 0.1 ? 1.0 - x * x * (1.0 / 6.0 - x * x / 120.0) : sin(x) / x; }
float by_sinc(float k, float a, float b) {
    float h = 0.5 * (b - a);
    return 2.0 * h * S(k * h) * cos(k * (a + h));
}
)";

long double wave(long double k, long double a, long double b) {
    const long double h = (b - a) / 2, x = k * h;
    const long double s = std::abs(x) < 1e-4L ? 1 - x * x / 6 + x * x * x * x / 120 : std::sin(x) / x;
    return 2 * h * s * std::cos(k * (a + h));
}

Truth truth_of_wave(const Arguments& arguments) {
    const long double k = arguments.numbers[0], a = arguments.numbers[1], b = arguments.numbers[2];
    const long double step = 1e-6L;
    const long double by_k = (wave(k + step, a, b) - wave(k - step, a, b)) / (2 * step);
    Truth truth;
    truth.value[0] = static_cast<double>(wave(k, a, b));
    truth.conditioning[0] = 0x1p-24 * static_cast<double>(std::abs(k * by_k) + std::abs(a * std::cos(k * a)) +
                                                          std::abs(b * std::cos(k * b)));
    truth.scale = static_cast<double>(std::abs(b - a));
    return truth;
}

Generator generator() {
    Generator made;
    made.name = "waves";
    made.draw = [](Random& random, std::span<double> numbers) {
        numbers[0] = 8 * random.unit();
        numbers[1] = -3 + 2 * random.unit();
        numbers[2] = 1 + 2 * random.unit();
    };
    made.loci = {{"k = 0", "k", [](Random&, double d, std::span<double> numbers) { numbers[0] = d; }},
                 {"k = 1", "k", [](Random&, double d, std::span<double> numbers) { numbers[0] = 1 + d; }},
                 {"narrow", "cell",
                  [](Random&, double d, std::span<double> numbers) { numbers[2] = numbers[1] + d; }}};
    return made;
}

} // namespace

SineFamily::SineFamily() {
    std::filesystem::create_directories(kernels() / "wave");
    const auto shared = std::make_shared<const Generator>(generator());
    const auto add = [&](const std::string& name, const std::string& text) {
        folder_.write("kernels/wave/" + name + ".glsl", text);
        Case c;
        c.name = "wave/" + name;
        c.source = "a textbook";
        c.reference = reference_by<double(double, double, double)>(truth_of_wave);
        c.parameters = {{"k", {0, 8, {}}, "1", "frequency"},
                        {"a", {-3, 3, {}}, "1", "begin"},
                        {"b", {-3, 3, {}}, "1", "end"}};
        c.result = {-10, 10, "1", "the integral"};
        c.tolerance = conditioned(16);
        c.quantity = "wave/integral";
        c.generator = shared;
        c.defended = false;
        cases_.push_back(std::move(c));
    };
    const std::string call = "(float k, float a, float b) { ";
    add("printed", printed);
    add("sinc", std::string(sinc) + "float wave_sinc" + call + "return by_sinc(k, a, b); }\n");
    add("series",
        std::string(sinc) + "float wave_series" + call +
            "float sum = 0.0; for (int i = 0; i < 16; ++i) sum += by_sinc(k, a + float(i) * (b - a) / "
            "16.0, a + float(i + 1) * (b - a) / 16.0); return sum; }\n");
    add("spiked", std::string(sinc) + "float wave_spiked" + call +
                      "return by_sinc(k, a, b) * (k > 4.0 && k < 4.001 ? 1.01 : 1.0); }\n");
}

std::vector<const Case*> SineFamily::pointers() const {
    std::vector<const Case*> all;
    for (const Case& c : cases_) all.push_back(&c);
    return all;
}

const Case& SineFamily::named(const std::string& name) const {
    for (const Case& c : cases_)
        if (c.name == name) return c;
    throw std::out_of_range(name);
}

} // namespace gnomon::testing
