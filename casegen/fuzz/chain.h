// What a campaign examines besides single kernels: chains of them, from a mask to the light at a point and
// from a scene to the pixels that a hybrid technique is certain of. What is wrong with an input no reference
// says but invariants do; a failure is the name of the invariant that it breaks.
#pragma once

#include "casegen/fuzz/failure.h"
#include "casegen/fuzz/shrink.h"
#include "runtime/glsl/compiler.h"
#include "runtime/gpu/device.h"

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace gnomon::fuzz {

/// Per input the invariant that it breaks, in words; empty if none. Throws CompileError, KernelTimeout.
using Judge = std::function<std::vector<std::string>(std::span<const Input>)>;

struct Chain {
    /// Its name ("chain/smsr", "scene/sheet"), and its inputs as if it were a kernel; no file holds it.
    Case described;
    std::vector<std::string> invariants; ///< one line each
    std::size_t batch = 0, batches = 0;  ///< inputs that are judged together; such batches in a unit
    /// Inputs `first` to `first` + `count` of a seed. Empty for chains over masks: those are drawn as a
    /// kernel's.
    std::function<std::vector<Input>(std::uint64_t seed, std::uint64_t first, std::size_t count)> draw{};
    /// Compiles what it needs when it is first asked.
    std::function<Judge(const glsl::Sources&, gpu::Device&)> judge;
    std::function<Input(const Input&, const StillFails&)> shrink;
    /// "chain/smsr(texel = …) on a mask of 3 x 3"; "scene/sheet on 2 triangles, …".
    std::function<std::string(const Input&)> format;
};

/// All of them, chains over masks first.
const std::vector<Chain>& chains();

/// The chain that `c` describes; null for a kernel.
const Chain* find_chain(const Case& c);

/// A kernel or a chain by its whole name; null if there is none.
const Case* find_subject(const std::string& name);

/// Kernels, then chains, that `patterns` name (see pattern.h). Throws Error as split_patterns, and one
/// that suggests near names of kernels if a pattern names nothing.
std::vector<const Case*> find_subjects(const std::string& patterns);
/// The same of chains alone; none is no error.
std::vector<const Case*> find_chains(const std::string& patterns);

/// The call, or what a chain was asked.
std::string format_input(const Case& c, const Input& input);

} // namespace gnomon::fuzz
