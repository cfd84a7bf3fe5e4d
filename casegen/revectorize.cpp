// The table of kernels/revectorize: from the shadow test to the facts that visibility functions decide by.
#include "casegen/catalogue.h"
#include "casegen/vocabulary.h"

#include <algorithm>
#include <cfloat>
#include <cmath>

namespace gnomon {

using namespace vocabulary;
namespace ref = reference;

Family revectorize_family() {
    const auto reach_is_walked = [](const Arguments& a) { return a.numbers[0] != 0 && a.numbers[1] != 0; };
    // A position along a run of 1, 2, 4, 8 or 16 texels, or of more, which count as 16: nothing is rounded.
    const auto on_even_run = [](std::span<const double> a, double longest) {
        const double run = std::min(std::abs(a[0]) + std::abs(a[1]) - 1, longest);
        return run > 0 && std::exp2(std::round(std::log2(run))) == run &&
               a[2] * 0x1p16 == std::trunc(a[2] * 0x1p16);
    };
    const auto on_even_run_up_to_16 = [on_even_run](std::span<const double> a) { return on_even_run(a, 16); };
    const auto on_even_run_of_any_length = [on_even_run](std::span<const double> a) {
        return on_even_run(a, 64);
    };
    const auto ends_once = [](const Arguments& a) { return a.numbers[0] * a.numbers[1] < 0; };
    return {
        "revectorize",
        "shadow test, discontinuity, traversal, edge type, position along the run, dominance, neighbours, "
        "breach",
        {
            {
                .name = "revectorize/shadow_test",
                .source = "Optimized RBSM 2017, equation 1",
                .reference = [](double receiver, double bias,
                                double occluder) { return receiver - occluder <= bias; },
                .parameters = {{"receiver",
                                {0, 1, {}},
                                "light depth",
                                "the receiver's distance from the light's plane"},
                               {"bias",
                                {0, 1.0 / 16, {}},
                                "light depth",
                                "how much nearer the receiver is taken to be"},
                               {"occluder", {0, 1, {}}, "light depth", "the nearest depth in the texel"}},
                .result = {0, 1, "1", "lit"},
                // Rounding receiver - bias moves it by at most half an ulp of 1; denormals may flush.
                .tolerance = input_within(0x1p-24),
                .exact_where = on_grid,
            },
            {
                .name = "revectorize/discontinuity",
                .source = "Optimized RBSM 2017, listing 2 and table 1",
                .reference = ref::discontinuity,
                .parameters = {texel()},
                .result = {0, 3, "bits", "sides along x and y"},
            },
            {
                .name = "revectorize/walk",
                .source = "Optimized RBSM 2017, listing 3; docs/revectorization.md 1.1",
                .reference = ref::walk,
                .parameters = {texel(), sides(), heading()},
                .result = {-(ref::longest_walk + 1), ref::longest_walk, "texels",
                           "signed length of the walk"},
            },
            {
                .name = "revectorize/traversal",
                .source = "RBSSM supplement, algorithm 1; docs/revectorization.md 1.1",
                .reference = ref::traversal,
                .parameters = {texel(), sides()},
                .result = {-(ref::longest_walk + 1), ref::longest_walk, "texels", "walks to -x, +x, -y, +y"},
            },
            {
                .name = "revectorize/edge_type",
                .source = "Optimized RBSM 2017, equation 5",
                .reference = ref::edge_type,
                .parameters = {reach()},
                .result = {-1, 1, "1", "1 ends at both sides, 0 at one, -1 at none"},
                .where = reach_is_walked,
            },
            {
                .name = "revectorize/along",
                .source = "RBSM 2016, equation 1; docs/revectorization.md 1.3",
                .reference = ref::along,
                .parameters = {reach(), c()},
                .result = {0, 1, "1", "position along the run"},
                // from_end <= 17 rounds by 2^-20, divided by a run of at least from_end - 1: below 17/16
                // 2^-24 x 2; the quotient and the difference add half an ulp of 1 each.
                .tolerance = absolute(0x1p-22),
                .exact_where = on_even_run_up_to_16,
                .where = ends_once,
            },
            {
                .name = "revectorize/along_unclamped",
                .source = "RBSM 2016, equation 1 without a limit; docs/decisions.md A7",
                .reference = ref::along_unclamped,
                .parameters = {reach(), c()},
                .result = {0, 1, "1", "position along the run"},
                .tolerance = absolute(0x1p-22), // as above
                .exact_where = on_even_run_of_any_length,
                .where = ends_once,
            },
            {
                .name = "revectorize/along_closed",
                .source = "RBSM 2016, equation 1; docs/decisions.md A3",
                .reference = ref::along_closed,
                .parameters =
                    {{"reach", {1, ref::longest_walk, {}}, "texels", "walks towards - and +, both to an end"},
                     c()},
                .result = {0, 1, "1", "distance from the nearer end as part of the run"},
                .tolerance = absolute(0x1p-22), // as above
                .exact_where = on_even_run_up_to_16,
            },
            {
                .name = "revectorize/neighbours",
                .source = "RBSM supplement, section 3, n(d_c); docs/revectorization.md 1.5",
                .reference = ref::neighbours,
                .parameters = {texel(), sides()},
                .result = {0, 3, "bits", "sides of the texels next along, towards - and +"},
            },
            {
                .name = "revectorize/breach",
                .source = "RBSM supplement, section 3, d_cb; docs/revectorization.md 1.6",
                .reference = ref::breach,
                .parameters = {texel(), sides()},
                .result = {0, 4, "bits", "sides left; 3 one each way, 4 none found"},
            },
            {
                .name = "revectorize/dominance",
                .source = "RBSM supplement, section 1; docs/revectorization.md 1.4",
                .reference = ref::dominance,
                .parameters = {texel(), sides()},
                .result = {0, 1, "1", "D_r, D_g"},
            },
        }};
}

} // namespace gnomon
