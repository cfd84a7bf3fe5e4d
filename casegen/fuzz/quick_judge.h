// Which results need a look: all but a few are plainly right, and whoever judges hundreds of millions must
// not spend a hundred nanoseconds on each of those.
#pragma once

#include "casegen/kernel_case.h"
#include "casegen/standalone.h"

#include <cstdint>
#include <span>
#include <vector>

namespace gnomon::fuzz {

/// A case with its domain looked up once.
class QuickJudge {
public:
    explicit QuickJudge(const Case& c);

    /// The numbers of the records that judge() must be asked about, ascending: every one that it would not
    /// pass, and of those that it would pass with an error above 0 the 64 largest errors at least. Of results
    /// that were all written. Of references with a truth: all.
    std::vector<std::size_t> to_look_at(const Records& records, std::span<const std::uint32_t> results) const;

    /// A record as a reference takes it, and whether it lies in the case's domain: arguments() and
    /// in_domain() of references without a truth, which take denormals.
    struct Read {
        Arguments arguments;
        bool inside;
    };
    Read read(std::span<const std::uint32_t> words, const Mask* mask) const;

private:
    /// A word that takes the numbers of an interval: any but NaN where they are listed, see Choices.
    struct Bounded {
        std::size_t word;
        Scalar scalar;
        double lower, upper;
    };
    /// A word that takes some of the whole numbers 0 to 63 only: a bit for each.
    struct Few {
        std::size_t word;
        Scalar scalar;
        std::uint64_t allowed;
    };
    /// A parameter that takes other listed values only, and where its first component is.
    struct Choices {
        std::size_t word, components;
        const std::vector<std::vector<double>>* values;
    };

    const Case& case_;
    std::vector<Bounded> floats_, wholes_; ///< apart: of floats nobody need ask for the scalar
    std::vector<Few> few_;
    std::vector<Choices> choices_;
};

} // namespace gnomon::fuzz
