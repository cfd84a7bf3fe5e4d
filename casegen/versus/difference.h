// Where the results of two kernels on the same inputs differ, bit for bit.
#pragma once

#include "casegen/standalone.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace gnomon::versus {

/// Of two results: NaN is the same as any other NaN, and anything else only as its very bits.
struct ResultDifference {
    bool differs = false;
    bool finiteness = false; ///< one is finite and the other is not, or they are not so in the same way
    bool other_nan = false;  ///< NaN on both sides, of other bits: no difference
    double absolute = 0;     ///< |b - a|, the largest over the components; infinite where finiteness is
    double change = 0;       ///< b - a of that component
    double ulps = 0;         ///< floats between them, the largest; 0 of whole numbers, and between 0 and -0
};
ResultDifference difference_of(Type type, std::span<const std::uint32_t> a, std::span<const std::uint32_t> b);

/// A component of a parameter: what the columns of a CSV file are, and the axes of a picture.
struct Component {
    std::string name; ///< "p.x"; of a scalar the parameter's
    std::size_t parameter = 0, component = 0;
    Scalar scalar = Scalar::float32;
};
/// In the order of a record's words.
std::vector<Component> components_of(const Case& c);

/// How many samples of the domain have this value, and on how many of them the results differ.
struct ValueShare {
    std::string value;
    std::size_t samples = 0, differ = 0;
};

/// Where along one component, or among a parameter's choices, the samples lie whose results differ. Of the
/// domain only.
struct Whereabouts {
    std::string name;                        ///< "p.x", "side_x"
    std::vector<ValueShare> values;          ///< if there are few: all of them
    double sampled_from = 0, sampled_to = 0; ///< else: the samples' range,
    double from = 0, to = 0;                 ///< that of those which differ,
    std::size_t inside = 0;                  ///< and how many samples lie in that one
};

struct Difference {
    std::size_t samples = 0, defined = 0; ///< all of them, and those in the domain
    std::size_t differ = 0, differ_defined = 0;
    std::size_t finiteness = 0;    ///< of those that differ: see ResultDifference
    std::size_t zeros = 0;         ///< of those that differ: 0 against -0, and nothing else
    std::size_t other_nan = 0;     ///< of those that do not
    std::size_t worst = 0;         ///< if any differ: in the domain if one does there; the first of equals
    double absolute = 0, ulps = 0; ///< of the worst
    double most_ulps = 0;
    std::vector<Whereabouts> where; ///< a parameter or component each; none if nothing in the domain differs
};

/// `a`, `b`: the words that each kernel wrote. `defined`: per record whether it is in the domain.
Difference difference(const Case& c, const Records& records, std::span<const std::uint8_t> defined,
                      std::span<const std::uint32_t> a, std::span<const std::uint32_t> b);

} // namespace gnomon::versus
