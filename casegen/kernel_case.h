// A case: one kernel, declared once. Unit test, check, eval, describe and the assembled pipeline read the
// same declaration.
//
// The reference's C++ signature is the kernel's GLSL signature with double for float:
//     double (glm::dvec2 p, double along_x)                 float smsr_case_09(vec2 p, float along_x)
//     int (const Mask&, glm::ivec2 texel, glm::uvec2 sides) int f(ivec2 texel, uvec2 sides), which may call
//     lit(ivec2)
// From it come the record that a sample is stored in, the generated main() and the columns of a CSV file.
#pragma once

#include "casegen/condition.h"
#include "casegen/mask.h"
#include "casegen/random.h"
#include "casegen/reference/revectorize.h"

#include <glm/glm.hpp>

#include <array>
#include <bit>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace gnomon {

enum class Scalar { float32, int32, uint32, boolean };

/// A GLSL type: a scalar or a vector of 2 to 4.
struct Type {
    Scalar scalar = Scalar::float32;
    int components = 1;
    friend bool operator==(const Type&, const Type&) = default;
};

/// "vec2", "uint", …
std::string glsl_name(Type type);

/// The values a parameter takes: an interval per component, or a list of whole values.
struct Domain {
    double lower = 0, upper = 1;
    std::vector<std::vector<double>>
        choices; ///< if not empty, these and no others (one number per component)
};

struct Parameter {
    std::string name; ///< as in the kernel's text; facts of a mask are matched by it (see Facts)
    Domain domain;
    std::string unit, meaning;
};

struct Result {
    double lower = 0, upper = 1; ///< every result lies within, whatever the input
    std::string unit, meaning;
};

/// How far a result may be from the reference's. NaN never passes.
struct Tolerance {
    enum class Kind { exact, ulps, absolute, input_within, conditioned };
    Kind kind = Kind::exact;
    double amount = 0;
};
inline Tolerance exact() { return {}; }
/// At most n floats between the result and the reference rounded to float.
inline Tolerance ulps(double n) { return {Tolerance::Kind::ulps, n}; }
inline Tolerance absolute(double e) { return {Tolerance::Kind::absolute, e}; }
/// A step kernel may answer as if each of its float inputs were up to d away.
inline Tolerance input_within(double d) { return {Tolerance::Kind::input_within, d}; }
/// n times what rounding the inputs to float32 alone can do to the result (Truth::conditioning), and no finer
/// than n roundings of Truth::scale. For references with a truth.
inline Tolerance conditioned(double n) { return {Tolerance::Kind::conditioned, n}; }
std::string to_string(const Tolerance& tolerance);

/// What a reference is called with: every component of every parameter, widened to double, and the mask if it
/// takes one.
struct Arguments {
    std::array<double, 16> numbers; ///< as many as the reference has words; the rest is not set
    const Mask* mask = nullptr;
};
using Numbers = std::array<double, 4>; ///< a result's components

/// What a quantity is at an input, to the last bit of a double, and how well float32 inputs determine it.
struct Truth {
    Numbers value{};
    /// Per component, Σ |x_i ∂value/∂x_i| · 2⁻²⁴ over all float inputs x_i: what half an ulp in each of them
    /// can do.
    Numbers conditioning{};
    /// What an error is a fraction of: of an integral that of the integrand's absolute value, which no sign
    /// change brings to zero; of other quantities the value's own magnitude.
    double scale = 0;
};

/// A reference with its signature, made from a function or a lambda without captures.
struct Reference {
    Type result;
    std::vector<Type> parameters; ///< without the mask
    std::vector<Scalar> words;    ///< of all their components, in order: what a record holds
    bool takes_mask = false;
    std::function<Numbers(const Arguments&)> call;
    std::function<Truth(const Arguments&)>
        truth; ///< in multiprecision, and slow; empty where `call` says all

    Reference() = default;
    template <typename Function>
    Reference(Function function); // NOLINT: a table entry reads `.reference = [](…) {…}`
};

/// The reference of a kernel with this C++ signature, "double(double, glm::dvec3)", by its truth.
template <typename Signature>
Reference reference_by(Truth (*truth)(const Arguments&));

/// A set of inputs on which formulas lose digits or divide by zero.
struct Locus {
    std::string name;  ///< "k = 1/3"
    std::string group; ///< what a report sums up over: "k", "poles"
    /// Moves an ordinary input (one number per component) to this distance from the locus, 0: onto it.
    std::function<void(Random&, double distance, std::span<double> numbers)> place;
};

/// Inputs of parameters that depend on each other.
struct Generator {
    std::string name; ///< also the seed: kernels with one generator run on the same inputs
    std::function<void(Random&, std::span<double> numbers)> draw; ///< an ordinary one
    std::vector<Locus> loci;
};

/// What a result must lie within: a closed interval per component. From 0 to 0 is that zero, from -0 to 0
/// either.
struct Bounds {
    Numbers lower{}, upper{};
};
inline Bounds exactly(const Numbers& answer) { return {answer, answer}; }

/// The distances that every locus is approached by: on it, 1e-1, 1e-2 … 1e-12.
constexpr int locus_distances = 13;
double locus_distance(int step);

/// What a texel of a mask and a point in it say about a kernel's parameters.
struct Facts {
    glm::ivec2 texel{0};
    glm::dvec2 p{0};
    reference::Edge edge;
    const Mask* mask = nullptr; ///< where what lies beyond the texel is looked up; may be null
    bool along_y =
        false; ///< for what exists once per axis (`reach` of one run, its `c`, `heading`): the y axis
};

/// A fact by the name of the parameter that takes it: "texel", "p", "sides", "side_x", "side_y", "reach",
/// "type", "type_x", "type_y", "dominant", "along_x", "along_y", "heading", "c", "entering"; and of slots and
/// bars "neighbours", "neighbour" (the one away from a closed end), "breach". Writes its components and
/// returns how many, 0 if these facts do not hold it (a position along a run that does not end once, a breach
/// of what has no two walls). Null for any other name.
using Fact = int (*)(const Facts&, Numbers&);
Fact find_fact(const std::string& name);

struct Case {
    std::string name;   ///< "smsr/case_09": the file kernels/smsr/case_09.glsl, the function smsr_case_09
    std::string source; ///< document, equation or case
    Reference reference;
    std::vector<Parameter> parameters; ///< as many as the reference takes, in its order
    Result result;
    Tolerance tolerance;
    /// Inputs, one number per word, on which every intermediate result is a float: there the kernel must
    /// answer what the reference says to the last bit, whatever the tolerance; optional. On the border that a
    /// step lies on a tolerance lets either answer pass, and these inputs tell which is right.
    std::function<bool(std::span<const double> numbers)> exact_where;
    /// Inputs that the kernel is defined on, beyond its parameters' domains (they depend on each other);
    /// optional.
    std::function<bool(const Arguments&)> where;
    /// The edges of a mask that lead to this kernel; empty for kernels that run on any.
    Conditions condition;
    /// The number that the decision list of its family gives it; 0 if it is not chosen by one.
    unsigned number = 0;
    /// What it computes, as people write it: "1 + p.x - along_y". For numbered cases; the kernel is the
    /// truth.
    std::string formula;
    /// What it computes, if other kernels compute the same in another way (variants): "integral/a0".
    std::string quantity;
    /// Where its inputs come from, if the parameters' domains alone do not say.
    std::shared_ptr<const Generator> generator;
    /// Whether it answers every input within its result's range. A formula as printed may be left bare:
    /// outside its domain it may then give anything.
    bool defended = true;
    /// Why this kernel must fail its check; empty for those that must pass.
    std::string fails;
    /// How it answers what no caller should ask: NaN, intervals that end before they begin.
    std::string rule;
    /// What the rule asks for at an input outside the domain (one number per word), where that is more than
    /// any number within the result's range; optional.
    std::function<std::optional<Bounds>(std::span<const double> numbers)> outside;
    /// What a result must lie within besides, at an input of the domain with this truth: that a bound holds
    /// what it bounds, which no tolerance says; optional, for references with a truth.
    std::function<Bounds(std::span<const double> numbers, const Truth& truth)> within;
};

/// For exact_where: all are multiples of 2^-22, so that among numbers of magnitude 1 sums of a few stay
/// exact.
bool on_grid(std::span<const double> numbers);

inline bool applies(const Case& c, const reference::Edge& edge) {
    return c.condition.empty() || holds(c.condition, edge);
}

/// "smsr_case_09".
std::string function_name(const Case& c);

/// "float smsr_case_09(vec2 p, float along_x)".
std::string signature(const Case& c);

/// "0 to 1", "one of 1 | 2".
std::string to_string(const Domain& domain);

/// The comment that a kernel's text begins with, without its slashes; its lines end in '\n'.
std::string leading_comment(const std::string& text);

/// The words of a record without the mask's.
inline std::size_t word_count(const Case& c) { return c.reference.words.size(); }

/// Where the words of the parameter `texel` begin; the number of words if there is none.
std::size_t texel_word(const Case& c);

/// Column names of a CSV file: `mask`, `outside` if the kernel takes a mask, then `along_x`, `p_x`, `p_y`, …
std::vector<std::string> columns(const Case& c);

/// Whether the arguments lie in every parameter's domain and satisfy `where`. Of a reference with a truth,
/// denormal inputs are outside: a device may take them for 0.
bool in_domain(const Case& c, const Arguments& arguments);

/// Words are what the device sees: floats as their bits.
inline double widen(Scalar scalar, std::uint32_t word) {
    switch (scalar) {
    case Scalar::float32:
        return static_cast<double>(std::bit_cast<float>(word));
    case Scalar::int32:
        return static_cast<double>(std::bit_cast<std::int32_t>(word));
    case Scalar::boolean:
    case Scalar::uint32:
        break;
    }
    return static_cast<double>(word);
}
inline std::uint32_t narrow(Scalar scalar, double number) {
    switch (scalar) {
    case Scalar::float32:
        return std::bit_cast<std::uint32_t>(static_cast<float>(number));
    case Scalar::int32:
        return std::bit_cast<std::uint32_t>(static_cast<std::int32_t>(number));
    case Scalar::boolean:
        return number != 0 ? 1u : 0u;
    case Scalar::uint32:
        break;
    }
    return static_cast<std::uint32_t>(number);
}
inline Arguments arguments(const Case& c, std::span<const std::uint32_t> words, const Mask* mask) {
    Arguments result; // not zeroed: this is the inner loop of every check
    result.mask = mask;
    for (std::size_t i = 0; i < c.reference.words.size(); ++i)
        result.numbers[i] = widen(c.reference.words[i], words[i]);
    return result;
}

// ---------------------------------------------------------------------------------------------------------------------

namespace detail {

template <typename T>
struct Glsl; // the GLSL type of a C++ one, and the way to and from doubles

template <typename T, Scalar S>
struct GlslScalar {
    static constexpr Type type{S, 1};
    static T get(const double* numbers) { return static_cast<T>(numbers[0]); }
    static void put(T value, Numbers& numbers) { numbers[0] = static_cast<double>(value); }
};
template <>
struct Glsl<double> : GlslScalar<double, Scalar::float32> {};
template <>
struct Glsl<int> : GlslScalar<int, Scalar::int32> {};
template <>
struct Glsl<unsigned> : GlslScalar<unsigned, Scalar::uint32> {};
template <>
struct Glsl<bool> : GlslScalar<bool, Scalar::boolean> {};
template <int N, typename T>
struct Glsl<glm::vec<N, T, glm::defaultp>> {
    static constexpr Type type{Glsl<T>::type.scalar, N};
    static glm::vec<N, T, glm::defaultp> get(const double* numbers) {
        glm::vec<N, T, glm::defaultp> value;
        for (int i = 0; i < N; ++i) value[i] = static_cast<T>(numbers[i]);
        return value;
    }
    static void put(const glm::vec<N, T, glm::defaultp>& value, Numbers& numbers) {
        for (int i = 0; i < N; ++i) numbers[static_cast<std::size_t>(i)] = static_cast<double>(value[i]);
    }
};

template <typename T>
using Plain = std::remove_cvref_t<T>;

/// Reads the next parameter and steps over its components.
template <typename T>
Plain<T> next(const double*& numbers) {
    const Plain<T> value = Glsl<Plain<T>>::get(numbers);
    numbers += Glsl<Plain<T>>::type.components;
    return value;
}

/// `function` has the signature of the pointer; a lambda is called as what it is, so that it can be inlined.
template <typename Function, typename R, typename... A>
void make(Reference& reference, Function function, R (*)(A...)) {
    reference.result = Glsl<R>::type;
    reference.parameters = {Glsl<Plain<A>>::type...};
    reference.call = [function](const Arguments& arguments) {
        const double* numbers = arguments.numbers.data();
        std::tuple<Plain<A>...> values{next<A>(numbers)...}; // braces: evaluated left to right
        Numbers result{};
        Glsl<R>::put(std::apply(function, std::move(values)), result);
        return result;
    };
}

template <typename Function, typename R, typename... A>
void make(Reference& reference, Function function, R (*)(const Mask&, A...)) {
    reference.result = Glsl<R>::type;
    reference.parameters = {Glsl<Plain<A>>::type...};
    reference.takes_mask = true;
    reference.call = [function](const Arguments& arguments) {
        const double* numbers = arguments.numbers.data();
        std::tuple<Plain<A>...> values{next<A>(numbers)...};
        Numbers result{};
        Glsl<R>::put(
            std::apply([&](auto&&... a) { return function(*arguments.mask, a...); }, std::move(values)),
            result);
        return result;
    };
}

template <typename R, typename... A>
Reference by_truth(std::type_identity<R(A...)>, Truth (*truth)(const Arguments&)) {
    Reference reference;
    reference.result = Glsl<R>::type;
    reference.parameters = {Glsl<Plain<A>>::type...};
    for (const Type& type : reference.parameters)
        reference.words.insert(reference.words.end(), static_cast<std::size_t>(type.components), type.scalar);
    reference.truth = truth;
    reference.call = [truth](const Arguments& arguments) { return truth(arguments).value; };
    return reference;
}

} // namespace detail

template <typename Signature>
Reference reference_by(Truth (*truth)(const Arguments&)) {
    return detail::by_truth(std::type_identity<Signature>{}, truth);
}

template <typename Function>
Reference::Reference(Function function) {
    detail::make(*this, function, +function);
    for (const Type& type : parameters)
        words.insert(words.end(), static_cast<std::size_t>(type.components), type.scalar);
}

} // namespace gnomon
