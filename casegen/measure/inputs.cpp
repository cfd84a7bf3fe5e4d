#include "casegen/measure/inputs.h"

#include "runtime/error.h"

#include <tbb/task_arena.h>

#include <algorithm>
#include <thread>

namespace gnomon::measure {
namespace {

constexpr int tries = 8;

bool lies_in_domain(const Case& c, std::span<const std::uint32_t> words, const Mask* mask) {
    return in_domain(c, arguments(c, words, mask));
}

void add(Inputs& inputs, const Case& c, std::span<const std::uint32_t> words, const Mask* mask,
         const std::optional<Place>& place) {
    inputs.records.add(words, mask);
    inputs.places.push_back(place);
    std::size_t of_class = 0;
    if (place) {
        const std::string& name = c.generator->loci[place->locus].group;
        of_class = static_cast<std::size_t>(std::ranges::find(inputs.classes, name) - inputs.classes.begin());
    }
    inputs.class_of.push_back(of_class);
}

void draw_one(Inputs& inputs, const Case& c, Random random, const std::optional<Place>& place) {
    std::vector<std::uint32_t> words(word_count(c));
    for (int i = 0; i < tries; ++i) {
        draw_generated(c, random, place, words);
        if (lies_in_domain(c, words, nullptr)) {
            add(inputs, c, words, nullptr, place);
            return;
        }
    }
    ++inputs.left_out;
}

/// Without a generator: what check draws at random.
void draw_from_sampler(Inputs& inputs, const Case& c, const InputOptions& options) {
    const Sampler sampler(c, options.seed, inputs.pool);
    const std::size_t begin = sampler.fixed_count(), end = begin + options.ordinary * tries;
    std::vector<std::uint32_t> words(word_count(c));
    for (std::size_t i = begin; i < end && inputs.records.size() < options.ordinary; ++i) {
        const Mask* mask = sampler.draw(i, words);
        if (lies_in_domain(c, words, mask))
            add(inputs, c, words, mask, {});
        else
            ++inputs.left_out;
    }
}

} // namespace

std::vector<Truth> truths_on(const Case& c, const Records& records, unsigned jobs, const TruthFiles& files) {
    const unsigned cores = std::max(1u, std::thread::hardware_concurrency());
    if (jobs == 0 || jobs >= cores) return truths(c, records, files); // TBB has no more threads than these
    tbb::task_arena arena(static_cast<int>(jobs));
    return arena.execute([&] { return truths(c, records, files); });
}

Inputs draw_inputs(const Case& c, const InputOptions& options) {
    Inputs inputs(c);
    inputs.classes = {"ordinary"};
    // Masks are the same for every kernel, as in check.
    inputs.pool =
        std::make_shared<const EdgePool>(c.generator ? EdgePool{} : make_edge_pool(default_seed("masks")));
    if (c.generator) {
        const std::vector<Locus>& loci = c.generator->loci;
        for (const Locus& locus : loci)
            if (std::ranges::find(inputs.classes, locus.group) == inputs.classes.end())
                inputs.classes.push_back(locus.group);
        for (std::size_t i = 0; i < options.ordinary; ++i) draw_one(inputs, c, Random(options.seed, i), {});
        constexpr std::uint64_t stiff = std::uint64_t{1} << 40; // streams that no ordinary input has
        for (std::size_t i = 0; i < loci.size() * locus_distances * options.repeats; ++i) {
            const std::size_t nth = i / options.repeats;
            draw_one(inputs, c, Random(options.seed, stiff + i),
                     Place{nth / locus_distances, static_cast<int>(nth % locus_distances)});
        }
    } else {
        draw_from_sampler(inputs, c, options);
    }
    if (inputs.records.size() == 0)
        throw Error("{}: none of {} inputs lies in its domain; take more --samples", c.name, inputs.left_out);
    inputs.truths = truths_on(c, inputs.records, options.jobs, default_truth_files());
    return inputs;
}

} // namespace gnomon::measure
