// The classifiers, one file each; techniques.cpp lists them.
#pragma once

#include "runtime/hybrid/classifier.h"

namespace gnomon {

std::unique_ptr<Classifier> make_sheet(Resources& resources); // sound.cpp
std::unique_ptr<Classifier> make_nearest(Resources& resources);
std::unique_ptr<Classifier> make_lists(Resources& resources);
std::unique_ptr<Classifier> make_nothing(Resources& resources);  // nothing.cpp
std::unique_ptr<Classifier> make_beister(Resources& resources);  // beister.cpp
std::unique_ptr<Classifier> make_bilinear(Resources& resources); // beister.cpp
std::unique_ptr<Classifier> make_crsm(Resources& resources);     // crsm.cpp

} // namespace gnomon
