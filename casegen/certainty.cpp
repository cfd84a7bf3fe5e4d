// The table of kernels/certainty: which pixels of a hybrid need no ray.
#include "casegen/catalogue.h"
#include "casegen/vocabulary.h"

namespace gnomon {
namespace {

/// What texels agree on: 0 shadow, 1 light, 2 nothing.
class Agreement {
public:
    void ask(bool lit) { (lit ? lit_ : shadowed_) = true; }
    unsigned answer() const { return lit_ && shadowed_ ? 2 : lit_ ? 1 : 0; }

private:
    bool lit_ = false, shadowed_ = false;
};

unsigned of_diagonal(const Mask& mask, glm::ivec2 texel, glm::dvec2) {
    Agreement agreement;
    for (int y = -1; y <= 1; ++y)
        for (int x = -1; x <= 1; ++x)
            if (x * y != 0) agreement.ask(mask.lit(texel.x + x, texel.y + y));
    return agreement.answer();
}

/// By distance: of all nine texels, those whose centre is less than a texel away from p in x and in y.
unsigned of_footprint(const Mask& mask, glm::ivec2 texel, glm::dvec2 p) {
    const auto counts = [](int offset, double at) {
        const double distance = offset + 0.5 - at;
        return distance > -1 && distance <= 1;
    };
    Agreement agreement;
    for (int y = -1; y <= 1; ++y)
        for (int x = -1; x <= 1; ++x)
            if (counts(x, p.x) && counts(y, p.y)) agreement.ask(mask.lit(texel.x + x, texel.y + y));
    return agreement.answer();
}

/// By counting: five lit tests of the big map, or five shadowed ones of both.
unsigned of_maps(unsigned big_centre, glm::uvec4 big, glm::uvec4 small) {
    unsigned lit = big_centre != 0 ? 1 : 0, shadowed = 1 - lit;
    for (int i = 0; i < 4; ++i) {
        lit += big[i] != 0 ? 1 : 0;
        shadowed += small[i] == 0 ? 1 : 0;
    }
    return lit == 5 ? 1 : shadowed == 5 ? 0 : 2;
}

} // namespace

Family certainty_family() {
    const Result result{0, 2, "1", "0 certainly shadowed, 1 certainly lit, 2 uncertain"};
    const auto test = [](const char* name, const char* meaning) {
        return Parameter{name, {0, 1, {}}, "1", meaning};
    };
    return {
        "certainty",
        "which pixels of a hybrid need no ray",
        {
            {
                .name = "certainty/beister",
                .source = "Beister et al. 2005 as the thesis measured it",
                .reference = of_diagonal,
                .parameters = {vocabulary::texel(), vocabulary::p()},
                .result = result,
            },
            {
                .name = "certainty/bilinear",
                .source = "Beister et al. 2005",
                .reference = of_footprint,
                .parameters = {vocabulary::texel(), vocabulary::p()},
                .result = result,
            },
            {
                .name = "certainty/crsm",
                .source = "Hybrid hard shadows, chapter 4. CRSMA asks the same of "
                          "its own maps",
                .reference = of_maps,
                .parameters = {test("big_centre", "the dilated map's test at the texel: 1 lit, 0 shadowed"),
                               test("big_diagonal", "its tests at the texels at (+-1, +-1)"),
                               test("small_diagonal", "the eroded map's tests there")},
                .result = result,
            },
        }};
}

} // namespace gnomon
