// Every assembly that holds all cases gives the same bits; one that does not says so wherever its answer is
// none, and nowhere else.
#include "casegen/catalogue.h"
#include "casegen/sampling.h"
#include "tests/support/device.h"
#include "tests/support/environment.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>

namespace gnomon {
namespace {

using Words = std::vector<std::uint32_t>;
using testing::kernels_folder;
using testing::shared_device;

constexpr std::size_t sample_count = 65536;

class assemblies : public ::testing::TestWithParam<std::string> {
protected:
    const Family& family = technique_family(GetParam());
    const Case& visibility = *find_kernel(family, "visibility");
    const Case& number = *find_kernel(family, "number");

    /// Samples of the visibility kernel; every second one at an edge of a mask.
    Records samples(const Sampler& sampler) const {
        Records records(visibility);
        for (std::size_t i = 0; i < sample_count; ++i) {
            const Sampler::Sample sample = sampler.draw(i);
            records.add(sample.words, sample.mask);
        }
        return records;
    }
    Sampler sampler() const { return {visibility, 77, std::make_shared<EdgePool>(make_edge_pool(78))}; }

    Words run(const Case& c, const Records& records, const glsl::Sources& sources) const {
        const Outputs outputs = evaluate(shared_device(), sources, c, records);
        EXPECT_EQ(outputs.complaint(), "");
        return outputs.words;
    }
    glsl::Sources sources_with(const Assembly& assembly) const {
        glsl::Sources sources = kernel_sources(kernels_folder());
        sources.generated[family.name + "/cases"] = assembled(family, assembly);
        return sources;
    }
    Words run(const Records& records, const Assembly& assembly) const {
        return run(visibility, records, sources_with(assembly));
    }

    /// All numbers, the last one first: an order unlike the document's.
    std::vector<unsigned> backwards() const {
        std::vector<unsigned> numbers;
        for (const Case* c : numbered_cases(family)) numbers.insert(numbers.begin(), c->number);
        return numbers;
    }

    /// Numbers of the records' texels, from the family's kernel.
    Words numbers_of(const Records& records) const {
        Records texels(number);
        for (std::size_t i = 0; i < records.size(); ++i)
            texels.add(records.input(i).first(2), records.mask(i));
        return run(number, texels, kernel_sources(kernels_folder()));
    }
};

TEST_P(assemblies, give_the_same_bits_in_every_variant) {
    const Sampler drawn = sampler();
    const Records records = samples(drawn);
    const Words expected = run(records, {});
    for (const Variant variant : all_variants())
        for (const std::vector<unsigned>& cases : {std::vector<unsigned>{}, backwards()})
            for (const bool count : {false, true}) {
                const Words got = run(records, {variant, cases, count});
                std::size_t differing = 0;
                for (std::size_t i = 0; i < expected.size(); ++i) differing += got[i] == expected[i] ? 0 : 1;
                EXPECT_EQ(differing, 0u) << to_string(variant) << (cases.empty() ? "" : ", backwards")
                                         << (count ? ", counting" : "");
            }
}

TEST_P(assemblies, tell_exactly_where_a_case_was_left_out) {
    const Sampler drawn = sampler();
    const Records records = samples(drawn);
    const Words numbers = numbers_of(records), expected = run(records, {});
    std::vector<unsigned> held = backwards();
    std::erase_if(held, [](unsigned n) { return n % 3 == 0; });
    // The kernel alone, with 2 as its answer where it says so.
    for (const Variant variant : all_variants())
        for (const std::vector<unsigned>& cases : {held, {0u}}) {
            const glsl::Sources sources = sources_with({variant, cases});
            const std::string source = standalone_source(visibility);
            const std::size_t behind_call =
                source.find('\n', source.rfind(fmt::format("{}(", function_name(visibility))));
            const std::string telling =
                fmt::format("{}\n    if (case_left_out) result = 2.0;{}", source.substr(0, behind_call),
                            source.substr(behind_call));
            gpu::Kernel kernel = shared_device().kernel(
                glsl::compile(sources, telling, standalone_name, glsl::Stage::compute), "told");
            const Outputs outputs = run_standalone(shared_device(), kernel, visibility, records);
            std::size_t wrong = 0, told = 0;
            for (std::size_t i = 0; i < records.size(); ++i) {
                const bool out = numbers[i] != 0 && std::ranges::find(cases, numbers[i]) == cases.end();
                const bool said = outputs.words[i] == std::bit_cast<std::uint32_t>(2.0f);
                wrong += out != said || (!said && outputs.words[i] != expected[i]) ? 1 : 0;
                told += said ? 1 : 0;
            }
            EXPECT_EQ(wrong, 0u) << to_string(variant);
            EXPECT_GT(told, 100u) << to_string(variant);
        }
}

INSTANTIATE_TEST_SUITE_P(of, assemblies, ::testing::ValuesIn(numbered_techniques()));

} // namespace
} // namespace gnomon
