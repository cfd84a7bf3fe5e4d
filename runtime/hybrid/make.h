// The classifiers, one file each; techniques.cpp lists them.
#pragma once

#include "runtime/hybrid/classifier.h"

namespace gnomon {

// sound.cpp
std::unique_ptr<Classifier> make_sheet(Resources& resources);
std::unique_ptr<Classifier> make_nearest(Resources& resources);
std::unique_ptr<Classifier> make_lists(Resources& resources);
// nothing.cpp
std::unique_ptr<Classifier> make_nothing(Resources& resources);
// beister.cpp
std::unique_ptr<Classifier> make_beister(Resources& resources);
std::unique_ptr<Classifier> make_bilinear(Resources& resources);
// crsm.cpp
std::unique_ptr<Classifier> make_crsm(Resources& resources);
std::unique_ptr<Classifier> make_crsma(Resources& resources);
std::unique_ptr<Classifier> make_crsma_one_ring(Resources& resources);

} // namespace gnomon
