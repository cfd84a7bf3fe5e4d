// Two kernels examined on one device: run, judged, set against each other, drawn and timed. What it does may
// hang or crash with the driver: it lives in a child process.
#pragma once

#include "casegen/csv.h"
#include "casegen/versus/picture.h"
#include "casegen/versus/report.h"
#include "casegen/versus/side.h"

#include <array>
#include <filesystem>
#include <memory>
#include <optional>

namespace gnomon::versus {

struct ExaminerOptions {
    std::filesystem::path pins, worst, regressions; ///< folders: see CheckOptions
    std::optional<std::size_t> samples;             ///< default: as check
    std::optional<std::uint64_t> seed;              ///< default: as check
    measure::PairingOptions timing;
    std::optional<std::array<Axis, 2>> axes; ///< of the picture; default: telling_axes
    PictureSize size;
    std::optional<CsvInput> at; ///< what stands still in the picture; default: the worst difference
    gpu::DeviceOptions device;
};

/// The kernel that each side contributes: one and the same, or two with the same parameters and result.
struct Pair {
    const Case *a = nullptr, *b = nullptr;
};

/// Whether the two take the same parameters and give the same kind of result.
bool share_signature(const Case& a, const Case& b);

class Examiner {
public:
    Examiner(const Side& a, const Side& b, const ExaminerOptions& options);
    ~Examiner();

    /// Whether both compile to the same words but for names. Throws CompileError.
    bool is_same_code(const Pair& pair);

    /// Side 0 is A. Throws KernelTimeout, after which this object is of no more use; a kernel that does not
    /// compile is a report.
    SideReport run(const Pair& pair, int side);

    /// Of two sides that were run last, for this pair.
    DifferenceReport difference(const Pair& pair);
    /// Throws KernelTimeout.
    PictureReport draw(const Pair& pair);
    measure::Pairing time(const Pair& pair);

private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

} // namespace gnomon::versus
