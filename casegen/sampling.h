// The inputs that a kernel is run on: the worst that were ever found, pins, hostile values, stiff ones (on
// and near every locus of its generator), then random ones. Sample i of a seed is the same bits whatever else
// is drawn, on any machine and number of threads; worst ones and pins move the others back and change none.
#pragma once

#include "casegen/csv.h"
#include "casegen/kernel_case.h"
#include "casegen/random.h"
#include "runtime/files.h"

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace gnomon {

/// Edge texels of a corpus of masks, with what surrounds them: where inputs "from masks" come from.
struct EdgePool {
    struct Entry { // small: a check reads them at random
        std::uint16_t mask;
        glm::i8vec2 texel;
        glm::u8vec2 sides;
        glm::i8vec4 reach;
        glm::i8vec2 type;
        glm::bvec2 dominant;
        bool lit;
        reference::Edge edge() const {
            return {glm::uvec2(sides), glm::ivec4(reach), glm::ivec2(type), dominant, lit};
        }
    };
    std::vector<Mask> masks;    ///< of at most 64 texels a side, at most 65536 of them
    std::vector<Entry> entries; ///< lit and shadowed texels with at least one side that differs
    int side = 0;               ///< of the largest mask
};
EdgePool make_edge_pool(std::uint64_t seed);
EdgePool edge_pool_of(std::vector<Mask> masks);

/// A component's boundary values: its domain's ends and their neighbours, zeros, denormals, infinities, NaN.
std::vector<std::uint32_t> hostile_words(Scalar scalar, const Domain& domain, std::size_t component);

/// A place near a locus of a generator: the locus's number and the step of its distance.
struct Place {
    std::size_t locus = 0;
    int step = 0;
};

/// One input of the case's generator, at `place` if there is one, as words.
void draw_generated(const Case& c, Random& random, const std::optional<Place>& place,
                    std::span<std::uint32_t> words);

/// One case's samples, drawn on demand by index.
class Sampler {
public:
    /// `regressions` come first of all. `worst`, `pins`: CSV files with the case's columns whose rows come
    /// next, or paths where no file is. Throws Error naming file, row and column if one is malformed.
    Sampler(const Case& c, std::uint64_t seed, std::shared_ptr<const EdgePool> pool,
            const std::filesystem::path& pins = {}, const std::filesystem::path& worst = {},
            std::span<const CsvInput> regressions = {});

    struct Sample {
        std::vector<std::uint32_t> words; ///< word_count(case) of them
        const Mask* mask = nullptr;       ///< lives as long as the sampler; null if the kernel takes none
    };
    Sample draw(std::size_t index) const;
    /// The same without an allocation: writes the words, returns the mask (null if the kernel takes none).
    const Mask* draw(std::size_t index, std::span<std::uint32_t> words) const;

    /// Worst ones, pins, hostile and stiff values: every run begins with all of them.
    std::size_t fixed_count() const { return first_stiff() + stiff_count(); }
    /// The first of the samples that lie on or near a locus, and how many there are: for every locus, every
    /// distance, `stiff_repeats` each.
    std::size_t first_stiff() const { return pinned_.size() + hostile_.size(); }
    std::size_t stiff_count() const {
        return case_.generator ? case_.generator->loci.size() * locus_distances * stiff_repeats : 0;
    }
    static constexpr std::size_t stiff_repeats = 6;

    /// How many of the first samples are read from files: regressions, the worst ones, then the pins.
    std::size_t pinned_count() const { return pinned_.size(); }

    using Place = gnomon::Place;
    /// Where sample `index` lies. Nothing if it is not stiff.
    std::optional<Place> place(std::size_t index) const;

    std::uint64_t seed() const { return seed_; }

private:
    /// A parameter, with all that drawing it asks for looked up once.
    struct Slot {
        Type type;
        const Domain* domain;
        Fact fact;     ///< null: masks say nothing about it
        bool is_texel; ///< drawn within a mask and just beyond it
    };
    void draw_slot(Random& random, const Slot& slot, std::span<std::uint32_t> words) const;
    std::uint32_t draw_abstract(Random& random, std::span<std::uint32_t> words) const;
    std::uint32_t draw_from_mask(Random& random, std::span<std::uint32_t> words) const;
    void make_hostile();

    const Case& case_;
    std::uint64_t seed_;
    std::shared_ptr<const EdgePool> pool_;
    std::vector<Slot> slots_;
    std::vector<std::uint32_t> chosen_; ///< entries of the pool that the case applies to
    std::vector<std::vector<std::uint32_t>> hostile_, pinned_;
    std::vector<Mask> pinned_masks_; ///< one for each if the case takes a mask
};

/// The seed of a kernel that was given none: its generator's or its own name's hash.
inline std::uint64_t default_seed(const std::string& name) { return hash(name); }
inline std::uint64_t default_seed(const Case& c) { return hash(c.generator ? c.generator->name : c.name); }

} // namespace gnomon
