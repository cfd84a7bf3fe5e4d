// The kernels' text compiled as C++ gives what the references give, in every assembly: a second compiler's
// opinion, without a device.
#include "bench/scalar/scalar.h"
#include "casegen/catalogue.h"
#include "casegen/compare.h"
#include "casegen/sampling.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <bit>
#include <map>

namespace gnomon {
namespace {

const Family& family_of(const scalar::Kernel& kernel) {
    return *std::ranges::find(catalogue(), kernel.family, &Family::name);
}

std::vector<scalar::Input> inputs_of(const Family& family) {
    const EdgePool pool = make_edge_pool(91);
    std::vector<scalar::Input> inputs;
    Random random(92);
    for (const EdgePool::Entry& entry : pool.entries) {
        Facts facts;
        facts.texel = glm::ivec2(entry.texel);
        facts.p.x = random.unit();
        facts.p.y = random.unit();
        facts.edge = entry.edge();
        facts.mask = &pool.masks[entry.mask];
        scalar::Input input = scalar::make_input(family, facts);
        // Decision lists are asked about texels that have a case.
        if (input.number != 0) inputs.push_back(std::move(input));
    }
    return inputs;
}

TEST(scalar, every_assembly_gives_the_same_bits) {
    std::map<std::string, std::vector<float>> expected;
    std::map<std::string, int> assemblies;
    for (const scalar::Kernel& kernel : scalar::kernels()) {
        const std::vector<float> got = kernel.evaluate(kernel.prepare(inputs_of(family_of(kernel))).get());
        ASSERT_GT(got.size(), 5000u);
        const auto [first, is_first] = expected.try_emplace(kernel.family, got);
        std::size_t differing = 0;
        for (std::size_t i = 0; i < got.size(); ++i)
            differing +=
                std::bit_cast<std::uint32_t>(got[i]) != std::bit_cast<std::uint32_t>(first->second[i]);
        EXPECT_EQ(differing, 0u) << kernel.family << ", " << kernel.name;
        ++assemblies[kernel.family];
    }
    EXPECT_GE(assemblies["smsr"], 8);
}

TEST(scalar, visibility_is_the_reference_s) {
    for (const scalar::Kernel& kernel : scalar::kernels()) {
        const Case* visibility = find_kernel(family_of(kernel), "visibility");
        if (!visibility) continue;
        const Sampler sampler(*visibility, 93, std::make_shared<EdgePool>(make_edge_pool(94)));
        std::size_t wrong = 0;
        for (std::size_t i = 0; i < 65536; ++i) {
            const Sampler::Sample sample = sampler.draw(i);
            const Arguments with = arguments(*visibility, sample.words, sample.mask);
            if (!in_domain(*visibility, with)) continue;
            const auto word = [&](std::size_t k) { return with.numbers[k]; };
            const float got = kernel.visibility(*sample.mask, {word(0), word(1)}, {word(2), word(3)});
            const std::array words{std::bit_cast<std::uint32_t>(got)};
            wrong += judge(*visibility, with, words).pass ? 0 : 1;
        }
        EXPECT_EQ(wrong, 0u) << kernel.family << ", " << kernel.name;
    }
}

} // namespace
} // namespace gnomon
