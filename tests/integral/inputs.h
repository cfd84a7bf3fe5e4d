// Inputs of the tests of truths: ordinary ones, and one at each of a few distances from every locus, rounded
// to float as records are.
#pragma once

#include "casegen/random.h"
#include "casegen/stiffness.h"
#include "runtime/files.h"

#include <functional>
#include <string>

namespace gnomon::testing {

template <typename... Values>
Arguments arguments_of(Values... values) {
    Arguments result{};
    std::size_t i = 0;
    ((result.numbers[i++] = static_cast<double>(values)), ...);
    return result;
}

inline void round_to_float(Arguments& x) {
    for (double& number : x.numbers) number = static_cast<double>(static_cast<float>(number));
}

/// Calls visit(arguments, "where it comes from"). `step`: which of the distances 1e-1 … 1e-12 are visited.
inline void for_each_input(const Generator& generator, int ordinary, int step,
                           const std::function<void(const Arguments&, const std::string&)>& visit) {
    for (int i = 0; i < ordinary; ++i) {
        Random random(hash(generator.name), static_cast<std::uint64_t>(i));
        Arguments x{};
        generator.draw(random, x.numbers);
        round_to_float(x);
        visit(x, "ordinary " + std::to_string(i));
    }
    for (std::size_t l = 0; l < generator.loci.size(); ++l)
        for (int d = 1 + static_cast<int>(l) % step; d < locus_distances; d += step) {
            Random random(hash(generator.loci[l].name), static_cast<std::uint64_t>(d));
            Arguments x{};
            generator.draw(random, x.numbers);
            generator.loci[l].place(random, locus_distance(d), x.numbers);
            const std::string from = generator.loci[l].name + " at 1e-" + std::to_string(d);
            visit(x, from); // floats are not that near to most loci
            round_to_float(x);
            visit(x, from + " in float");
        }
}

} // namespace gnomon::testing
