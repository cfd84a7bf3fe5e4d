// A technique of the pipeline with another assembly of its family's cases.
#pragma once

#include "casegen/catalogue.h"
#include "runtime/pipeline/technique.h"

namespace gnomon {

/// The kernels of the family, with all its cases.
Technique technique_of(const Family& family);

/// The same with its cases put together in another way.
Technique technique_of(const Family& family, const Assembly& assembly);

} // namespace gnomon
