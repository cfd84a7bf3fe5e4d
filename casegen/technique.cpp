#include "casegen/technique.h"

namespace gnomon {

Technique technique_of(const Family& family) {
    return {Technique::Kind::kernel, technique_name(family), family.name};
}

Technique technique_of(const Family& family, const Assembly& assembly) {
    Technique technique = technique_of(family);
    technique.generated[family.name + "/cases"] = assembled(family, assembly);
    return technique;
}

} // namespace gnomon
